#include "draw/figure/autocorrelation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "draw/figure/axis.h"
#include "draw/figure/style.h"
#include "mlt/watch/diagnostics.h"
#include "statistics/number_text.h"

namespace wander::figure {
namespace {

constexpr double panel_height = 92, panel_gap = 16, header = 12;
// For half of the last label of an axis.
constexpr double right_room = 8;
// Side by side where each has this much room, otherwise one below the other.
constexpr double least_panel_width = 90;
constexpr int most_lags = 200;
constexpr double thin = 0.35, thick = 1.3;

struct Functional {
  std::string_view name;
  std::function<double(const Trajectory&, std::size_t)> value;
};

std::vector<Functional> functionals_of(const Trajectory& trajectory) {
  const auto axis = [](std::size_t k) {
    return [k](const Trajectory& t, std::size_t i) {
      return t.state.film[i * static_cast<std::size_t>(t.dimension - 1) + k];
    };
  };
  std::vector<Functional> all;
  if (trajectory.dimension == 2)
    all = {{"position on the sensor", axis(0)}};
  else
    all = {{"x on the film", axis(0)}, {"y on the film", axis(1)}};
  all.push_back({"log f", [](const Trajectory& t, std::size_t i) { return t.log_f[i]; }});
  all.push_back({"number of vertices", [](const Trajectory& t, std::size_t i) {
                   return static_cast<double>(t.state.vertices[i]);
                 }});
  return all;
}

struct Curves {
  std::string_view name;
  std::vector<std::vector<double>> chains{};
  std::vector<double> together{};
  std::size_t constant = 0;  // chains that do not
  double time = 0;           // integrated autocorrelation time, in steps; NaN if it cannot be told
};

Curves curves_of(const Steps& steps, const Functional& functional, int lags) {
  Curves curves{.name = functional.name};
  Draws draws{steps.chains().size(), static_cast<std::size_t>(steps.draws()), {}};
  std::vector<double> x(static_cast<std::size_t>(steps.draws()));
  for (const int chain : steps.chains()) {
    for (int draw = 0; draw < steps.draws(); ++draw)
      x[static_cast<std::size_t>(draw)] =
          functional.value(steps.trajectory(), steps.index(chain, steps.first() + draw));
    draws.values.insert(draws.values.end(), x.begin(), x.end());
    std::vector<double> rho = autocorrelation(x, lags);
    if (rho.empty()) {
      ++curves.constant;
      continue;
    }
    curves.chains.push_back(std::move(rho));
  }
  curves.together = combined_autocorrelation(draws, static_cast<std::size_t>(lags));
  curves.time = autocorrelation_time(draws) * static_cast<double>(steps.trajectory().every);
  return curves;
}

double lowest(const std::vector<Curves>& all) {
  double low = -0.2;
  for (const Curves& curves : all) {
    for (const auto& chain : curves.chains) low = std::min(low, *std::ranges::min_element(chain));
    for (const double rho : curves.together) low = std::min(low, rho);
  }
  return low;
}

void draw_curve(Svg& svg, const std::vector<double>& rho, const LinearScale& x,
                const LinearScale& y, std::string_view kind, double width,
                std::string_view colour) {
  std::string data;
  for (std::size_t k = 0; k < rho.size(); ++k)
    data += (k == 0 ? "M" : "L") + coordinates({x(static_cast<double>(k)), y(rho[k])});
  svg.path(data, {{"class", kind},
                  {"stroke", colour},
                  {"stroke-width", width},
                  {"stroke-linejoin", "round"},
                  {"fill", "none"}});
}

std::string title(const Curves& curves) {
  // Chains that stay where they began tell their record's length at most.
  if (curves.chains.empty() || !std::isfinite(curves.time)) return std::string(curves.name);
  return fmt::format("{}, τ {}", curves.name, number_text(curves.time));
}

std::string note(const Curves& curves) {
  if (curves.chains.empty())
    return curves.together.empty() ? "does not change" : "changes in no chain";
  if (curves.constant == 0) return "";
  return fmt::format("{} chain{} without change", curves.constant, curves.constant == 1 ? "" : "s");
}

// For a line of text that ends here, over whatever runs there.
void draw_ground(Svg& svg, Vector end, double text_width) {
  const Vector corner = end - Vector{text_width + 1, style::small_size};
  svg.path("M" + coordinates(corner) + "h" + number(text_width + 2) + "v" +
               number(1.3 * style::small_size) + "h" + number(-text_width - 2) + "Z",
           {{"fill", style::paper}});
}

void draw_panel(Svg& svg, const Curves& curves, const LinearScale& x, const LinearScale& y) {
  const auto scope = svg.group("autocorrelation");
  svg.line({x.page.low, y(0)}, {x.page.high, y(0)},
           {{"stroke", style::neutral.colour}, {"stroke-width", 0.5}});
  for (const auto& chain : curves.chains)
    draw_curve(svg, chain, x, y, "chain", thin, style::accepted.colour);
  if (!curves.together.empty())
    draw_curve(svg, curves.together, x, y, "together", thick, style::ink);
  svg.text({(x.page.low + x.page.high) / 2, y.page.high - 4}, title(curves),
           {.size = style::small_size, .anchor = "middle"});
  if (const std::string text = note(curves); !text.empty()) {
    const Vector end{x.page.high, y.page.high + 8};
    draw_ground(svg, end, text_width(text, style::small_size));
    svg.text(end, text, {.size = style::small_size, .anchor = "end"});
  }
}

Quantity lag_of(const Trajectory& t) {
  return {t.every == 1 ? "lag, steps" : fmt::format("lag, draws of {} steps each", t.every), ""};
}

}  // namespace

std::vector<double> autocorrelation(std::span<const double> x, int lags) {
  const double mean = std::accumulate(x.begin(), x.end(), 0.0) /
                      static_cast<double>(std::max<std::size_t>(1, x.size()));
  std::vector<double> centred;
  double squares = 0, magnitude = 0;
  for (const double value : x) {
    centred.push_back(value - mean);
    squares += centred.back() * centred.back();
    magnitude = std::max(magnitude, std::abs(value));
  }
  // Less than rounding makes of a constant is no movement.
  const double rounding = 1e-14 * magnitude * std::sqrt(static_cast<double>(x.size()));
  if (!std::isfinite(squares) || std::sqrt(squares) <= rounding) return {};
  std::vector<double> rho;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(lags); ++k) {
    double sum = 0;
    for (std::size_t i = 0; i + k < centred.size(); ++i) sum += centred[i] * centred[i + k];
    rho.push_back(sum / squares);
  }
  return rho;
}

