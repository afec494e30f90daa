// How far a run is, on stderr: a bar with rate and time left on a terminal, a line now and then
// where nobody watches (a pipe, a file), or one JSON object per line for programs.
#pragma once

#include <functional>
#include <string>

#include "tools/verb.h"
#include "work/session.h"

namespace wander {

// When there are lines instead of a bar: one at each new phase, or only in runs that take long.
enum class Lines { of_each_phase, of_long_runs };

// Leaves the line clean when it goes out of scope.
class Progress {
 public:
  explicit Progress(const Global& global);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Empty when nothing is to be shown; valid as long as this object lives.
  std::function<void(const ProgressReport&)> reporter(Lines lines = Lines::of_long_runs);
  // A line for people; the bar goes on below it.
  void say(const std::string& line);

 private:
  enum class Display { none, bar, lines, json };
  static Display display_for(const Global& global);
  void draw_bar(const ProgressReport& report);
  void print_line(const ProgressReport& report, Lines lines);

  Display display_;
  double last_drawn_ = -1;  // seconds of the run
  std::string last_phase_;
};

// " 50 %  sampling  1.2 M/s  3 s left"
std::string line_of(const ProgressReport& report);

// "[#####.....]  50 %  sampling  1.2 M/s  3 s left"
std::string bar_of(const ProgressReport& report);
// {"phase":"sampling","fraction":0.5,"samples":5000,"seconds":1.0,"samples_per_second":5000.0}
std::string json_line_of(const ProgressReport& report);

}  // namespace wander
