// The way of a rendering, and of all that it is made of, into a binary archive and back: bit for
// bit, with numbers that are not finite, which JSON does not have.
#pragma once

#include <cereal/archives/binary.hpp>
#include <cereal/types/map.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "records/bounded_archive.h"
#include "records/rendering.h"

namespace wander {

template <class Archive>
void serialize(Archive& archive, FilmEstimate& film) {
  archive(film.shape, film.value, film.standard_error, film.reliable, film.degrees_of_freedom,
          film.by_length);
}

template <class Archive>
void serialize(Archive& archive, ClassRecord& path_class) {
  archive(path_class.path_class, path_class.light, path_class.of_samples);
}
template <class Archive>
void serialize(Archive& archive, PoolingRecord& pooling) {
  archive(pooling.how, pooling.samples, pooling.light_of_samples, pooling.film_of_samples,
          pooling.classes);
}

template <class Archive>
void serialize(Archive& archive, NormalizationEstimate& estimate) {
  archive(estimate.value, estimate.standard_error, estimate.samples, estimate.degrees_of_freedom,
          estimate.failure);
}
template <class Archive>
void serialize(Archive& archive, LengthShare& share) {
  archive(share.value, share.standard_error, share.vertices);
}
template <class Archive>
void serialize(Archive& archive, Normalization& b) {
  archive(b.value, b.standard_error, b.method, b.estimates, b.by_length);
}

template <class Archive>
void serialize(Archive& archive, PathsRecord& paths) {
  archive(paths.vertices, paths.path_class, paths.proposed, paths.accepted, paths.mean_acceptance,
          paths.failures);
}
template <class Archive>
void serialize(Archive& archive, MutationRecord& mutation) {
  archive(mutation.name, mutation.proposed, mutation.accepted, mutation.mean_acceptance,
          mutation.failures, mutation.proposed_per_bin, mutation.acceptance_per_bin,
          mutation.seconds, mutation.squared_jump, mutation.longest_rejection_run,
          mutation.by_length, mutation.by_class);
}

template <class Archive>
void serialize(Archive& archive, FunctionalRecord& functional) {
  archive(functional.name, functional.r_hat, functional.ess_bulk, functional.ess_tail,
          functional.autocorrelation_time);
}
template <class Archive>
void serialize(Archive& archive, ChainsRecord& chains) {
  archive(chains.draws, chains.stride, chains.longest_rejection_run, chains.functionals);
}

template <class Archive>
void serialize(Archive& archive, Rendering& r) {
  archive(r.complete, r.method, r.samples, r.seed, r.threads, r.seconds, r.processor_seconds,
          r.seed_seconds, r.precision, r.max_vertices, r.film, r.adaptation, r.pooling,
          r.chains_film, r.normalization, r.chains, r.groups, r.chains_record, r.mutations,
          r.warnings);
}

template <class Value>
std::string archived(const Value& value) {
  std::ostringstream bytes;
  cereal::BinaryOutputArchive archive(bytes);
  archive(value);
  return std::move(bytes).str();
}
// Throws ArchiveError if they are no such value.
template <class Value>
Value from_archive(std::string_view bytes) {
  BoundedArchive archive(bytes);
  Value value;
  archive(value);
  return value;
}

}  // namespace wander
