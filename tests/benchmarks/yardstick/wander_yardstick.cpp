// The default mixture of the plane beside a kernel written by hand for diffuse segments alone
// (plane_kernel.h): nanoseconds per mutation of both, measured by turns, and their ratio.  First it is
// shown that both make the same chain: acceptance of each mutation, and the film.  See
// docs/benchmarks.md.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <string>

#include "mlt/seeds/seed_pass.h"
#include "mutations/catalogue.h"
#include "tests/benchmarks/bench_scene.h"
#include "tests/benchmarks/workers.h"
#include "tests/benchmarks/yardstick/plane_kernel.h"
#include "work/clock.h"

namespace wander {

namespace {

constexpr int chains = 32, steps_per_turn = 4096, turns = 48;

double cpu_seconds() { return system_clock().now().processor; }

// What one chain has done: its film, and of each mutation how often and with which acceptance.
struct Record {
  std::vector<double> film;
  std::array<double, PlaneKernel::mutations> proposed{}, acceptance{};

  explicit Record(int bins) : film(static_cast<std::size_t>(bins)) {}
  void add(int mutation, double a, int from, int to) {
    film[static_cast<std::size_t>(from)] += 1 - a;
    if (a > 0) film[static_cast<std::size_t>(to)] += a;
    proposed[static_cast<std::size_t>(mutation)] += 1;
    acceptance[static_cast<std::size_t>(mutation)] += a;
  }
};

class KernelChain {
 public:
  KernelChain(const PlaneKernel& kernel, const Path<Flatland>& seed, int bins, std::uint32_t stream)
      : kernel_(&kernel),
        x_(kernel.start(seed)),
        record_(bins),
        random_(2, Purpose::chain, stream) {}

  void take_turn() {
    Path *x = &x_, *y = &y_;
    for (int i = 0; i < steps_per_turn; ++i) {
      random_.start(steps_++);
      const PlaneKernel::Outcome outcome = kernel_->step(*x, *y, random_);
      record_.add(outcome.mutation, outcome.acceptance, x->bin, y->bin);
      if (outcome.accepted) std::swap(x, y);
    }
    if (x != &x_) x_ = *x;
  }
  const Record& record() const { return record_; }

 private:
  using Path = PlaneKernel::Path;
  const PlaneKernel* kernel_;
  Path x_, y_;
  Record record_;
  Rng random_;
  std::uint64_t steps_ = 0;
};

// Two-sided p value of a difference between the means of two sets of chains, in `z`.
struct Comparison {
  double largest = 0, squares = 0;
  int count = 0;

  template <class Value>
  void add(const std::vector<Record>& a, const std::vector<Record>& b, Value value) {
    const auto [mean_a, variance_a] = moments(a, value);
    const auto [mean_b, variance_b] = moments(b, value);
    if (!(variance_a + variance_b > 0)) return;
    const double z = (mean_a - mean_b) / std::sqrt(variance_a + variance_b);
    largest = std::max(largest, std::abs(z));
    squares += z * z;
    ++count;
  }

 private:
  // The mean over chains, and its variance.
  template <class Value>
  static std::pair<double, double> moments(const std::vector<Record>& records, Value value) {
    double sum = 0, squares = 0;
    const auto n = static_cast<double>(records.size());
    for (const Record& r : records) sum += value(r);
    for (const Record& r : records) squares += std::pow(value(r) - sum / n, 2);
    return {sum / n, squares / (n * (n - 1))};
  }
};

struct Both {
  std::vector<Record> kernel, generic;
  std::vector<double> kernel_ns, generic_ns;
};

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

class Yardstick {
 public:
  explicit Yardstick(const std::string& name)
      : name_(name), scene_(bench_scene<Flatland>(name)), transport_(*scene_, Roulette::off) {
    SeedSlice<Transport<Flatland>> slice(transport_, 1, 0, chains);
    slice.run(1 << 14);
    FamilySettings settings;
    settings.weights = {{"bidirectional", 0.5, {}}, {"lens", 1, {}}, {"primary", 1.5, {}}};
    family_ = std::make_unique<Family>(make_family(settings, scene_->max_vertices()));
    family_->learn(slice.tally());
    kernel_ = std::make_unique<PlaneKernel>(*scene_, slice.tally());
    for (int k = 0; k < chains; ++k) {
      const auto stream = static_cast<std::uint32_t>(k);
      const auto seed = slice.replay(slice.seed(k), scene_->max_vertices());
      by_hand_.emplace_back(*kernel_, seed, scene_->bins(), stream);
      generic_.push_back(
          std::make_unique<ChainWorker<Flatland>>(transport_, *family_, seed, stream));
    }
  }

