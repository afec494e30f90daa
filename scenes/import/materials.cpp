#include "scenes/import/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "scenes/format/json_text.h"
#include "scenes/format/scene_file_nearest.h"
#include "scenes/import/bitmap.h"
#include "scenes/import/optical_constants.h"
#include "scenes/import/plugin.h"

namespace wander {

using nlohmann::ordered_json;
using Presence = ImportedMaterial::Presence;
using Back = PlacedSurface::Back;

// Reads one bsdf, and those in it.
class BsdfReader {
 public:
  using Made = ImportedMaterials::Made;

  BsdfReader(const ImportContext& context, MeshStore& files, MeshCoordinates coordinates)
      : context_(context), files_(files), coordinates_(coordinates) {}

  Made made_of(const XmlElement& bsdf) const {
    for (const auto& [type, read] : kinds())
      if (type == bsdf.type()) {
        Plugin plugin(bsdf, context_);
        const Made made = (this->*read)(plugin);
        plugin.done();
        return made;
      }
    std::vector<std::string> known;
    for (const auto& [type, read] : kinds()) known.emplace_back(type);
    context_.diagnosis.fault(bsdf,
                             fmt::format("the bsdf \"{}\" is not known; {}", excerpt(bsdf.type()),
                                         suggestion(bsdf.type(), known)));
    return {};
  }

 private:
  using Read = Made (BsdfReader::*)(Plugin&) const;
  static const std::vector<std::pair<std::string_view, Read>>& kinds();  // by type

  Diagnosis& diagnosis() const { return context_.diagnosis; }

  static Made diffuse_of(const Colour& colour) {
    return {{{"type", "diffuse"}, {"reflectance", json_of(colour)}}, Presence::here, Back::dark};
  }

  Made diffuse(Plugin& bsdf) const {
    const char* const key = bsdf.has("diffuse_reflectance") ? "diffuse_reflectance" : "reflectance";
    const auto bitmap = coordinates_ == MeshCoordinates::none
                            ? std::nullopt
                            : placed_bitmap(bsdf.element(), context_);
    if (!bitmap) return diffuse_of(bsdf.reflectance(key, 0.5));
    bsdf.ignore({key});
    std::ifstream stream(bitmap->path, std::ios::binary);
    ordered_json json{{"type", "diffuse"}};
    json["reflectance"]["texture"] = files_.add({std::istreambuf_iterator<char>(stream), {}},
                                                bitmap->path.stem().string() + ".png");
    return {std::move(json), Presence::here, Back::dark};
  }

  Made two_sided(Plugin& bsdf) const {
    const auto inner = bsdf.objects("bsdf");
    if (inner.empty() || inner.size() > 2) {
      diagnosis().fault(bsdf.element(), "a twosided bsdf holds one bsdf, or two");
      return {};
    }
    if (inner.size() == 2 && inner[0] != inner[1])
      diagnosis().inexact(bsdf.element(), "another bsdf on the back", "that of the front");
    Made made = made_of(*inner[0]);
    made.back = Back::same;
    return made;
  }

  // Nothing of one that reflects all light.
  std::optional<MetalConstants> constants_of(Plugin& bsdf) const {
    const std::string name = bsdf.text("material", context_.is_old() ? "Cu" : "none");
    if (bsdf.has("eta") || bsdf.has("k")) {
      const MetalConstants given{bsdf.refraction("eta", 0), bsdf.refraction("k", 1)};
      if (std::ranges::all_of(given.eta, [](double eta) { return eta == 0; })) return {};
      return given;
    }
    if (name == "none") return {};
    const auto known = metal_constants(name);
    if (!known)
      diagnosis().fault(bsdf.where("material"),
                        fmt::format("the metal \"{}\" is not known; {}", excerpt(name),
                                    suggestion(name, metals())));
    return known;
  }

  // With its reflectance, or eta and k.
  ordered_json metal(Plugin& bsdf, ordered_json json) const {
    const Colour tint = bsdf.reflectance("specular_reflectance", 1);
    const double outside = context_.is_old() ? index(bsdf, "ext_eta", "air") : 1;
    const auto absolute = constants_of(bsdf);
    if (!absolute) {
      json["reflectance"] = json_of(tint);
      return json;
    }
    const MetalConstants constants = relative(*absolute, outside);
    if (tint == Colour{1, 1, 1}) {
      json["eta"] = json_of(constants.eta);
      json["k"] = json_of(constants.k);
      return json;
    }
    diagnosis().inexact(bsdf.element(), "Fresnel's factor of a metal with a tint",
                        "a constant, its value along the normal");
    Colour reflectance = normal_reflectance(constants);
    for (std::size_t i = 0; i < 3; ++i) reflectance[i] *= tint[i];
    json["reflectance"] = json_of(reflectance);
    return json;
  }

  Made conductor(Plugin& bsdf) const {
    ordered_json json = metal(bsdf, {{"type", "conductor"}});
    if (json.contains("reflectance")) json["type"] = "mirror";
    return {std::move(json), Presence::here, Back::dark};
  }

