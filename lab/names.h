// The methods as the command line explains them.  Names and order are those of method_names().
#pragma once

#include <array>
#include <string_view>

namespace wander {

enum class MethodFamily { monte_carlo, markov_chain };

struct MethodName {
  std::string_view name;
  MethodFamily family;
  std::string_view summary;
};

inline constexpr std::array methods{
    MethodName{"pt", MethodFamily::monte_carlo,
               "path tracing from the sensor, with next-event estimation"},
    MethodName{"lt", MethodFamily::monte_carlo,
               "light tracing from the lights, with next-event estimation"},
    MethodName{"bdpt", MethodFamily::monte_carlo, "bidirectional path tracing"},
    MethodName{"mlt", MethodFamily::markov_chain,
               "Metropolis light transport in path space, all mutations"},
    MethodName{"pssmlt", MethodFamily::markov_chain,
               "Metropolis in primary sample space, whole bidirectional samples (Kelemen)"},
    MethodName{"mmlt", MethodFamily::markov_chain,
               "multiplexed Metropolis: primary sample space, a chain for each path length"},
    MethodName{"pt-naive", MethodFamily::monte_carlo, "path tracing that must hit a light"},
    MethodName{"lt-naive", MethodFamily::monte_carlo, "light tracing that must hit the sensor"},
};

}  // namespace wander
