#include "mutations/catalogue.h"

#include <algorithm>
#include <concepts>

#include "core/transport.h"
#include "mlt/check/kernel_check.h"

namespace wander {

namespace {

template <class... Ms, class... Spaces>
consteval bool are_mutations_of(const Mixture<Ms...>*, const Spaces*...) {
  const auto in_all = []<class M>(const M*) { return (Mutation<M, Spaces, Rng> && ...); };
  return (in_all(static_cast<const Ms*>(nullptr)) && ...);
}
constexpr const Family* family = nullptr;
static_assert(are_mutations_of(family, static_cast<const Transport<Flatland>*>(nullptr),
                               static_cast<const Transport<FlatlandSingle>*>(nullptr),
                               static_cast<const Transport<Spaceland>*>(nullptr)));

// Calls f.template operator()<M>() for every mutation of the family, in its order.
template <class... Ms, class F>
void for_each_mutation(const Mixture<Ms...>*, F&& f) {
  (f.template operator()<Ms>(), ...);
}

const MutationWeight* find(const MutationWeights& weights, std::string_view word) {
  const auto found = std::ranges::find(weights, word, &MutationWeight::word);
  return found == weights.end() ? nullptr : &*found;
}

// With the parameters that its file states, or for the longest path.
template <class M>
M usual([[maybe_unused]] int max_vertices) {
  if constexpr (std::default_initializable<M>)
    return M{};
  else
    return M(max_vertices);
}

template <class M>
M make(const FamilySettings& settings, int max_vertices) {
  M mutation = traits<M>.scaled(usual<M>(max_vertices), settings.kernel);
  const MutationWeight* given = find(settings.weights, traits<M>.word);
  if (given == nullptr) return mutation;
  for (const ParameterSetting& set : given->parameters)
    for (const Parameter<M>& parameter : traits<M>.parameters) {
      if (parameter.name == set.name) parameter.set(mutation, {set.smallest, set.largest});
    }
  return mutation;
}

template <class M>
double weight_of(const FamilySettings& settings) {
  const double share = traits<M>.share(settings.large_step);
  if (settings.weights.empty()) return share;
  const MutationWeight* given = find(settings.weights, traits<M>.word);
  return given == nullptr ? 0 : given->weight * share;
}

template <class M>
void choose(const Requirements& scene, MutationChoice& choice) {
  const std::string name(M::name), word(traits<M>.word);
  if (const std::string_view why = traits<M>.left_out(scene); !why.empty()) {
    choice.left_out[name] = why;
    return;
  }
  choice.taken.push_back(name);
  if (find(choice.weights, word) == nullptr)
    choice.weights.push_back({word, traits<M>.auto_weight});
}

template <class M>
void add_parameters(std::vector<ParameterFacts>& facts) {
  constexpr int any_length = 2;
  const M mutation = usual<M>(any_length);
  for (const Parameter<M>& parameter : traits<M>.parameters) {
    const Ends ends = parameter.ends(mutation);
    facts.push_back(
        {parameter.name, parameter.meaning, ends.smallest, ends.largest, parameter.most});
  }
}

template <class... Ms>
Mixture<Ms...> made(const Mixture<Ms...>*, const FamilySettings& settings, int max_vertices) {
  return Mixture<Ms...>({weight_of<Ms>(settings)...}, make<Ms>(settings, max_vertices)...);
}

}  // namespace

std::vector<std::string_view> mutation_words() {
  std::vector<std::string_view> words;
  for_each_mutation(family, [&]<class M>() {
    if (std::ranges::find(words, traits<M>.word) == words.end()) words.push_back(traits<M>.word);
  });
  return words;
}

double auto_weight_of(std::string_view word) {
  double weight = 0;
  for_each_mutation(family, [&]<class M>() {
    if (traits<M>.word == word) weight = traits<M>.auto_weight;
  });
  return weight;
}

std::vector<ParameterFacts> parameters_of(std::string_view word) {
  std::vector<ParameterFacts> facts;
  for_each_mutation(family, [&]<class M>() {
    if (traits<M>.word == word) add_parameters<M>(facts);
  });
  return facts;
}

MutationChoice choose_mutations(const Requirements& scene) {
  MutationChoice choice;
  for_each_mutation(family, [&]<class M>() { choose<M>(scene, choice); });
  return choice;
}

int count_of_mutations() { return Family::count; }

std::vector<std::string_view> names_taken(const FamilySettings& settings,
                                          const Requirements& scene) {
  std::vector<std::string_view> names;
  for (const std::size_t i : selectable(make_family(settings, scene)))
    names.push_back(Family::names[i]);
  return names;
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