  double roughness(Plugin& bsdf) const {
    const std::string distribution = bsdf.text("distribution", "beckmann");
    if (distribution == "beckmann" || distribution == "as" || distribution == "phong")
      diagnosis().inexact(bsdf.where("distribution"),
                          distribution == "beckmann" ? "a Beckmann lobe" : "a Phong lobe",
                          "a GGX lobe of the same alpha");
    else if (distribution != "ggx")
      diagnosis().fault(
          bsdf.where("distribution"),
          fmt::format("the distribution \"{}\" is not known; known are ggx and beckmann",
                      excerpt(distribution)));
    else
      diagnosis().note(bsdf.element(),
                       "masking is height-correlated here, and separable in Mitsuba");
    double alpha = roughness_of(bsdf, "alpha", 0.1);
    if (bsdf.has("alpha_u") || bsdf.has("alpha_v")) {
      const double u = roughness_of(bsdf, "alpha_u", 0.1), v = roughness_of(bsdf, "alpha_v", 0.1);
      alpha = std::sqrt(u * v);
      if (u != v)
        diagnosis().inexact(bsdf.where("alpha_u"), "an anisotropic lobe",
                            "an isotropic one, of the geometric mean");
    }
    bsdf.ignore({"sample_visible", "nonlinear"});
    if (alpha > 1)
      diagnosis().inexact(bsdf.where("alpha"), "an alpha above 1", "1");
    else if (!(alpha > 0))
      diagnosis().fault(bsdf.where("alpha"), "alpha is > 0; for none use the smooth bsdf");
    return std::min(alpha, 1.0);
  }

  // Of a texture its mean.
  double roughness_of(Plugin& bsdf, std::string_view name, double otherwise) const {
    if (bsdf.where(name).tag != "texture" && bsdf.where(name).tag != "ref")
      return bsdf.number(name, otherwise);
    const Colour colour = bsdf.reflectance(name, otherwise);
    return (colour[0] + colour[1] + colour[2]) / 3;
  }

  Made rough_conductor(Plugin& bsdf) const {
    const double alpha = roughness(bsdf);
    return {metal(bsdf, {{"type", "rough_conductor"}, {"roughness", alpha}}), Presence::here,
            Back::dark};
  }

  double index(Plugin& bsdf, std::string_view key, std::string_view otherwise) const {
    double index = 0;
    if (bsdf.has(key) && bsdf.where(key).tag != "string") {
      index = bsdf.number(key, 1);
    } else {
      const std::string name = bsdf.text(key, otherwise);
      const auto known = index_of_refraction(name);
      if (!known)
        diagnosis().fault(bsdf.where(key),
                          fmt::format("the substance \"{}\" is not known; {}", excerpt(name),
                                      suggestion(name, substances())));
      index = known.value_or(1);
    }
    if (index > 0) return index;
    diagnosis().fault(bsdf.where(key), "an index of refraction is > 0");
    return 1;
  }

  void refuse_tint(Plugin& bsdf) const {
    for (const char* name : {"specular_reflectance", "specular_transmittance"}) {
      if (!bsdf.has(name)) continue;
      if (bsdf.reflectance(name, 1) != Colour{1, 1, 1})
        diagnosis().inexact(bsdf.where(name), "tinted glass", "clear glass");
    }
  }

  Made interface(Plugin& bsdf, ordered_json json) const {
    json["ior"] = index(bsdf, "int_ior", "bk7");
    if (const double outside = index(bsdf, "ext_ior", "air"); outside != 1)
      json["exterior_ior"] = outside;
    refuse_tint(bsdf);
    return {std::move(json), Presence::here, Back::same};
  }

  Made dielectric(Plugin& bsdf) const { return interface(bsdf, {{"type", "dielectric"}}); }

  Made rough_dielectric(Plugin& bsdf) const {
    const double alpha = roughness(bsdf);
    return interface(bsdf, {{"type", "rough_dielectric"}, {"roughness", alpha}});
  }

  Made thin_dielectric(Plugin& bsdf) const {
    bsdf.ignore({"int_ior", "ext_ior", "specular_reflectance", "specular_transmittance"});
    diagnosis().inexact(bsdf.element(), "a thin pane of glass", "nothing");
    return {nullptr, Presence::absent, Back::same};
  }

  Made null(Plugin&) const { return {nullptr, Presence::absent, Back::same}; }

  Made coated(Plugin& bsdf) const {
    bsdf.ignore({"int_ior", "ext_ior", "nonlinear", "specular_reflectance", "alpha", "alpha_u",
                 "alpha_v", "distribution", "sample_visible", "exponent", "variant"});
    diagnosis().inexact(bsdf.element(), fmt::format("a {}", bsdf.type()),
                        "diffuse, without its gloss");
    return diffuse_of(bsdf.reflectance("diffuse_reflectance", 0.5));
  }

