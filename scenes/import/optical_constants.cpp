#include "scenes/import/optical_constants.h"

#include <algorithm>

namespace wander {

namespace {

// [Hecht, Optics], as Mitsuba names and rounds them.
constexpr std::pair<std::string_view, double> indices[] = {
    {"vacuum", 1.0},      {"helium", 1.000036},        {"hydrogen", 1.000132},
    {"air", 1.000277},    {"carbon dioxide", 1.00045}, {"water", 1.3330},
    {"acetone", 1.36},    {"ethanol", 1.361},          {"carbon tetrachloride", 1.461},
    {"glycerol", 1.4729}, {"benzene", 1.501},          {"silicone oil", 1.52045},
    {"bromine", 1.661},   {"water ice", 1.31},         {"fused quartz", 1.458},
    {"pyrex", 1.470},     {"acrylic glass", 1.49},     {"polypropylene", 1.49},
    {"bk7", 1.5046},      {"sodium chloride", 1.544},  {"amber", 1.55},
    {"pet", 1.5750},      {"diamond", 2.419},
};

// Measured spectra, mostly of [Palik], in linear Rec. 709.
constexpr std::pair<std::string_view, MetalConstants> complex_indices[] = {
    {"Ag", {{0.15528, 0.11673, 0.13839}, {4.8284, 3.1222, 2.1469}}},
    {"Al", {{1.6575, 0.8804, 0.52124}, {9.2238, 6.2695, 4.837}}},
    {"AlAs", {{3.6053, 3.2329, 2.2163}, {0.00067944, 0, 0.0075127}}},
    {"Au", {{0.14304, 0.37531, 1.4421}, {3.983, 2.3856, 1.6034}}},
    {"Be", {{4.185, 3.185, 2.7841}, {3.8355, 3.0101, 2.869}}},
    {"Cr", {{4.3697, 2.9165, 1.6549}, {5.2066, 4.2313, 3.7547}}},
    {"CsI", {{2.1449, 1.7023, 1.6624}, {0, 0, 0}}},
    {"Cu", {{0.201, 0.92375, 1.1022}, {3.9133, 2.4531, 2.1421}}},
    {"Cu2O", {{3.5518, 2.9499, 2.7519}, {0.11421, 0.1939, 0.60613}}},
    {"CuO", {{3.2475, 2.4478, 2.2102}, {0.52109, 0.57003, 0.72218}}},
    {"Hg", {{2.3989, 1.44, 0.90957}, {6.3276, 4.3719, 3.4218}}},
    {"HgTe", {{4.779, 3.2312, 2.6599}, {1.6316, 1.5808, 1.7293}}},
    {"Ir", {{3.0863, 2.0822, 1.6179}, {5.5922, 4.0671, 3.2673}}},
    {"K", {{0.064043, 0.04641, 0.038185}, {2.1042, 1.3489, 0.91313}}},
    {"Li", {{0.26579, 0.19562, 0.22095}, {3.5402, 2.3111, 1.6686}}},
    {"MgO", {{2.0896, 1.6507, 1.5949}, {0, 0, 0}}},
    {"Mo", {{4.484, 3.5251, 2.7763}, {4.1114, 3.4208, 3.1506}}},
    {"Na", {{0.060269, 0.056141, 0.061988}, {3.1793, 2.1125, 1.579}}},
    {"Nb", {{3.4201, 2.7901, 2.3956}, {3.4414, 2.7377, 2.5798}}},
    {"Ni", {{2.3673, 1.6634, 1.4671}, {4.4988, 3.0501, 2.3454}}},
    {"Rh", {{2.5858, 1.8602, 1.5543}, {6.7823, 4.703, 3.9761}}},
    {"Se-e", {{5.7229, 4.1657, 4.0813}, {0.87114, 1.1052, 1.5653}}},
    {"Se", {{4.0583, 2.8429, 2.8209}, {0.75405, 0.63844, 0.52181}}},
    {"SiC", {{3.1723, 2.526, 2.4794}, {0, 0, 1.0192e-05}}},
    {"SnTe", {{4.5243, 1.9816, 1.2816}, {0, 0, 0}}},
    {"Ta", {{2.0627, 2.3929, 2.6279}, {2.4084, 1.7415, 1.947}}},
    {"Te-e", {{7.5089, 4.2964, 2.37}, {5.5839, 4.9472, 3.9976}}},
    {"Te", {{7.3902, 4.4821, 2.6371}, {3.256, 3.5271, 3.2921}}},
    {"ThF4", {{1.8307, 1.4422, 1.3877}, {0, 0, 0}}},
    {"TiC", {{3.7005, 2.8374, 2.5823}, {3.2656, 2.3516, 2.1728}}},
    {"TiN", {{1.6484, 1.1505, 1.3798}, {3.3683, 1.9435, 1.1021}}},
    {"TiO2-e", {{3.1066, 2.5132, 2.5824}, {2.9752e-05, 0, 0.0001827}}},
    {"TiO2", {{3.4566, 2.8017, 2.9052}, {0.00010527, 0, 0.00065289}}},
    {"VC", {{3.6576, 2.7527, 2.5327}, {3.0683, 2.1987, 1.9632}}},
    {"VN", {{2.8656, 2.1192, 1.9401}, {3.0322, 2.0561, 1.6163}}},
    {"V", {{4.2776, 3.513, 2.7611}, {3.4913, 2.8895, 3.1115}}},
    {"W", {{4.3708, 3.3003, 2.9984}, {3.5006, 2.6049, 2.2732}}},
    {"a-C", {{2.944, 2.2271, 1.9682}, {0.88746, 0.7993, 0.81529}}},
    {"d-C", {{2.7087, 2.3188, 2.2289}, {0, 0, 0}}},
};

template <class Table>
auto find_in(const Table& table, std::string_view name) {
  return std::ranges::find_if(table, [&](const auto& entry) { return entry.first == name; });
}

template <class Table>
std::vector<std::string> names_in(const Table& table) {
  std::vector<std::string> names;
  for (const auto& entry : table) names.emplace_back(entry.first);
  return names;
}

std::string lower(std::string_view name) {
  std::string result(name);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

}  // namespace

std::optional<double> index_of_refraction(std::string_view name) {
  const auto found = find_in(indices, lower(name));
  if (found == std::end(indices)) return {};
  return found->second;
}

std::vector<std::string> substances() { return names_in(indices); }

std::optional<MetalConstants> metal_constants(std::string_view name) {
  constexpr std::string_view source = "_palik";
  if (name.ends_with(source)) name.remove_suffix(source.size());
  const auto found = find_in(complex_indices, name);
  if (found == std::end(complex_indices)) return {};
  return found->second;
}

std::vector<std::string> metals() { return names_in(complex_indices); }

MetalConstants relative(const MetalConstants& metal, double outside) {
  MetalConstants result = metal;
  for (std::size_t i = 0; i < result.eta.size(); ++i) {
    result.eta[i] /= outside;
    result.k[i] /= outside;
  }
  return result;
}

std::array<double, 3> normal_reflectance(const MetalConstants& metal) {
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double eta = metal.eta[i], k = metal.k[i];
    result[i] = ((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k);
  }
  return result;
}

}  // namespace wander
