#include "scenes/import/diagnosis.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace wander {

namespace {

constexpr std::size_t most_faults = 100;

std::string lines_of(const std::vector<ImportFault>& faults) {
  std::string lines;
  for (const ImportFault& fault : faults) lines += (lines.empty() ? "" : "\n") + line_of(fault);
  return lines;
}

auto key(const ImportFault& fault) {
  return std::tie(fault.file, fault.line, fault.column, fault.path, fault.what);
}

std::vector<ImportFault> sorted(std::vector<ImportFault> faults) {
  std::ranges::stable_sort(
      faults, [](const ImportFault& a, const ImportFault& b) { return key(a) < key(b); });
  return faults;
}

// What is referred to twice may be told twice; told is it once.
void add(std::vector<ImportFault>& list, const XmlPlace& place, std::string what) {
  if (list.size() > most_faults) return;
  ImportFault fault{*place.file, place.line, place.column, place.path, std::move(what)};
  if (std::ranges::none_of(list,
                           [&](const ImportFault& known) { return key(known) == key(fault); }))
    list.push_back(std::move(fault));
  if (list.size() > most_faults)
    list.back().what = fmt::format("more like these follow; these are the first {}", most_faults);
}

}  // namespace

std::string line_of(const ImportFault& fault) {
  return fmt::format("{}:{}:{}: {}: {}", fault.file, fault.line, fault.column, fault.path,
                     fault.what);
}

ImportError::ImportError(std::vector<ImportFault> found)
    : std::runtime_error(lines_of(found)), faults(std::move(found)) {}

void Diagnosis::fault(const XmlPlace& place, std::string_view what) {
  add(faults_, place, std::string(what));
}

void Diagnosis::inexact(const XmlElement& element, std::string_view what,
                        std::string_view instead) {
  if (fidelity_ == Fidelity::exact)
    fault(element,
          fmt::format("{} cannot be said exactly; --approximate imports {}", what, instead));
  else
    note(element, fmt::format("{} is imported as {}", what, instead));
}

void Diagnosis::note(const XmlElement& element, std::string_view what) {
  add(approximations_, element.place, std::string(what));
}

std::vector<ImportFault> Diagnosis::approximations() const { return sorted(approximations_); }

void Diagnosis::require_sound() const {
  if (!faults_.empty()) throw ImportError(sorted(faults_));
}

}  // namespace wander
