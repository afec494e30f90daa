// A run of chains that counts what it is asked for, and does nothing else.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>

#include "lab/drive.h"

namespace wander::test {

class CountingRun : public LiveRun {
 public:
  static constexpr std::uint64_t slices = 64, samples_per_stride = 4;

  CountingRun(std::uint64_t rays_per_sample, double share)
      : rays_per_sample_(rays_per_sample), share_(share) {}

  bool takes_seeds() const override { return !is_started_; }
  double seed_share() const override { return share_; }
  SeedPass seeds() const override {
    const double error = 10 / std::sqrt(static_cast<double>(seeds_ + 1));
    return {slices, seeds_, seeds_ * rays_per_sample_, true, error};
  }
  void seed(std::uint64_t of_each) override { seeds_ += slices * of_each; }
  std::uint64_t seed_stride() const override { return samples_per_stride; }
  void start(int chains) override {
    is_started_ = true;
    chains_ = chains;
  }
  int chains() const { return chains_; }  // of each group, once they are started
  void advance(std::uint64_t samples) override { samples_ += samples; }
  std::uint64_t samples() const override { return samples_; }
  std::uint64_t stride() const override { return 1 << 16; }
  std::uint64_t first_look() const override { return 1 << 16; }
  FilmEstimate preview() const override { return {}; }
  Rendering findings() const override {
    Rendering r;
    r.samples = samples_;
    r.film.value = {1};
    r.film.standard_error = {0};
    r.film.reliable = {true};
    return r;
  }
  std::unique_ptr<Findings> no_findings() const override { return {}; }
  void add_to(Findings&) const override {}
  void save(cereal::BinaryOutputArchive&) const override {}
  void load(cereal::BinaryInputArchive&) override {}

 private:
  std::uint64_t rays_per_sample_;
  double share_;
  bool is_started_ = false;
  int chains_ = 0;
  std::uint64_t seeds_ = 0, samples_ = 0;
};

}  // namespace wander::test
