// A folder with Mitsuba scenes, and what comes of them.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scenes/import/import_mitsuba.h"

namespace wander::test {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// A lamp above and a camera that look at the origin from +z, after the objects of a test: its first
// shape is number 0.
inline const std::string lamp_and_camera =
    "<shape type='rectangle' id='lamp'><transform name='to_world'><rotate x='1' angle='180'/>"
    "<translate z='20'/></transform><emitter type='area'/></shape>"
    "<sensor type='perspective'><float name='fov' value='40'/><transform name='to_world'>"
    "<lookat origin='0,0,10' target='0,0,0' up='0,1,0'/></transform>"
    "<film type='hdrfilm'><integer name='width' value='40'/><integer name='height' value='30'/>"
    "<rfilter type='box'/></film></sensor>";

inline std::string scene_of(const std::string& objects) {
  return "<scene version='3.0.0'>" + objects + lamp_and_camera + "</scene>";
}
inline std::string ball_of(const std::string& bsdf) {
  return scene_of("<shape type='sphere'>" + bsdf + "</shape>");
}

class ImportFolder : public ::testing::Test {
 protected:
  ~ImportFolder() override { fs::remove_all(place_); }

  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((place_ / name).parent_path());
    std::ofstream(place_ / name, std::ios::binary) << text;
  }
  ImportedScene scene(const std::string& xml, Fidelity fidelity = Fidelity::exact,
                      const XmlParameters& parameters = {}) const {
    write("scene.xml", xml);
    ImportedScene result =
        import_mitsuba({place_ / "scene.xml", "scene", "scene-meshes", parameters, fidelity});
    for (const ImportedFile& file : result.files) write(file.path, file.bytes);
    check_imported(result, place_);
    return result;
  }
  // What is imported exactly, without a word.
  Json exact(const std::string& xml) const {
    const ImportedScene imported = scene(xml);
    for (const ImportFault& note : imported.approximations) ADD_FAILURE() << line_of(note);
    return Json::parse(imported.text);
  }
  // What is imported only with --approximate, with the words that are said.
  Json approximate(const std::string& xml, const std::string& words) const {
    EXPECT_NE(said(xml).find(words), std::string::npos) << said(xml);
    EXPECT_NE(said(xml).find("--approximate"), std::string::npos) << said(xml);
    const ImportedScene imported = scene(xml, Fidelity::approximate);
    std::string notes;
    for (const ImportFault& note : imported.approximations) notes += note.what + "\n";
    EXPECT_NE(notes.find(words), std::string::npos) << notes;
    const Json json = Json::parse(imported.text);
    EXPECT_NE(json["description"].get<std::string>().find(words), std::string::npos);
    return json;
  }
  std::vector<ImportFault> faults(const std::string& xml,
                                  Fidelity fidelity = Fidelity::exact) const {
    try {
      scene(xml, fidelity);
    } catch (const ImportError& error) {
      return error.faults;
    }
    return {};
  }
  // The faults of an import that may approximate, without their places.
  std::string refused(const std::string& xml) const {
    return words(faults(xml, Fidelity::approximate));
  }
  std::string said(const std::string& xml) const { return words(faults(xml)); }
  static std::string words(const std::vector<ImportFault>& faults) {
    std::string text;
    for (const ImportFault& fault : faults) text += (text.empty() ? "" : "\n") + fault.what;
    return text;
  }

  fs::path place_ = fs::temp_directory_path() / ("wander-import-" + std::to_string(getpid()));
};

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

inline void expect_near(const Json& point, const std::vector<double>& expected, double slack) {
  ASSERT_EQ(point.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(point[i].get<double>(), expected[i], slack) << point << " at " << i;
}

}  // namespace wander::test
