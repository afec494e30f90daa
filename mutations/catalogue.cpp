#include "mutations/catalogue.h"

#include <algorithm>

namespace wander {

namespace {

template <class M>
constexpr std::string_view word_of() {
  if constexpr (requires { M::word; })
    return M::word;
  else
    return M::name;
}

template <class M>
double share_of([[maybe_unused]] double large_step) {
  if constexpr (requires { M::share(large_step); })
    return M::share(large_step);
  else
    return 1;
}

template <class M>
constexpr double auto_weight_of() {
  if constexpr (requires { M::auto_weight; })
    return M::auto_weight;
  else
    return 1;
}

template <class M>
std::string_view left_out([[maybe_unused]] const Requirements& scene) {
  if constexpr (requires { M::left_out(scene); })
    return M::left_out(scene);
  else
    return {};
}

// An aggregate could be made of a number, too, but its parameters are not the length of paths.
template <class M>
M make([[maybe_unused]] double kernel, [[maybe_unused]] int max_vertices) {
  if constexpr (!std::is_aggregate_v<M> && std::is_constructible_v<M, int>)
    return M(max_vertices);
  else if constexpr (requires { M{}.scaled(kernel); })
    return M{}.scaled(kernel);
  else
    return M{};
}

template <class M>
double weight_of(const FamilySettings& settings) {
  const MutationWeights& weights = settings.weights;
  if (weights.empty()) return share_of<M>(settings.large_step);
  const auto given = std::ranges::find(weights, word_of<M>(), &MutationWeights::value_type::first);
  return given == weights.end() ? 0 : given->second * share_of<M>(settings.large_step);
}

template <class M>
void choose(const Requirements& scene, MutationChoice& choice) {
  const std::string name(M::name), word(word_of<M>());
  if (const std::string_view why = left_out<M>(scene); !why.empty()) {
    choice.left_out[name] = why;
    return;
  }
  choice.taken.push_back(name);
  const auto known = std::ranges::find(choice.weights, word, &MutationWeights::value_type::first);
  if (known == choice.weights.end()) choice.weights.emplace_back(word, auto_weight_of<M>());
}

// Calls f.template operator()<M>() for every mutation of the family, in its order.
template <class... Ms, class F>
void for_each_mutation(const Mixture<Ms...>*, F&& f) {
  (f.template operator()<Ms>(), ...);
}
constexpr const Family* family = nullptr;

template <class... Ms>
Mixture<Ms...> made(const Mixture<Ms...>*, const FamilySettings& settings, int max_vertices) {
  return Mixture<Ms...>({weight_of<Ms>(settings)...}, make<Ms>(settings.kernel, max_vertices)...);
}

}  // namespace

std::vector<std::string_view> mutation_words() {
  std::vector<std::string_view> words;
  for_each_mutation(family, [&]<class M>() {
    if (std::ranges::find(words, word_of<M>()) == words.end()) words.push_back(word_of<M>());
  });
  return words;
}

MutationChoice choose_mutations(const Requirements& scene) {
  MutationChoice choice;
  for_each_mutation(family, [&]<class M>() { choose<M>(scene, choice); });
  return choice;
}

Family make_family(const FamilySettings& settings, int max_vertices) {
  return made(family, settings, max_vertices);
}

Family make_family(const FamilySettings& settings, const Requirements& scene) {
  FamilySettings chosen = settings;
  if (chosen.weights.empty()) chosen.weights = choose_mutations(scene).weights;
  return make_family(chosen, scene.max_vertices);
}

}  // namespace wander
