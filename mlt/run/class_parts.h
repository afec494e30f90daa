// Which side of a pooled film (partition.h) carries the light of which class of path.  Of the states of
// chains, each of which counts as the light that it shows, a share b E_π[1_class] is the light of the class, and b E_π[1_class w_M] what
// of it is left to the chains; the rest, b E_π[1_class w_B], is the samples'.
#pragma once

#include <cstddef>
#include <vector>

#include "core/path_class.h"

namespace wander {

class ClassParts {
 public:
  // A state that shows so much light, and w_M of it.
  void add(PathClass path_class, double of_chains, double light) {
    Part& part = *entries_of(parts_, classes_.index(path_class));
    part.states += light;
    part.of_chains += light * of_chains;
  }
  std::size_t size() const { return classes_.size(); }
  PathClass path_class(std::size_t index) const { return classes_.code(index); }
  double states(std::size_t index) const { return parts_[index].states; }
  double of_chains(std::size_t index) const { return parts_[index].of_chains; }  // Σ of light times w_M

  template <class Archive>
  void serialize(Archive& archive) {
    archive(classes_, parts_);
  }

 private:
  struct Part {
    double states = 0, of_chains = 0;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(states, of_chains);
    }
  };

  ClassTable classes_;
  std::vector<Part> parts_ = room_for_classes<Part>();
};

}  // namespace wander