Block autocorrelation_chart(const Steps& steps, double width) {
  const int lags = std::clamp(steps.draws() / 4, 1, most_lags);
  std::vector<Curves> all;
  for (const Functional& functional : functionals_of(steps.trajectory()))
    all.push_back(curves_of(steps, functional, lags));
  const Range values{lowest(all), 1};
  const Quantity lag = lag_of(steps.trajectory());
  const double left = left_axis_gap + 16;
  const double room = width - right_room - left;
  const auto width_of = [room](std::size_t columns) {
    return (room - static_cast<double>(columns - 1) * panel_gap) / static_cast<double>(columns);
  };
  const std::size_t columns = width_of(all.size()) >= least_panel_width ? all.size() : 1;
  const double row_height = header + panel_height + bottom_axis_height;
  return {
      fmt::format("Autocorrelation, {}; thin: each chain about its own mean, thick: the halves of "
                  "all chains together, of which τ is the integrated time, in steps",
                  in_words(steps)),
      row_height * static_cast<double>(all.size() / columns), [=](Svg& svg, Vector top_left) {
        const double across = width_of(columns);
        for (std::size_t k = 0; k < all.size(); ++k) {
          const double top = top_left.y + header + row_height * static_cast<double>(k / columns);
          const double bottom = top + panel_height;
          const double begin =
              top_left.x + left + static_cast<double>(k % columns) * (across + panel_gap);
          const Axis y = make_axis({"autocorrelation", ""}, values, {bottom, top}, 6);
          if (k % columns == 0) {
            draw_left_axis(svg, y, begin - 3);
            draw_left_title(svg, y, begin - 3);
          }
          const Axis x = make_axis(lag, {0, static_cast<double>(lags)}, {begin, begin + across}, 5);
          draw_panel(svg, all[k], x.scale, y.scale);
          draw_bottom_axis(svg, x, bottom);
          draw_bottom_title(svg, x, bottom);
        }
      }};
}

}  // namespace wander::figure
