#include "tests/benchmarks/yardstick/plane_kernel.h"

#include <algorithm>
#include <cmath>

#include "mutations/length_pmfs.h"
#include "mutations/primary_large.h"

namespace wander {

namespace {

constexpr double sensor_end = 0.5;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

double mixed(double found, double even) {
  return PrimaryLarge::uniform_part * even + (1 - PrimaryLarge::uniform_part) * found;
}

// Vertices of x to another place in y, with the edges towards the sensor.
void copy(const PlaneKernel::Path& x, int first, int count, PlaneKernel::Path& y, int to) {
  std::copy_n(x.at.begin() + first, count, y.at.begin() + to);
  std::copy_n(x.way.begin() + first, count, y.way.begin() + to);
  std::copy_n(x.g.begin() + first, count, y.g.begin() + to);
}

double place_probability(int n, int d, int kept_sensor) {
  if (d == 0) return 1.0 / (n - 1);
  if (d == n) return 1;
  return kept_sensor == 0 ? sensor_end : (1 - sensor_end) / (n - d);
}

}  // namespace

PlaneKernel::PlaneKernel(const Scene<W>& scene, const SeedTally& seeds)
    : scene_(&scene),
      lamp_(scene.lights()[0]),
      sensor_(scene.sensor()),
      longest_(scene.max_vertices()),
      radiance_(scene.surface(lamp_).radiance),
      weights_{0.5 / 3, 1.0 / 3, 1.5 * 0.7 / 3, 1.5 * 0.3 / 3},
      technique_pmf_(index(longest_) + 1) {
  const int shapes = std::max(lamp_, sensor_) + 1;
  for (int id = 0; id < shapes; ++id) {
    const auto& segment = std::get<Segment<W>>(scene.shape(id));
    const auto* diffuse = std::get_if<Diffuse<W>>(scene.surface(id).material);
    walls_.push_back({segment.from(), segment.to() - segment.from(), segment.sample({0}).normal,
                      segment.measure(), diffuse ? diffuse->reflectance / 2 : 0,
                      diffuse != nullptr});
  }
  const double b = seeds.total.value();
  for (int n = 2; n <= longest_; ++n) {
    length_pmf_.push_back(mixed(seeds.sum[index(n - 2)].value() / b, 1.0 / (longest_ - 1)));
    double total = 0;
    for (const double share : seeds.techniques.row(n)) total += share;
    for (const double share : seeds.techniques.row(n))
      technique_pmf_[index(n)].push_back(total > 0 ? mixed(share / total, 1.0 / (n + 1))
                                                   : 1.0 / (n + 1));
  }
}

auto PlaneKernel::start(const wander::Path<W>& x) const -> Path {
  Path y;
  y.n = x.size();
  for (int i = 0; i < y.n; ++i) {
    y.at[index(i)] = {x[i].place.position, x[i].place.shape};
    y.way[index(i)] = x[i].place.to_sensor;
    y.g[index(i)] = x[i].geometry;
  }
  measure(y);
  return y;
}

// ---- making vertices and edges

void PlaneKernel::begin(Path& y, int i, int id, double u) const {
  const Wall& wall = walls_[index(id)];
  y.at[index(i)] = {wall.from + u * wall.along, id};
}

bool PlaneKernel::shoot(Path& y, int i, int step, Point direction) const {
  const Vertex& a = y.at[index(i)];
  const Hit<W> hit =
      scene_->closest({.origin = a.position, .direction = direction, .from = Element<W>(a.wall)});
  if (!(hit.distance > 0 && hit)) return false;
  const Wall& met = walls_[index(hit.shape)];
  const double side_a = cross(direction, met.from - a.position);
  const double side_b = side_a + cross(direction, met.along);
  y.at[index(i + step)] = {met.from + met.along * (side_a / (side_a - side_b)), hit.shape};
  const int edge = std::min(i, i + step);
  y.way[index(edge)] = step > 0 ? direction : -direction;
  y.g[index(edge)] =
      std::abs(glm::dot(direction, wall(y, i).normal) * glm::dot(direction, met.normal)) /
      hit.distance;
  return true;
}

// From an end, or a wall that light reaches along the edge behind x_i.
bool PlaneKernel::extend(Path& y, int i, int step, double u) const {
  const Wall& here = wall(y, i);
  const bool is_end = i == (step > 0 ? 0 : y.n - 1);
  if (!is_end && !here.scatters) return false;
  const double sine = 2 * u - 1;
  double cosine = std::sqrt((1 - sine) * (1 + sine));
  if (!is_end) {
    const double known = glm::dot(step > 0 ? -y.way[index(i - 1)] : y.way[index(i)], here.normal);
    cosine = std::copysign(cosine, known);
  }
  const Point tangent(here.normal.y, -here.normal.x);
  return shoot(y, i, step, sine * tangent + cosine * here.normal);
}

double PlaneKernel::number_of(const Path& x, int i, int step) const {
  const Point& normal = wall(x, i).normal;
  const Point way = step > 0 ? x.way[index(i)] : -x.way[index(i - 1)];
  return std::clamp((glm::dot(way, Point(normal.y, -normal.x)) + 1) / 2, 0.0,
                    std::nextafter(1.0, 0.0));
}

// Does light pass at x_i, whose edge towards the other subpath goes along `direction`?
bool PlaneKernel::faces(const Path& y, int i, Point direction) const {
  const Wall& here = wall(y, i);
  const double side = glm::dot(direction, here.normal);
  if (i == 0 || i == y.n - 1) return side > 0;
  const bool up = direction == y.way[index(i)];
  const double known = glm::dot(up ? -y.way[index(i - 1)] : y.way[index(i)], here.normal);
  return here.scatters && side * known > 0;
}

bool PlaneKernel::join(Path& y, int s) const {
  if (s == 0) return y.at[0].wall == lamp_ && faces(y, 0, y.way[0]);
  if (s == y.n) return y.at[index(s - 1)].wall == sensor_ && faces(y, s - 1, -y.way[index(s - 2)]);
  const Vertex &a = y.at[index(s - 1)], &b = y.at[index(s)];
  if (a.wall == b.wall) return false;
  const Point offset = b.position - a.position;
  const double distance = glm::length(offset);
  if (!(distance > 0)) return false;
  const Point way = y.way[index(s - 1)] = offset / distance;
  if (!faces(y, s - 1, way) || !faces(y, s, -way)) return false;
  y.g[index(s - 1)] =
      std::abs(glm::dot(way, wall(y, s - 1).normal) * glm::dot(way, wall(y, s).normal)) / distance;
  return !scene_->occluded({.origin = a.position,
                            .direction = offset,
                            .from = Element<W>(a.wall),
                            .to = Element<W>(b.wall),
                            .limit = 1});
}

// ---- measuring

void PlaneKernel::measure(Path& y) const {
  const Wall &lamp = walls_[index(lamp_)], &sensor = walls_[index(sensor_)];
  double product = 1, half_product = 1, inverse = 0;
  for (int e = 0; e + 1 < y.n; ++e) {
    const double g = y.g[index(e)];
    product *= g;
    half_product *= g / 2;
    inverse += 2 / g;
    if (e > 0) product *= wall(y, e).half_reflectance;
  }
  y.f = radiance_ * product / sensor.length;
  y.intensity =
      half_product * (lamp.length + sensor.length + inverse) / (lamp.length * sensor.length);
  const double u = glm::dot(y.at[index(y.n - 1)].position - sensor.from, sensor.along) /
                   (sensor.length * sensor.length);
  const int bins = scene_->bins();
  y.bin = std::clamp(static_cast<int>(u * bins), 0, bins - 1);
}

double PlaneKernel::technique(const Path& x, int s) const {
  if (s == 0) return walls_[index(lamp_)].length;
  return s == x.n ? walls_[index(sensor_)].length : 2 / x.g[index(s - 1)];
}

double PlaneKernel::from_light(const Path& x, int i) const {
  return i == 0 ? 1 / walls_[index(lamp_)].length : x.g[index(i - 1)] / 2;
}
double PlaneKernel::from_sensor(const Path& x, int i) const {
  return i == x.n - 1 ? 1 / walls_[index(sensor_)].length : x.g[index(i)] / 2;
}

// ---- the mutations

double PlaneKernel::large_density(const Path& z) const {
  double q = 0, total = 0;
  for (int s = 0; s <= z.n; ++s) {
    const double p = technique(z, s);
    q += technique_pmf_[index(z.n)][index(s)] * p;
    total += p;
  }
  return length_pmf_[index(z.n - 2)] * q / total * z.intensity;
}

double PlaneKernel::try_large(const Path& x, Path& y, Rng& random) const {
  y.n = 2 + random.choose(length_pmf_);
  const int s = random.choose(technique_pmf_[index(y.n)]);
  if (s > 0) begin(y, 0, lamp_, random.uniform());
  for (int i = 0; i + 1 < s; ++i)
    if (!extend(y, i, 1, random.uniform())) return 0;
  if (s < y.n) begin(y, y.n - 1, sensor_, random.uniform());
  for (int i = y.n - 1; i > s; --i)
    if (!extend(y, i, -1, random.uniform())) return 0;
  if (!join(y, s)) return 0;
  measure(y);
  return y.f * large_density(x) / (x.f * large_density(y));
}

double PlaneKernel::try_small(const Path& x, Path& y, Rng& random) const {
  const int n = y.n = x.n;
  double total = 0;
  for (int s = 0; s <= n; ++s) total += technique(x, s);
  double left = random.uniform() * total;
  int s = 0;
  while (s < n && left >= technique(x, s)) left -= technique(x, s++);
  const auto moved_end = [&](int i, int id) {
    const Wall& end = walls_[index(id)];
    const double u =
        glm::dot(x.at[index(i)].position - end.from, end.along) / (end.length * end.length);
    begin(y, i, id, kelemen_.move(std::clamp(u, 0.0, std::nextafter(1.0, 0.0)), random).u);
  };
  if (s > 0) moved_end(0, lamp_);
  for (int i = 0; i + 1 < s; ++i)
    if (!extend(y, i, 1, kelemen_.move(number_of(x, i, 1), random).u)) return 0;
  if (s < n) moved_end(n - 1, sensor_);
  for (int i = n - 1; i > s; --i)
    if (!extend(y, i, -1, kelemen_.move(number_of(x, i, -1), random).u)) return 0;
  if (!join(y, s)) return 0;
  measure(y);
  return y.f * x.intensity / (x.f * y.intensity);
}

double PlaneKernel::try_lens(const Path& x, Path& y, Rng& random) const {
  const Wall& sensor = walls_[index(sensor_)];
  const int end = x.n - 1;
  double u = glm::dot(x.at[index(end)].position - sensor.from, sensor.along) /
             (sensor.length * sensor.length);
  const double distance = range_.position.draw(random).value;
  u += std::copysign(distance, random.uniform() - 0.5);
  if (!(u >= 0 && u < 1)) return 0;
  y.n = x.n;
  copy(x, 0, end, y, 0);
  begin(y, end, sensor_, u);
  const double angle = range_.angle.draw(random).value;
  const double sine = std::copysign(std::sin(angle), random.uniform() - 0.5);
  const double cosine = std::cos(angle);
  const Point axis = -x.way[index(end - 1)];
  const Point turned(cosine * axis.x - sine * axis.y, sine * axis.x + cosine * axis.y);
  if (!shoot(y, end, -1, turned) || !(glm::dot(turned, sensor.normal) > 0)) return 0;
  if (!join(y, end - 1)) return 0;
  measure(y);
  const double aim_x = x.g[index(end - 1)] / std::abs(glm::dot(axis, sensor.normal));
  const double aim_y = y.g[index(end - 1)] / std::abs(glm::dot(turned, sensor.normal));
  return y.f * aim_x / (x.f * aim_y);
}

double PlaneKernel::added_density(const Path& z, int light, int added) const {
  double sum = 0;
  for (int l = 0; l <= added; ++l) {
    double p = 1;
    for (int i = light; i < light + added; ++i)
      p *= i < light + l ? from_light(z, i) : from_sensor(z, i);
    sum += p;
  }
  return sum / (added + 1);
}

double PlaneKernel::try_bidirectional(const Path& x, Path& y, Rng& random) const {
  const int n = x.n, d = random.choose(length_pmfs.deletion(n).span());
  int light = 0;
  if (d == 0)
    light = 1 + random.choose(n - 1);
  else if (d < n)
    light = random.uniform() < sensor_end ? n - d : random.choose(n - d);
  const int sensor = n - d - light;
  const int least = (light == 0 ? 1 : 0) + (sensor == 0 ? 1 : 0), most = longest_ - light - sensor;
  const int a = random.choose(length_pmfs.addition(least, most, d).span());
  const int s = light + random.choose(a + 1);
  y.n = light + a + sensor;
  copy(x, 0, light, y, 0);
  copy(x, n - sensor, sensor, y, y.n - sensor);
  if (s > 0 && light == 0) begin(y, 0, lamp_, random.uniform());
  for (int i = std::max(light, 1); i < s; ++i)
    if (!extend(y, i - 1, 1, random.uniform())) return 0;
  if (s < y.n && sensor == 0) begin(y, y.n - 1, sensor_, random.uniform());
  for (int i = y.n - 1 - std::max(sensor, 1); i >= s; --i)
    if (!extend(y, i + 1, -1, random.uniform())) return 0;
  if (!join(y, s)) return 0;
  measure(y);
  const double forward = length_pmfs.deletion(n)[d] * place_probability(n, d, sensor) *
                         length_pmfs.addition(least, most, d)[a] * added_density(y, light, a);
  const double reverse = length_pmfs.deletion(y.n)[a] * place_probability(y.n, a, sensor) *
                         length_pmfs.addition(least, most, a)[d] * added_density(x, light, d);
  return y.f * reverse / (x.f * forward);
}

auto PlaneKernel::step(Path& x, Path& y, Rng& random) const -> Outcome {
  const int mutation = random.choose(weights_);
  double ratio = 0;
  switch (mutation) {
    case bidirectional:
      ratio = try_bidirectional(x, y, random);
      break;
    case lens:
      ratio = try_lens(x, y, random);
      break;
    case primary_small:
      ratio = try_small(x, y, random);
      break;
    default:
      ratio = try_large(x, y, random);
  }
  const double a = ratio < 1 ? ratio : 1;
  return {mutation, a > 0 ? a : 0, a > 0 && random.uniform() < a};
}

}  // namespace wander