  Made principled(Plugin& bsdf) const {
    bsdf.ignore({"roughness", "anisotropic", "metallic", "spec_trans", "eta", "specular",
                 "spec_tint", "sheen", "sheen_tint", "flatness", "clearcoat", "clearcoat_gloss",
                 "diff_trans", "diffuse_reflectance_sampling_rate", "main_specular_sampling_rate",
                 "clearcoat_sampling_rate"});
    diagnosis().inexact(bsdf.element(), "a principled bsdf", "diffuse, of its base colour");
    return diffuse_of(bsdf.reflectance("base_color", 0.5));
  }

  Made only_inner(Plugin& bsdf, std::string_view what, std::string_view instead) const {
    const auto inner = bsdf.objects("bsdf");
    if (inner.size() != 1) {
      diagnosis().fault(bsdf.element(), fmt::format("a {} holds one bsdf", bsdf.type()));
      return {};
    }
    diagnosis().inexact(bsdf.element(), what, instead);
    return made_of(*inner.front());
  }

  Made mask(Plugin& bsdf) const {
    const Colour opacity = bsdf.reflectance("opacity", 0.5);
    const bool is_seen = opacity[0] + opacity[1] + opacity[2] >= 1.5;
    Made made =
        only_inner(bsdf, "a mask", is_seen ? "opaque" : "nothing, being mostly transparent");
    if (!is_seen) made.presence = Presence::absent;
    return made;
  }

  Made bumped(Plugin& bsdf) const {
    bsdf.ignore({"scale", "normalmap"});
    bsdf.objects("texture");
    return only_inner(bsdf, fmt::format("a {}", bsdf.type()), "a smooth surface");
  }

  Made blended(Plugin& bsdf) const {
    const Colour weight = bsdf.reflectance("weight", 0.5);
    const auto inner = bsdf.objects("bsdf");
    if (inner.size() != 2) {
      diagnosis().fault(bsdf.element(), "a blendbsdf holds two bsdfs");
      return {};
    }
    diagnosis().inexact(bsdf.element(), "a blend of two bsdfs", "the one that weighs more");
    return made_of(*inner[weight[0] + weight[1] + weight[2] > 1.5 ? 1 : 0]);
  }

  const ImportContext& context_;
  MeshStore& files_;
  MeshCoordinates coordinates_;
};

const std::vector<std::pair<std::string_view, BsdfReader::Read>>& BsdfReader::kinds() {
  static const std::vector<std::pair<std::string_view, Read>> all{
      {"diffuse", &BsdfReader::diffuse},
      {"twosided", &BsdfReader::two_sided},
      {"conductor", &BsdfReader::conductor},
      {"roughconductor", &BsdfReader::rough_conductor},
      {"dielectric", &BsdfReader::dielectric},
      {"roughdielectric", &BsdfReader::rough_dielectric},
      {"thindielectric", &BsdfReader::thin_dielectric},
      {"plastic", &BsdfReader::coated},
      {"roughplastic", &BsdfReader::coated},
      {"phong", &BsdfReader::coated},
      {"ward", &BsdfReader::coated},
      {"principled", &BsdfReader::principled},
      {"mask", &BsdfReader::mask},
      {"bumpmap", &BsdfReader::bumped},
      {"normalmap", &BsdfReader::bumped},
      {"blendbsdf", &BsdfReader::blended},
      {"null", &BsdfReader::null},
  };
  return all;
}

ImportedMaterial ImportedMaterials::of(const XmlElement& bsdf, MeshCoordinates coordinates) {
  if (!placed_bitmap(bsdf, context_)) coordinates = MeshCoordinates::none;  // they say nothing
  const std::pair key(&bsdf, coordinates);
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  const Made made = BsdfReader(context_, files_, coordinates).made_of(bsdf);
  ImportedMaterial material;
  material.presence = made.presence;
  if (!made.json.is_null() && made.presence == Presence::here) {
    const std::string type = made.json["type"];
    const bool is_black = made.json.value("reflectance", ordered_json()) == 0;
    material.back = is_black ? Back::same : made.back;
    material.refracts = type == "dielectric" || type == "rough_dielectric";
    if (!(type == "diffuse" && is_black)) material.name = name_of(made.json, &bsdf);
  }
  known_.emplace(key, material);
  return material;
}

ImportedMaterial ImportedMaterials::usual() {
  return {name_of({{"type", "diffuse"}, {"reflectance", 0.5}}, nullptr), Presence::here, Back::dark,
          false};
}

// Its id, else its type and a number; those without an id that are equal are one.
std::string ImportedMaterials::name_of(const ordered_json& json, const XmlElement* bsdf) {
  std::string name = bsdf == nullptr ? "" : printable(bsdf->attribute("id"));
  if (name.empty()) {
    if (const auto known = unnamed_.find(json.dump()); known != unnamed_.end())
      return known->second;
    name = json["type"];
  }
  const std::string first = name;
  while (!names_.insert(name).second) name = fmt::format("{}_{}", first, 1 + ++numbers_[first]);
  if (bsdf == nullptr || !bsdf->has("id")) unnamed_.emplace(json.dump(), name);
  entries_.push_back({name, json, bsdf});
  return name;
}

}  // namespace wander
