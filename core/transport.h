// Sampling and measuring paths in a scene: the vocabulary in which every estimator and every
// mutation is written.  (Pointland offers the same vocabulary on a finite graph.)
//
//   begin_light, begin_sensor  the first vertex of a subpath
//   extend                     the next vertex of a subpath, at its end
//   connect                    the edge between two vertices that exist
//   evaluate                   value and densities at a vertex whose neighbours are known
// and, for perturbations, which move what is there already:
//   move_end, shoot, aim_film  an end on its surface; a direction; a point of a camera's film
//   follow                     the specular event that a path had
//   end_density, aim_density, follow_density  how densities of these become densities of area
//
// A subpath towards the sensor grows upwards in a Path, one towards the light grows downwards; both
// are stored light first, so what is written once serves both.
#pragma once

#include <span>

#include "core/importance_map.h"
#include "core/path_space.h"
#include "core/rng.h"
#include "core/scene.h"

namespace wander {

// The random numbers that a first vertex consumes.
template <World W>
struct PointNumbers {
  double light = 0;  // which light
  typename W::Square position{};
};

template <World W>
class Transport {
 public:
  using Universe = W;
  using Real = typename W::Real;
  using Length = typename W::Length;
  using Direction = typename W::Direction;

  Transport(const Scene<W>& scene, Roulette roulette) : scene_(&scene), roulette_(roulette) {}
  Transport(Scene<W>&&, Roulette) = delete;

  const Scene<W>& scene() const { return *scene_; }
  int max_vertices() const { return scene_->max_vertices(); }
  // The same paths, found by walks that play another roulette.
  Transport with(Roulette roulette) const { return {*scene_, roulette, importance_}; }
  // The same paths, measured with this factor on what the sensor or the camera sees; it is there as long as the space.
  Transport measuring(const ImportanceMap& importance) const {
    return {*scene_, roulette_, &importance};
  }
  Transport measuring(ImportanceMap&&) const = delete;
  Transport measuring_light() const { return {*scene_, roulette_}; }
  Importance importance(int bin) const { return importance_ ? (*importance_)(bin) : Importance{}; }

  template <class Random>
  void begin_light(Path<W>& x, int i, Random& random) const {
    PointNumbers<W> u;
    if (scene_->lights().size() > 1) u.light = random.uniform();
    draw(u.position, random);
    begin_light(x, i, u);
  }
  template <class Random>
  void begin_sensor(Path<W>& x, int i, Random& random) const {
    PointNumbers<W> u;
    if (!scene_->camera() || !scene_->camera()->is_pinhole()) draw(u.position, random);
    begin_sensor(x, i, u);
  }
  void begin_light(Path<W>& x, int i, PointNumbers<W> u) const;
  void begin_sensor(Path<W>& x, int i, PointNumbers<W> u) const;

  // Samples a direction at x_i, the end of a subpath, and writes the vertex that it meets at
  // i + 1 or i - 1, with the edge between.  False: the walk ends at x_i.
  template <class Random>
  bool extend(Path<W>& x, int i, Toward toward, Random& random) const {
    return extend(x, i, toward, scatter_numbers(random, x[i]));
  }
  bool extend(Path<W>& x, int i, Toward toward, ScatterNumbers<W> u) const;

  // Probability that a walk goes on at this vertex; and with which it would under Russian roulette.
  Real survival(const Vertex<W>& v) const {
    return roulette_ == Roulette::off ? Real(1) : albedo(v);
  }
  Real albedo(const Vertex<W>& v) const;

  // ---- moves
  // Where x_i, an end of a path, is on its surface or lens, and the same end put elsewhere on it.
  typename W::Square end_parameter(const Path<W>& x, int i) const {
    return inverted_point(x, i).position;
  }
  void move_end(Path<W>& x, int i, typename W::Square u) const;
  // Writes the vertex that a ray from x_i meets, and the edge; false: there is none.
  bool shoot(Path<W>& x, int i, Toward toward, Direction direction) const;
  // The same for the direction that a camera gives to a point of its film.
  bool aim_film(Path<W>& x, int i, typename W::Square film) const {
    const Direction direction = scene_->camera()->sample_direction(x[i].place.position, film);
    return shoot(x, i, Toward::light, direction);
  }
  // The same for the direction that a specular event gives to the light that is known at x_i.
  bool follow(Path<W>& x, int i, Toward toward, Event event) const;
  Direction direction(const Path<W>& x, int i, Toward toward) const {
    return toward == Toward::sensor ? x[i].place.to_sensor : -x[i - 1].place.to_sensor;
  }
  // Densities of area at x_i, for unit density of its parameter; and at the vertex after x_i, for
  // unit density of film coordinates (a camera) or of angle, and for a followed event.
  double end_density(const Path<W>& x, int i) const;
  double aim_density(const Path<W>& x, int i, Toward toward) const;
  double follow_density(const Path<W>& x, int i, Toward toward) const;
  bool is_camera(const Vertex<W>& v) const { return v.place.shape == no_shape; }
  bool is_pinhole(const Vertex<W>& v) const {
    return is_camera(v) && scene_->camera()->is_pinhole();
  }

