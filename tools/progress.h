// How far a run is, on stderr: a bar with rate and time left on a terminal, or one JSON object per
// line for programs.
#pragma once

#include <functional>
#include <string>

#include "core/session.h"
#include "tools/verb.h"

namespace wander {

// Leaves the line clean when it goes out of scope.
class Progress {
 public:
  explicit Progress(const Global& global);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Empty when nothing is to be shown; valid as long as this object lives.
  std::function<void(const ProgressReport&)> reporter();
  // A line for people; the bar goes on below it.
  void say(const std::string& line);

 private:
  enum class Display { none, bar, json };
  static Display display_for(const Global& global);

  Display display_;
  double last_drawn_ = -1;  // seconds of the run
};

// "[#####.....]  50 %  sampling  1.2 M/s  3 s left"
std::string bar_of(const ProgressReport& report);
// {"phase":"sampling","fraction":0.5,"samples":5000,"seconds":1.0,"samples_per_second":5000.0}
std::string json_line_of(const ProgressReport& report);

}  // namespace wander
