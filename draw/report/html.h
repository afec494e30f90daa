// A writer of HTML that is also well-formed XML, so that any parser reads it: every element is
// closed, every text escaped.
#pragma once

#include <string>
#include <string_view>

#include "draw/figure/svg.h"

namespace wander::report {

class Html {
 public:
  // An element that stays open, and takes what is written, for as long as the result lives.
  class [[nodiscard]] Scope {
   public:
    Scope(Html& html, std::string_view tag) : html_(html), tag_(tag) {}
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    ~Scope() { html_.out_ += "</" + tag_ + ">\n"; }

   private:
    Html& html_;
    std::string tag_;
  };
  Scope open(std::string_view tag, figure::Attributes attributes = {});

  // An element that holds nothing but this text.
  void element(std::string_view tag, std::string_view text, figure::Attributes attributes = {});
  // Well-formed markup, as it is.
  void markup(std::string_view markup) { out_ += markup; }

  // A number for each thing that needs an id of its own: 1, 2, 3, …
  int next_number() { return ++numbered_; }

  std::string finish() && { return std::move(out_); }

 private:
  void begin(std::string_view tag, figure::Attributes attributes);

  std::string out_;
  int numbered_ = 0;
};

}  // namespace wander::report
