// A trajectory file: what is written is read back, and what is no trajectory is told apart.
#include "records/trajectory_netcdf.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "core/rng.h"
#include "records/atomic_file.h"
#include "records/netcdf.h"
#include "records/scene_curves.h"
#include "records/scene_faces.h"
#include "records/seal.h"
#include "records/trajectory_csv.h"
#include "tests/support/coloured_box.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

namespace fs = std::filesystem;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// Two chains of three draws; the second draw of each proposed nothing.
TrajectoryRecord small_record(int dimension) {
  TrajectoryRecord record;
  Trajectory& t = record.trajectory;
  t.dimension = dimension;
  t.max_vertices = 3;
  t.chains = 2;
  t.draws = 3;
  t.first_step = 10;
  t.every = 5;
  t.mutations = {"bidirectional", "lens"};
  t.reasons = {"none", "metropolis", "solver_failed"};
  t.classes = {"LE", "LSE"};
  const auto axes = static_cast<std::size_t>(dimension);
  for (int i = 0; i < 6; ++i) {
    const bool failed = i % 3 == 1;
    for (RecordedPaths* paths : {&t.state, &t.proposed}) {
      const bool absent = failed && paths == &t.proposed;
      const std::size_t vertices = absent ? 0 : i % 2 == 0 ? 2 : 3;
      for (std::size_t k = 0; k < 3 * axes; ++k)
        paths->position.push_back(k < vertices * axes ? 0.1 * static_cast<double>(k) + i : none);
      for (std::size_t k = 0; k + 1 < axes; ++k)
        paths->film.push_back(absent ? none : 0.125 * i + 0.01 * static_cast<double>(k));
      paths->vertices.push_back(static_cast<std::int32_t>(vertices));
      paths->path_class.push_back(absent ? -1 : i % 2);
    }
    t.mutation.push_back(i % 2);
    t.reason.push_back(failed ? 2 : i % 3 == 0 ? 0 : 1);
    t.accepted.push_back(i % 3 == 0 ? 1 : 0);
    t.acceptance.push_back(failed ? 0 : 1 / (1.0 + i));
    t.log_f.push_back(-1.0 / 3 * i);
    t.log_f_current.push_back(-700.5 * i);
    t.log_f_proposed.push_back(failed ? none : 1e-300);
    t.log_forward.push_back(failed ? none : 0.1 * i);
    t.log_reverse.push_back(failed ? none : -0.1 * i);
  }
  record.complete = false;
  record.method = "mlt";
  record.seed = std::numeric_limits<std::uint64_t>::max();
  record.normalization = {0.61, 0.002};
  record.provenance = {"",
                       "{} // \"é\"\n",
                       {"abc", {{"tri.obj", "f00d"}}},
                       dimension,
                       "wander trace 'a b.json'",
                       "0.1.0",
                       {"c0ffee", "GNU 12.2.0", "Release", "a cpu", "2026-01-02T03:04:05Z"}};
  return record;
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(
      a, b, [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}
void expect_same(const RecordedPaths& a, const RecordedPaths& b) {
  EXPECT_TRUE(same(a.position, b.position));
  EXPECT_TRUE(same(a.film, b.film));
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.path_class, b.path_class);
}
// The same with what a newer file holds: starts, and proposals that failed.
TrajectoryRecord full_record(int dimension) {
  TrajectoryRecord record = small_record(dimension);
  Trajectory& t = record.trajectory;
  const auto axes = static_cast<std::size_t>(dimension);
  for (int chain = 0; chain < t.chains; ++chain) {
    for (std::size_t k = 0; k < 3 * axes; ++k)
      t.start.position.push_back(k < 2 * axes ? 0.5 * static_cast<double>(k) + chain : none);
    for (std::size_t k = 0; k + 1 < axes; ++k) t.start.film.push_back(0.25 * chain);
    t.start.vertices.push_back(2);
    t.start.path_class.push_back(chain);
  }
  t.attempts.max_points = 4;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const bool failed = i % 3 == 1;
    for (std::size_t k = 0; k < 4 * axes; ++k)
      t.attempts.position.push_back(failed && k / axes != 2 ? static_cast<double>(k + i) : none);
    for (std::size_t k = 0; k < axes; ++k) t.attempts.failure.push_back(failed ? 0.5 : none);
  }
  return record;
}

