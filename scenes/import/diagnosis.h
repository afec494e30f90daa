// All that can be said against an imported scene, and all that is imported as something else.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scenes/import/import_fault.h"
#include "scenes/import/xml_element.h"

namespace wander {

// What to do with what cannot be said exactly.
enum class Fidelity { exact, approximate };

class Diagnosis {
 public:
  explicit Diagnosis(Fidelity fidelity) : fidelity_(fidelity) {}

  void fault(const XmlElement& element, std::string_view what) { fault(element.place, what); }
  void fault(const XmlPlace& place, std::string_view what);

  // "A Beckmann lobe" is imported as "a GGX lobe of the same alpha": a fault if the import is to be
  // exact.
  void inexact(const XmlElement& element, std::string_view what, std::string_view instead);
  // Where the models of the two programs differ, or the file leaves open what it wants: told in any
  // case, never a fault.
  void note(const XmlElement& element, std::string_view what);

  bool has_faults() const { return !faults_.empty(); }
  // Throws ImportError if there are faults, in the order of their places.
  void require_sound() const;
  // In the order of their places.
  std::vector<ImportFault> approximations() const;

 private:
  Fidelity fidelity_;
  std::vector<ImportFault> faults_, approximations_;
};

}  // namespace wander
