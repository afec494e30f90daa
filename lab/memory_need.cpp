#include "lab/memory_need.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/film.h"
#include "core/large_sample_film.h"
#include "mlt/run/shared_films.h"
#include "mlt/watch/functionals.h"
#include "mutations/family_settings.h"
#include "statistics/number_text.h"

namespace wander {

namespace {

constexpr double megabyte = 1e6;
constexpr double of_program = 55 * megabyte;
constexpr double not_counted = 1.1;  // what small things and the allocator take, as a factor
constexpr double of_sum = sizeof(Sum), of_double = sizeof(double), of_float = sizeof(float);
// Of a bin of a film as it comes out: value, error, and a flag.
constexpr double of_result = 2 * of_double + 1.0 / 8;

// What all is counted in.
struct Size {
  explicit Size(const Job& job)
      : shape(film_shape(job.scene())),
        max_vertices(job.scene().max_vertices),
        layout(job.dials().film),
        is_large(layout.is_large(shape)),
        bins(static_cast<double>(values_of(shape))),
        cells(static_cast<double>(layout.raster(shape).cells())),
        lengths(layout.keeps_lengths(shape, max_vertices) ? max_vertices - 1 : 0) {
    if (!job.method().is_markov_chain()) return;
    moves = job.method().state == ChainState::path ? count_of_mutations() : 2;
    if (job.dials().chains.film_parts == FilmParts::pooled) alone = is_large ? 2 : 3;
    maps = 2 * moves * static_cast<double>(layout.maps_of(shape).cells());
  }

  bool is_image() const { return pixels_of(shape).size() == 2; }

  std::vector<int> shape;
  int max_vertices;
  FilmLayout layout;
  bool is_large;
  double bins, cells;  // a bin is one channel of a pixel
  double lengths;      // of which films are kept
  double alone = 0;    // numbers of a bin of the film of the chains alone, and what samples carry
  double moves = 0;    // mutations of the chains
  double maps = 0;     // numbers
};

double result_of(const Size& size) {
  return size.bins * (of_result + (size.lengths + size.alone) * of_double);
}

// The planes of the image, and a few of its rows packed and not.
double files_of(const Size& size) {
  const double planes = 3 + size.alone + size.lengths + (size.maps > 0 ? 2 * size.moves : 0);
  const double row = size.shape.size() == 1 ? 1 : 0.1;
  return result_of(size) + size.bins * of_float * planes * (1 + 3 * row);
}

void need_of_samples(MemoryNeed& need, const Size& size, int threads) {
  const double slots = threads + 2;
  if (size.is_large) {
    // The film, and a copy to which a unit is added that is not yet whole.
    need.films = 2 * size.bins * (sizeof(BinSums) + size.lengths * of_double) +
                 slots * 4096 * 24 * size.max_vertices;
  } else {
    need.films = (slots + 3) * size.bins * ((2 + size.lengths) * of_sum + of_double);
  }
  need.end = result_of(size);
}

// The chains' part and the samples' beside all of the chains; and their film alone.
void need_of_pooling(MemoryNeed& need, const Size& size, double groups) {
  if (size.is_large) {
    need.films += groups * size.cells * of_sum;
    need.films += size.bins * (sizeof(BinSums) + size.lengths * of_double + sizeof(std::int64_t));
  } else {
    need.films += 2 * groups * size.cells * (1 + size.lengths) * of_sum;
  }
}

// Of a pooled film the pilot may ask for more.
int most_chains_of_group(const ChainSettings& settings, const Size& size) {
  const bool is_as_asked = settings.film_parts == FilmParts::chains || settings.has_given_chains();
  if (is_as_asked) return settings.chains_per_group;
  const int most = size.is_image()
                       ? chains_in_memory(ChainsOfImage::chains_per_group, size.max_vertices)
                       : RareLight::chains_per_group;
  return std::max(settings.chains_per_group, most);
}

void need_of_chains(MemoryNeed& need, const Size& size, const Job& job) {
  const ChainSettings& settings = job.dials().chains;
  const double groups = settings.groups;
  // Deposits and what the seed pass found, per cell; acceptance maps.
  need.films = groups * (2 * size.cells * of_sum + size.maps * of_double);
  if (size.is_large) {
    const double parts = SharedFilms::films_of(size.shape, settings.groups, size.layout);
    need.films += size.bins * (1 + size.lengths) * (parts * of_float + of_double);
    need.end = result_of(size) + groups * size.cells * 2 * of_double;
  } else {
    need.films += groups * size.cells * size.lengths * of_sum;
    need.end = result_of(size) + groups * size.bins * 3 * of_double;
  }
  if (settings.film_parts == FilmParts::pooled) need_of_pooling(need, size, groups);
  // Paths with all that is known of their vertices; splats of a sample, one for each technique.
  // Of mmlt a group has a chain for each length, of half the longest in the mean.
  const double n = size.max_vertices;
  const bool is_path_of_numbers = job.method().state == ChainState::numbers_of_path;
  constexpr double of_vertex_and_numbers = 512, of_splat = 128, of_start = 4096;
  constexpr double of_length = 8192;  // what samples and states of each length are like
  const double of_path = is_path_of_numbers ? (n + 1) / 2 * of_vertex_and_numbers + of_length
                                            : n * 2 * of_vertex_and_numbers;
  const bool is_sample = job.method().state == ChainState::numbers_of_sample;
  const double of_each = is_path_of_numbers ? n - 1 : most_chains_of_group(settings, size);
  const std::size_t draws = ThinnedDraws::capacity_of(static_cast<std::size_t>(of_each));
  const double of_chain = static_cast<double>(draws * sizeof(Functionals)) + of_start + of_path +
                          (is_sample ? of_splat * std::min(n * n, 4096.0) : 0);
  need.chains = groups * of_each * of_chain;
}

std::string in_gigabytes(double bytes) { return number_text(bytes / 1e9, 2); }

}  // namespace

double MemoryNeed::most() const {
  return program + not_counted * std::max(films + chains + end, files);
}

MemoryNeed memory_need(const Job& job, int threads) {
  const Size size(job);
  MemoryNeed need{.program = of_program, .files = files_of(size)};
  if (job.method().is_markov_chain())
    need_of_chains(need, size, job);
  else
    need_of_samples(need, size, threads);
  return need;
}

std::string memory_in_words(const MemoryNeed& need) {
  return fmt::format("{} GB (films {}, chains {}, results {}; {} to write the files)",
                     in_gigabytes(need.most()), in_gigabytes(need.films), in_gigabytes(need.chains),
                     in_gigabytes(need.end), in_gigabytes(need.files));
}

std::string why_too_large(const Job& job, const MemoryNeed& need,
                          const AvailableMemory& available) {
  if (need.most() <= available.bytes) return {};
  const Size size(job);
  std::string remedy = size.is_image() ? "an image of fewer pixels" : "a sensor of fewer bins";
  if (size.lengths > 0 && job.dials().film.by_length == Keep::always) remedy += ", no --by-length";
  if (size.maps > 0 && job.dials().film.maps == Keep::always) remedy += ", no --maps";
  if (need.chains > need.films) remedy += ", fewer --chains";
  if (size.max_vertices > 100) remedy += ", shorter paths (--max-vertices)";
  if (!job.method().is_markov_chain() && !size.is_large) remedy += ", fewer threads (-t)";
  return fmt::format("the run needs about {} GB of memory, and {} has {} GB to give; take {}",
                     in_gigabytes(need.most()), available.word, in_gigabytes(available.bytes),
                     remedy);
}

}  // namespace wander