void expect_same(const Trajectory& a, const Trajectory& b) {
  EXPECT_EQ(a.dimension, b.dimension);
  EXPECT_EQ(a.max_vertices, b.max_vertices);
  EXPECT_EQ(a.chains, b.chains);
  EXPECT_EQ(a.draws, b.draws);
  EXPECT_EQ(a.first_step, b.first_step);
  EXPECT_EQ(a.every, b.every);
  EXPECT_EQ(a.mutations, b.mutations);
  EXPECT_EQ(a.reasons, b.reasons);
  EXPECT_EQ(a.classes, b.classes);
  expect_same(a.state, b.state);
  expect_same(a.proposed, b.proposed);
  expect_same(a.start, b.start);
  EXPECT_EQ(a.attempts.max_points, b.attempts.max_points);
  EXPECT_TRUE(same(a.attempts.position, b.attempts.position));
  EXPECT_TRUE(same(a.attempts.failure, b.attempts.failure));
  EXPECT_EQ(a.mutation, b.mutation);
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.accepted, b.accepted);
  EXPECT_TRUE(same(a.acceptance, b.acceptance));
  EXPECT_TRUE(same(a.log_f, b.log_f));
  EXPECT_TRUE(same(a.log_f_current, b.log_f_current));
  EXPECT_TRUE(same(a.log_f_proposed, b.log_f_proposed));
  EXPECT_TRUE(same(a.log_forward, b.log_forward));
  EXPECT_TRUE(same(a.log_reverse, b.log_reverse));
}