  // Both by turns.
  void run() {
    for (int turn = 0; turn < turns; ++turn)
      for (int k = 0; k < chains; ++k) {
        const double start = cpu_seconds();
        by_hand_[static_cast<std::size_t>(k)].take_turn();
        const double middle = cpu_seconds();
        for (int i = 0; i < steps_per_turn; i += ChainWorker<Flatland>::items_per_turn)
          generic_[static_cast<std::size_t>(k)]->take_turn();
        const double end = cpu_seconds();
        hand_ns_.push_back((middle - start) * 1e9 / steps_per_turn);
        generic_ns_.push_back((end - middle) * 1e9 / steps_per_turn);
      }
  }

  // Does the kernel do what the text does?
  bool report() const {
    std::vector<Record> hand, text;
    for (const KernelChain& chain : by_hand_) hand.push_back(chain.record());
    for (const auto& worker : generic_) text.push_back(record_of(*worker));
    Comparison films, acceptances;
    for (std::size_t bin = 0; bin < hand[0].film.size(); ++bin)
      films.add(hand, text, [bin](const Record& r) { return r.film[bin]; });
    fmt::print("{}\n", name_);
    for (std::size_t m = 0; m < PlaneKernel::mutations; ++m) {
      const auto mean = [m](const Record& r) { return r.acceptance[m] / r.proposed[m]; };
      acceptances.add(hand, text, mean);
      double sums[2] = {0, 0};
      for (int k = 0; k < chains; ++k) {
        sums[0] += mean(hand[static_cast<std::size_t>(k)]) / chains;
        sums[1] += mean(text[static_cast<std::size_t>(k)]) / chains;
      }
      fmt::print("  {:<14} acceptance {:.4f} by hand, {:.4f}\n", names[m], sums[0], sums[1]);
    }
    // One false alarm in 10^4 runs: 4 acceptances and some hundred bins, of 31 + 31 degrees of freedom.
    const bool same = films.largest < 5.5 && acceptances.largest < 4.6;
    fmt::print(
        "  film {} bins, largest |z| {:.2f}, mean z² {:.2f}; acceptances, largest |z| {:.2f}: {}\n",
        films.count, films.largest, films.squares / films.count, acceptances.largest,
        same ? "the same chain" : "NOT the same chain");
    const double by_hand = median(hand_ns_), generic = median(generic_ns_);
    std::vector<double> ratios;
    for (std::size_t i = 0; i < hand_ns_.size(); ++i)
      ratios.push_back(generic_ns_[i] / hand_ns_[i]);
    fmt::print("  ns per mutation: {:.0f} by hand, {:.0f}; ratio {:.2f}\n", by_hand, generic,
               median(ratios));
    return same;
  }

 private:
  static constexpr std::array names{"bidirectional", "lens", "primary_small", "primary_large"};

  Record record_of(const ChainWorker<Flatland>& worker) const {
    Record record(scene_->bins());
    record.film = worker.film().weights();
    for (const MutationRecord& mutation : worker.statistics().records())
      for (std::size_t m = 0; m < names.size(); ++m)
        if (mutation.name == names[m]) {
          record.proposed[m] = static_cast<double>(mutation.proposed);
          record.acceptance[m] = mutation.mean_acceptance * record.proposed[m];
        }
    return record;
  }

  std::string name_;
  std::unique_ptr<Scene<Flatland>> scene_;
  Transport<Flatland> transport_;
  std::unique_ptr<Family> family_;
  std::unique_ptr<PlaneKernel> kernel_;
  std::vector<KernelChain> by_hand_;
  std::vector<std::unique_ptr<ChainWorker<Flatland>>> generic_;
  std::vector<double> hand_ns_, generic_ns_;
};

}  // namespace

}  // namespace wander

int main() {
  bool same = true;
  for (const char* name : {"slit", "article-3"}) {
    wander::Yardstick yardstick(name);
    yardstick.run();
    same = yardstick.report() && same;
  }
  return same ? 0 : 1;
}
