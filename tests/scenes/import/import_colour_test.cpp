// Colours, spectra and textures of Mitsuba.
#include <png.h>

#include "scenes/import/spectrum.h"
#include "tests/scenes/import/import_folder.h"

namespace wander::test {
namespace {

class ImportedColours : public ImportFolder {
 protected:
  static Json first(const Json& scene) { return scene["materials"].begin().value()["reflectance"]; }
  static std::string reflecting(const std::string& colour) {
    return ball_of("<bsdf type='diffuse'>" + colour + "</bsdf>");
  }
  Json exactly(const std::string& colour) const { return first(exact(reflecting(colour))); }
  Json nearly(const std::string& colour, const std::string& words) const {
    return first(approximate(reflecting(colour), words));
  }
  // RGB, row by row.
  void write_png(const char* name, unsigned width, std::vector<png_byte> bytes) const {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = width;
    image.height = static_cast<unsigned>(bytes.size()) / 3 / width;
    image.format = PNG_FORMAT_RGB;
    fs::create_directories(place_);
    ASSERT_NE(png_image_write_to_file(&image, (place_ / name).c_str(), 0, bytes.data(), 0, nullptr),
              0);
  }
};

TEST_F(ImportedColours, AreLinearAsTheyAre) {
  EXPECT_EQ(exactly("<rgb name='reflectance' value='0.5'/>"), 0.5);
  EXPECT_EQ(exactly("<rgb name='reflectance' value='0.25 0.5, 1'/>"), (Json{0.25, 0.5, 1.0}));
  EXPECT_EQ(exactly("<rgb name='reflectance' value='#ff0033'/>"), (Json{1.0, 0.0, 0.2}));
  EXPECT_EQ(exactly("<spectrum name='reflectance' value='0.3'/>"), 0.3);
  EXPECT_EQ(exactly("<spectrum name='reflectance' type='uniform'><float name='value' value='0.3'/>"
                    "</spectrum>"),
            0.3);
}

// 0x80 = 0.50196 is 0.21586 [IEC 61966-2-1].
TEST_F(ImportedColours, OfScreensAreDecoded) {
  expect_near(exactly("<srgb name='reflectance' value='#80ff00'/>"), {0.2158605, 1, 0}, 1e-6);
  expect_near(exactly("<srgb name='reflectance' value='0.04 0.5 1'/>"), {0.0030960, 0.2140411, 1},
              1e-6);
}

// Mitsuba 3.9 makes (0.833826, 0.689122, 0.265243) of this reflectance and (20.7108, 10.8546,
// 2.77115) of this emission; the fit to the observer is good to a percent of white.
TEST_F(ImportedColours, OfSpectraAreThoseOfTheObserver) {
  const std::string bands = "value='400:0.1, 500:0.5, 600:0.9, 700:0.2'/>";
  expect_near(nearly("<spectrum name='reflectance' " + bands, "a spectrum over wavelengths"),
              {0.833826, 0.689122, 0.265243}, 0.01);
  write("bands.spd", "# of a paint\r\n400 0.1\n500 0.5  # green\n\n600\t0.9\n700 0.2");
  EXPECT_EQ(
      nearly("<spectrum name='reflectance' filename='bands.spd'/>", "a spectrum over wavelengths"),
      nearly("<spectrum name='reflectance' " + bands, "a spectrum over wavelengths"));
  const Colour lamp =
      colour_of(Spectrum{{400, 0}, {500, 8}, {600, 15.6}, {700, 18.4}}, Light::emitted);
  EXPECT_NEAR(lamp[0], 20.7108, 0.2);
  EXPECT_NEAR(lamp[1], 10.8546, 0.2);
  EXPECT_NEAR(lamp[2], 2.77115, 0.2);
  const Colour flat = colour_of(Spectrum{{300, 0.5}, {900, 0.5}}, Light::reflected);
  for (const double channel : flat) EXPECT_NEAR(channel, 0.5, 1e-12);
}

TEST_F(ImportedColours, OfTexturesAreTheirMeans) {
  write_png("two.png", 2, {255, 0, 128, 0, 0, 128});
  const std::string bitmap =
      "<texture type='bitmap' name='reflectance'><string name='filename' "
      "value='two.png'/>";
  expect_near(nearly(bitmap + "</texture>", "the bitmap two.png"), {0.5, 0, 0.2158605}, 1e-6);
  expect_near(nearly(bitmap + "<boolean name='raw' value='true'/></texture>", "the bitmap two.png"),
              {0.5, 0, 128 / 255.0}, 1e-6);
  EXPECT_EQ(
      nearly("<texture type='checkerboard' name='reflectance'><float name='color0' value='1'/>"
             "<float name='color1' value='0.5'/></texture>",
             "a checkerboard"),
      0.75);
  write("no.jpg", "text");
  EXPECT_EQ(nearly("<texture type='bitmap' name='reflectance'><string name='filename' "
                   "value='no.jpg'/></texture>",
                   "no.jpg, which is no PNG,"),
            0.5);
}

TEST_F(ImportedColours, MayBeReferredTo) {
  EXPECT_EQ(
      first(approximate("<scene version='3.0.0'><texture type='checkerboard' id='board'/><shape "
                        "type='sphere'><bsdf type='diffuse'><ref name='reflectance' id='board'/>"
                        "</bsdf></shape>" +
                            lamp_and_camera + "</scene>",
                        "a checkerboard")),
      (0.4 + 0.2) / 2);
}

TEST_F(ImportedColours, ThatCannotBeAreRefused) {
  const auto said_of = [&](const std::string& colour) { return refused(reflecting(colour)); };
  EXPECT_SAYS(said_of("<rgb name='reflectance' value='1.5, 0, 0'/>"), "from 0 to 1");
  EXPECT_SAYS(said_of("<rgb name='reflectance' value='red'/>"), "\"red\" is no colour");
  EXPECT_SAYS(said_of("<rgb name='reflectance' value='1, 2'/>"), "is no colour");
  EXPECT_SAYS(said_of("<rgb name='reflectance' value='#12345g'/>"), "is no colour");
  EXPECT_SAYS(said_of("<rgb name='reflectance' value='nan'/>"), "is no colour");
  EXPECT_SAYS(said_of("<rgb name='reflectance' value='1e999'/>"), "is no colour");
  EXPECT_SAYS(said_of("<spectrum name='reflectance' value='500:1, 400:2'/>"), "in growing order");
  EXPECT_SAYS(said_of("<spectrum name='reflectance' filename='none.spd'/>"),
              "there is no file none.spd");
  for (const char* text : {"", "400 0.1 0.2\n", "400 0.1\n400 0.2\n", "400 red\n"}) {
    write("bad.spd", text);
    EXPECT_SAYS(said_of("<spectrum name='reflectance' filename='bad.spd'/>"),
                "bad.spd is no spectrum; each of its lines");
  }
  EXPECT_SAYS(said_of("<texture type='marble' name='reflectance'/>"), "\"marble\" is not known");
  EXPECT_SAYS(said_of("<texture type='bitmap' name='reflectance'><string name='filename' "
                      "value='none.png'/></texture>"),
              "there is no file none.png");
}

// By Mitsuba 3.9.1 in RGB a light of one value in a spectrum has 1.203, 0.947 and 0.907 times what it has as rgb.
TEST_F(ImportedColours, OfLightsOfEqualEnergyAreAReddishWhite) {
  const auto radiance = [&](const std::string& value) {
    return exact(
        scene_of("<shape type='sphere'><emitter type='area'><spectrum name='radiance' "
                 "value='" +
                 value + "'/></emitter></shape>"))["shapes"][0]["light"]["radiance"];
  };
  const Json white = radiance("2");
  ASSERT_EQ(white.size(), 3u);
  EXPECT_NEAR(white[0], 2 * 1.203, 0.005);
  EXPECT_NEAR(white[1], 2 * 0.947, 0.005);
  EXPECT_NEAR(white[2], 2 * 0.907, 0.005);
  EXPECT_EQ(radiance("1,2,3"), Json({1, 2, 3}));
}

// Of version 0.6 one value is as much of D65, which is white.
TEST_F(ImportedColours, OfOldLightsAreWhite) {
  const Json old = exact(
      "<scene version='0.6.0'><shape type='sphere'><emitter type='area'><spectrum "
      "name='radiance' value='2'/></emitter></shape>" +
      lamp_and_camera + "</scene>");
  EXPECT_EQ(old["shapes"][0]["light"]["radiance"], 2.0);
}

}  // namespace
}  // namespace wander::test