class TrajectoryFile : public ::testing::Test {
 protected:
  TrajectoryFile() {
    std::string name = (fs::temp_directory_path() / "wander-trajectory-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~TrajectoryFile() override { fs::remove_all(folder_); }

  fs::path file(const std::string& bytes) const {
    write_file(folder_ / "t.nc", bytes);
    return folder_ / "t.nc";
  }
  std::string message(const std::string& bytes) const {
    try {
      read_trajectory(file(bytes));
    } catch (const RunFileError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(TrajectoryFile, ReadsBackWhatWasWritten) {
  for (const int dimension : {2, 3}) {
    const TrajectoryRecord record = small_record(dimension);
    const TrajectoryRecord back = read_trajectory(file(to_netcdf(record, thin_lens_room())));
    expect_same(record.trajectory, back.trajectory);
    EXPECT_EQ(back.complete, false);
    EXPECT_EQ(back.method, "mlt");
    EXPECT_EQ(back.seed, record.seed);
    EXPECT_EQ(back.normalization.value, 0.61);
    EXPECT_EQ(back.normalization.standard_error, 0.002);
    EXPECT_EQ(back.provenance.scene_name, "");
    EXPECT_EQ(back.provenance.scene_text, record.provenance.scene_text);
    EXPECT_EQ(back.provenance.scene_digest, record.provenance.scene_digest);
    EXPECT_EQ(back.provenance.command_line, record.provenance.command_line);
    EXPECT_EQ(back.provenance.version, "0.1.0");
    for (const OriginField& field : origin_fields)
      EXPECT_EQ(back.provenance.origin.*field.member, record.provenance.origin.*field.member);
  }
}

// On both sides of what is kept in a header.
TEST_F(TrajectoryFile, ReadsBackATextOfAnyLength) {
  for (const std::size_t length :
       {std::size_t{1} << 15, (std::size_t{1} << 15) + 1, std::size_t{1} << 20}) {
    TrajectoryRecord record = small_record(2);
    record.provenance.scene_text = std::string(length - 1, 'x') + "y";
    EXPECT_EQ(read_trajectory(file(to_netcdf(record, thin_lens_room()))).provenance.scene_text,
              record.provenance.scene_text);
    EXPECT_EQ(to_netcdf(record, thin_lens_room()), to_netcdf(record, thin_lens_room()));
  }
}

TEST_F(TrajectoryFile, ReadsBackStartsAndWhatFailed) {
  for (const int dimension : {2, 3}) {
    const TrajectoryRecord record = full_record(dimension);
    expect_same(record.trajectory,
                read_trajectory(file(to_netcdf(record, thin_lens_room()))).trajectory);
  }
}

TEST_F(TrajectoryFile, OfEqualContentHasEqualBytes) {
  TrajectoryRecord record = small_record(2);
  const std::string bytes = to_netcdf(record, diffuse_room());
  EXPECT_EQ(bytes, to_netcdf(record, diffuse_room()));
  record.trajectory.log_f[3] += 1;
  EXPECT_NE(bytes, to_netcdf(record, diffuse_room()));
}

// What ArviZ and xarray look for.
TEST_F(TrajectoryFile, HasTheNamesOfTheLayout) {
  const std::string bytes = to_netcdf(small_record(2), diffuse_room());
  const netcdf::Reader reader(unsealed(bytes).value());
  const auto stats = reader.root().group("sample_stats");
  std::vector<std::int32_t> steps;
  stats.read("draw", 3, steps);
  EXPECT_EQ(steps, (std::vector<std::int32_t>{10, 15, 20}));
  std::vector<std::uint8_t> diverging;
  stats.read("diverging", 6, diverging);
  EXPECT_EQ(diverging, (std::vector<std::uint8_t>{0, 1, 0, 0, 1, 0}));
  EXPECT_EQ(stats.words("mutation"), (std::vector<std::string>{"bidirectional", "lens"}));
  std::vector<double> values;
  reader.root().group("paths").read("x", 2 * 3 * 3 * 2, values);
  reader.root().group("proposal").read("sensor_u", 6, values);
  const SceneCurves curves = scene_curves(diffuse_room());
  const auto constants = reader.root().group("constant_data");
  constants.read("from", 2 * curves.size(), values);
  EXPECT_TRUE(same(values, curves.from));
  constants.read("radiance", curves.size(), values);
  EXPECT_EQ(values, curves.radiance);
  EXPECT_GT(*std::ranges::max_element(values), 0);
}

TEST_F(TrajectoryFile, HasTheFacesOfASceneInSpace) {
  const description::Scene scene = coloured_box();
  const SceneFaces faces = scene_faces(scene);
  ASSERT_EQ(faces.size(), 8U);
  const std::string bytes = to_netcdf(small_record(3), scene);
  const netcdf::Reader reader(unsealed(bytes).value());
  const auto constants = reader.root().group("constant_data");
  EXPECT_EQ(constants.words("kind"),
            (std::vector<std::string>{"triangle", "parallelogram", "sphere"}));
  std::vector<double> values;
  constants.read("corners", 9 * faces.size(), values);
  EXPECT_TRUE(same(values, faces.corners));
  // The second edge of the floor ends at (1, 0, 0); the ball is the seventh.
  EXPECT_EQ(std::vector<double>(values.begin() + 6, values.begin() + 9),
            (std::vector<double>{1, 0, 0}));
  EXPECT_EQ(std::vector<double>(values.begin() + 54, values.begin() + 57),
            (std::vector<double>{0.55, 0.3, 0.4}));
  EXPECT_EQ(faces.radius[6], 0.2);
  constants.read("radiance", faces.size(), values);
  EXPECT_DOUBLE_EQ(values[7], luminance(std::array<double, 3>{9, 7, 4}));
  constants.read("camera_up", 3, values);
  EXPECT_EQ(values, (std::vector<double>{0, 1, 0}));
}

TEST_F(TrajectoryFile, ThatIsNoneOrBrokenIsRefusedWithItsName) {
  const std::string whole = to_netcdf(small_record(2), diffuse_room());
  EXPECT_FALSE(find_trajectory(file("{}")));
  EXPECT_FALSE(find_trajectory(folder_ / "missing"));
  EXPECT_NE(message("").find("t.nc"), std::string::npos);
  for (const std::size_t size : {whole.size() / 2, whole.size() - 1, std::size_t{100}})
    EXPECT_NE(message(whole.substr(0, size))
                  .find("t.nc: not a trajectory or film of this program, or cut"),
              std::string::npos)
        << size;
}

TEST_F(TrajectoryFile, WithAByteThatIsDamagedIsRefused) {
  const std::string whole = to_netcdf(small_record(2), diffuse_room());
  Rng random(1, Purpose::test, 60);
  for (int i = 0; i < 40; ++i) {
    std::string damaged = whole;
    char& byte = damaged[static_cast<std::size_t>(random.choose(static_cast<int>(whole.size())))];
    byte = static_cast<char>(byte ^ (1 << random.choose(8)));
    EXPECT_NE(message(damaged), "");
  }
}

TEST_F(TrajectoryFile, OfAnotherKindIsRefused) {
  netcdf::Writer empty = netcdf::Writer::create(0);
  EXPECT_NE(message(sealed(empty.take())).find("format"), std::string::npos);
  netcdf::Writer other = netcdf::Writer::create(0);
  other.attribute("format", "something-else/1");
  EXPECT_NE(message(sealed(other.take())).find("format: it is something-else/1"),
            std::string::npos);
}

TEST_F(TrajectoryFile, WhoseIndicesMeanNothingIsRefused) {
  TrajectoryRecord record = small_record(2);
  record.trajectory.state.path_class[2] = 7;
  EXPECT_NE(message(to_netcdf(record, diffuse_room())).find("path_class: it holds 7"),
            std::string::npos);
  record = small_record(2);
  record.trajectory.proposed.vertices[2] = 4;
  EXPECT_NE(message(to_netcdf(record, diffuse_room())).find("n_vertices: it holds 4"),
            std::string::npos);
}

TEST(TrajectoryCsv, HasOneRowPerDrawWithAllScalars) {
  std::istringstream csv(to_csv(small_record(2).trajectory));
  std::vector<std::string> lines;
  for (std::string line; std::getline(csv, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 7u);
  EXPECT_EQ(lines[0],
            "chain,draw,mutation,accepted,acceptance_rate,reason,diverging,lp,log_f,log_f_current,"
            "log_f_proposed,log_forward,log_reverse,n_vertices,path_class,sensor_u,"
            "proposed_n_vertices,proposed_path_class,proposed_sensor_u");
  EXPECT_EQ(lines[2],
            "0,15,lens,0,0,solver_failed,1,-0.3333333333333333,-0.3333333333333333,-700.5,nan,nan,"
            "nan,3,LSE,0.125,0,,nan");
  EXPECT_TRUE(lines[4].starts_with("1,10,lens,1,0.25,none,0,-1,-1,"));
  EXPECT_TRUE(
      lines[4].ends_with(",1e-300,0.30000000000000004,-0.30000000000000004,3,LSE,0.375,3,"
                         "LSE,0.375"))
      << lines[4];
}

TEST(SceneCurves, AreTheSegmentsAndArcsOfTheScene) {
  const description::Scene scene = mirror_and_glass();
  const SceneCurves curves = scene_curves(scene);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const bool arc = curves.kind[i] == 1;
    EXPECT_EQ(std::isfinite(curves.radius[i]), arc);
    EXPECT_EQ(std::isfinite(curves.from[2 * i]), !arc);
    EXPECT_EQ(std::isfinite(curves.center[2 * i + 1]), arc);
    const auto& shape = scene.shapes.at(static_cast<std::size_t>(curves.shape[i]));
    EXPECT_EQ(curves.is_sensor[i] != 0, shape.sensor.has_value());
    EXPECT_EQ(curves.radiance[i] > 0, shape.light.has_value());
  }
  EXPECT_EQ(std::ranges::count(curves.kind, 1), 1);
}

}  // namespace
}  // namespace wander::test