  // May an edge carry light between x_i, the end of a subpath from the light, and z_j, the end of one
  // from the sensor?  False: at one of them it comes and goes on different sides, or leaves the film.
  // No ray is asked.
  bool may_connect(const Path<W>& x, int i, const Path<W>& z, int j) const;
  // Writes the edge between x_i and x_{i+1}.
  Connection connect(Path<W>& x, int i) const;

  // Writes value_i, and the densities of its neighbours as sampled from it.
  void evaluate(Path<W>& x, int i) const;

  // The numbers that begin a subpath at x_i, and that extend it from there.  Numbers that the path
  // does not fix are drawn.
  template <class Random>
  PointNumbers<W> invert_begin(const Path<W>& x, int i, Random& random) const;
  template <class Random>
  ScatterNumbers<W> invert_extend(const Path<W>& x, int i, Toward toward, Random& random) const;

  // Are there lights to choose from at this vertex, or lobes when a subpath goes on?  Where there are
  // none, no number is drawn.
  bool chooses_light(const Vertex<W>& v) const {
    return v.event == Event::emission && scene_->lights().size() > 1;
  }
  bool chooses_lobe(const Vertex<W>& v) const {
    return v.event != Event::emission && v.event != Event::detection &&
           scene_->surface(v.place.shape).has_lobes;
  }

  // Can an edge be made at this vertex without sampling its direction?
  bool can_connect(const Vertex<W>& v) const {
    if (v.event != Event::scattering) return !is_specular(v.event);
    return scene_->surface(v.place.shape).scatters;
  }
  bool is_light(const Vertex<W>& v) const {
    return v.place.shape != no_shape && scene_->surface(v.place.shape).is_light();
  }
  bool is_sensor(const Vertex<W>& v) const {
    return v.place.shape != no_shape && scene_->surface(v.place.shape).is_sensor;
  }
  // Can a walk from the light meet the sensor at all?
  bool sensor_can_be_hit() const { return !scene_->camera(); }

  // Where a whole path meets the film.
  typename W::Square film_position(const Path<W>& x) const;
  int bin(const Path<W>& x) const { return scene_->bin(film_position(x)); }

 private:
  using Local = typename W::Local;

  Transport(const Scene<W>& scene, Roulette roulette, const ImportanceMap* importance)
      : scene_(&scene), roulette_(roulette), importance_(importance) {}

  template <class Random>
  static void draw(typename W::Square& numbers, Random& random) {
    for (auto& number : numbers) number = unit_number<Real>(random.uniform());
  }
  template <class Random>
  ScatterNumbers<W> scatter_numbers(Random& random, const Vertex<W>& v) const {
    ScatterNumbers<W> u;
    draw(u.direction, random);
    if (chooses_lobe(v)) u.lobe = unit_number<Real>(random.uniform());
    return u;
  }
  Direction known_direction(const Path<W>& x, int i, Toward toward) const {
    return toward == Toward::sensor ? -x[i - 1].place.to_sensor : x[i].place.to_sensor;
  }
  const Material<W>& material(const Vertex<W>& v) const {
    return *scene_->surface(v.place.shape).material;
  }
  std::optional<Direction> sample_direction(Path<W>& x, int i, Toward toward,
                                            ScatterNumbers<W> u) const;
  InvertedNumbers<W> inverted(const Path<W>& x, int i, Toward toward) const;
  PointNumbers<W> inverted_point(const Path<W>& x, int i) const;
  double light_choice(ShapeId shape, double u) const;
  bool passes(const Vertex<W>& v, Direction way, Direction known) const;
  void evaluate_emission(Path<W>& x) const;
  void evaluate_detection(Path<W>& x, int i) const;

  const Scene<W>* scene_;
  Roulette roulette_;
  const ImportanceMap* importance_ = nullptr;  // none: what is measured is light
};

template <World W>
template <class Random>
PointNumbers<W> Transport<W>::invert_begin(const Path<W>& x, int i, Random& random) const {
  PointNumbers<W> u = inverted_point(x, i);
  if (chooses_light(x[i])) u.light = light_choice(x[i].place.shape, random.uniform());
  return u;
}

template <World W>
template <class Random>
ScatterNumbers<W> Transport<W>::invert_extend(const Path<W>& x, int i, Toward toward,
                                              Random& random) const {
  const InvertedNumbers<W> numbers = inverted(x, i, toward);
  ScatterNumbers<W> u;
  u.direction = numbers.direction;
  if (numbers.direction_is_free) draw(u.direction, random);
  if (!chooses_lobe(x[i])) return u;
  const Real free = unit_number<Real>(random.uniform());
  u.lobe = numbers.lobe_low + free * (numbers.lobe_high - numbers.lobe_low);
  return u;
}

}  // namespace wander
