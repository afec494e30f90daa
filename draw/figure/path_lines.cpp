#include "draw/figure/path_lines.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

namespace wander::figure {
namespace {

constexpr std::size_t axes = 3;

class Lines {
 public:
  void begin(std::string_view object) {
    object_ = object;
    is_open_ = false;
  }

  // Vertices that are no numbers part lines.
  void add(const std::string& words, std::span<const double> coordinates) {
    std::size_t length = 0;
    bool is_said = false;
    for (std::size_t at = 0; at + axes <= coordinates.size(); at += axes) {
      const auto p = coordinates.subspan(at, axes);
      if (!std::isfinite(p[0] + p[1] + p[2])) {
        end_line(length);
        length = 0;
        continue;
      }
      if (!is_said) say(words);
      is_said = true;
      fmt::format_to(std::back_inserter(text_), "v {} {} {}\n", p[0], p[1], p[2]);
      ++vertices_;
      ++length;
    }
    end_line(length);
  }

  std::string take() { return std::move(text_); }

 private:
  void say(const std::string& words) {
    if (!is_open_) fmt::format_to(std::back_inserter(text_), "o {}\n", object_);
    is_open_ = true;
    fmt::format_to(std::back_inserter(text_), "# {}\n", words);
  }
  // Vertices are counted from 1 through the file.
  void end_line(std::size_t length) {
    if (length < 2) return;
    text_ += "l";
    for (std::size_t k = vertices_ - length + 1; k <= vertices_; ++k)
      fmt::format_to(std::back_inserter(text_), " {}", k);
    text_ += '\n';
  }

  std::string text_ = "# paths of light, from the lamp to the sensor, in metres; y is up\n";
  std::string_view object_;
  bool is_open_ = false;
  std::size_t vertices_ = 0;
};

std::span<const double> path_at(const RecordedPaths& paths, std::size_t index, int max_vertices) {
  const auto room = static_cast<std::size_t>(max_vertices) * axes;
  return std::span(paths.position)
      .subspan(index * room, static_cast<std::size_t>(paths.vertices[index]) * axes);
}

std::string words_of(const Steps& steps, const Step& step) {
  return fmt::format("chain {} step {}: {}, {}, a = {}", step.chain, steps.number(step.draw),
                     steps.mutation(step), steps.accepted(step) ? "accepted" : steps.reason(step),
                     steps.trajectory().acceptance[step.index]);
}

}  // namespace

std::string path_lines(const Steps& steps) {
  const Trajectory& t = steps.trajectory();
  const auto attempt_room = static_cast<std::size_t>(t.attempts.max_points) * axes;
  Lines lines;
  lines.begin("start");
  std::optional<int> chain;
  steps.each([&](const Step& step) {
    if (chain == step.chain) return;
    chain = step.chain;
    if (const auto before = steps.before(step))
      lines.add(fmt::format("chain {} before step {}", step.chain, steps.number(step.draw)),
                path_at(*before->paths, before->index, t.max_vertices));
  });
  for (const bool accepted : {true, false}) {
    lines.begin(accepted ? "accepted" : "rejected");
    steps.each([&](const Step& step) {
      if (steps.accepted(step) == accepted)
        lines.add(words_of(steps, step), path_at(t.proposed, step.index, t.max_vertices));
    });
  }
  lines.begin("failed");
  steps.each([&](const Step& step) {
    if (t.proposed.vertices[step.index] == 0 && attempt_room > 0)
      lines.add(words_of(steps, step),
                std::span(t.attempts.position).subspan(step.index * attempt_room, attempt_room));
  });
  return lines.take();
}

}  // namespace wander::figure
