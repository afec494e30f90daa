#include "lab/fluence.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/batch_picture.h"
#include "core/film_statistics.h"
#include "core/light_walks.h"
#include "core/transport.h"
#include "scenes/format/build_scene.h"
#include "work/parallel.h"
#include "work/stopping_rule.h"

namespace wander {

namespace {

using Point = PlaneGrid::Point;

struct Bounds {
  Point low, high;

  void include(Point p, double radius) {
    low = glm::min(low, p - radius);
    high = glm::max(high, p + radius);
  }
  void operator()(const description::Segment& s) {
    for (const auto& p : {s.from, s.to}) include({p[0], p[1]}, 0);
  }
  void operator()(const description::Arc& s) { include({s.center[0], s.center[1]}, s.radius); }
};

// Light that leaves the scene is seen up to the edge of the grid: a black frame far around both
// ends every ray, and changes nothing else.
description::Scene enclosed(description::Scene scene, const PlaneGrid& grid) {
  Bounds bounds{grid.low(), grid.high()};
  for (const auto& shape : scene.shapes)
    for (const auto& stroke : outline_of(shape.kind)) std::visit(bounds, stroke);
  const Point margin = 0.25 * (bounds.high - bounds.low);
  const Point low = bounds.low - margin, high = bounds.high + margin;
  description::Shape frame;
  frame.kind = description::Polyline{
      {{low.x, low.y, 0}, {high.x, low.y, 0}, {high.x, high.y, 0}, {low.x, high.y, 0}}, true};
  scene.shapes.push_back(frame);
  return scene;
}

// One walk from the lights at a time.
class LightTracer {
 public:
  LightTracer(const Scene<Flatland>& scene, const PlaneGrid& grid)
      : transport_(scene, Roulette::by_albedo), grid_(&grid), walk_(scene.max_vertices()) {
    walk_.resize(scene.max_vertices());
  }

  void walk(BatchRandom& random, BatchDeposit& deposit) {
    transport_.begin_light(walk_, 0, random);
    double flux = 1;
    for (int i = 0; i + 1 < transport_.max_vertices(); ++i) {
      random.seek({Subpath::light, i + 1});
      const double survival = transport_.survival(walk_[i]), u = random.uniform();
      if (!(u < survival)) return;
      if (!transport_.extend(walk_, i, Toward::sensor, random)) return;
      transport_.evaluate(walk_, i);
      const Vertex<Flatland>& v = walk_[i];
      if (i == 0) flux /= v.from_light;
      flux *= v.value * v.geometry / walk_[i + 1].from_light;
      if (!(flux > 0) || !std::isfinite(flux)) return;
      std::vector<double>& cells = deposit.of_length(i + 2);
      grid_->cross(v.place.position, walk_[i + 1].place.position,
                   [&](std::size_t cell, double length) { cells[cell] += flux * length; });
    }
  }

 private:
  Transport<Flatland> transport_;
  const PlaneGrid* grid_;
  Path<Flatland> walk_;
};

// How many walks make a batch, and how many there may be.
struct Plan {
  std::uint64_t walks = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t per_batch = 1 << 14;
  double seconds = std::numeric_limits<double>::infinity(), error = 0;

  explicit Plan(const Budget& budget) {
    if (const auto* count = std::get_if<SampleBudget>(&budget)) {
      walks = count->samples;
      per_batch = std::clamp<std::uint64_t>(std::bit_floor(walks / 48), 1, per_batch);
    }
    // On a slow machine a short time is still enough for some batches.
    if (const auto* time = std::get_if<TimeBudget>(&budget)) {
      seconds = time->seconds;
      per_batch = std::bit_floor(
          static_cast<std::uint64_t>(std::clamp(seconds * (1 << 12), 64.0, double(1 << 14))));
    }
    if (const auto* target = std::get_if<ErrorBudget>(&budget)) error = target->relative;
  }
  std::uint64_t batches() const { return (walks - 1) / per_batch + 1; }
  std::uint64_t size_of(std::uint64_t batch) const {
    return std::min(per_batch, walks - batch * per_batch);
  }
};

// What one batch works in.
struct Slot {
  LightTracer tracer;
  BatchRandom random;
  BatchDeposit deposit;
};

class Picture {
 public:
  Picture(const Scene<Flatland>& scene, const PlaneGrid& grid, const Session& session)
      : grid_(grid),
        run_(session),
        plan_(session.budget),
        points_(plan_.per_batch),
        sum_(grid.size(), scene.max_vertices()) {
    for (int i = 0; i < slots_of(run_); ++i)
      slots_.push_back({LightTracer(scene, grid), BatchRandom(points_, session.seed),
                        BatchDeposit(grid.size(), scene.max_vertices())});
  }

  Rendering make() {
    std::uint64_t done = 0, goal = plan_.error > 0 ? first_look : plan_.batches();
    run_batches(done, goal);
    for (done = goal; !is_enough(); done = goal) run_batches(done, goal = 2 * goal);
    Rendering rendering{.method = "fluence",
                        .samples = sum_.samples(),
                        .seed = run_.session().seed,
                        .threads = run_.threads(),
                        .seconds = run_.seconds(),
                        .film = estimate()};
    const bool is_counted = std::holds_alternative<SampleBudget>(run_.session().budget);
    rendering.complete = is_counted ? sum_.samples() == plan_.walks : !run_.is_interrupted();
    return rendering;
  }

 private:
  static constexpr std::uint64_t first_look = 16;  // batches, for a budget of error

  FilmEstimate estimate() const {
    return sum_.estimate({grid_.rows(), grid_.columns()}, 1 / grid_.cell_area());
  }
  bool is_enough() const {
    if (!(plan_.error > 0) || run_.is_interrupted()) return true;
    const double error = relative_error(estimate());
    return error <= plan_.error || (!std::isfinite(error) && sum_.samples() >= samples_in_the_dark);
  }

  void run_batches(std::uint64_t first, std::uint64_t end) {
    const auto more = [&](std::uint64_t unit) {
      return !run_.is_interrupted() && (first + unit == 0 || run_.seconds() < plan_.seconds);
    };
    const auto work = [&](std::uint64_t unit, int index) {
      const std::uint64_t batch = first + unit;
      Slot& slot = slots_[static_cast<std::size_t>(index)];
      slot.deposit.clear();
      slot.random.start_batch(batch);
      for (std::uint64_t k = 0; k < plan_.size_of(batch); ++k) {
        slot.random.start_walk(k, batch * plan_.per_batch + k);
        slot.tracer.walk(slot.random, slot.deposit);
      }
    };
    const auto merge = [&](std::uint64_t unit, int index) {
      sum_.add(slots_[static_cast<std::size_t>(index)].deposit, plan_.size_of(first + unit));
      const double of_walks =
          static_cast<double>(sum_.samples()) / static_cast<double>(plan_.walks);
      run_.report({std::max(of_walks, run_.seconds() / plan_.seconds), sum_.samples(),
                   run_.seconds(), "sampling"});
    };
    run_in_order(run_, {end - first, more, work, merge});
  }

  const PlaneGrid& grid_;
  Run run_;
  Plan plan_;
  EvenPoints points_;
  BatchPicture sum_;
  std::vector<Slot> slots_;
};

}  // namespace

Rendering estimate_fluence(const description::Scene& scene, const PlaneGrid& grid,
                           const Session& session) {
  const auto built = build_flatland(enclosed(scene, grid));
  return Picture(*built, grid, session).make();
}

}  // namespace wander
