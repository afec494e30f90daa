// What all parts of an import share: the objects that have an id, the folders of files, and the
// diagnosis.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scenes/import/diagnosis.h"
#include "scenes/import/xml_loader.h"

namespace wander {

class ImportContext {
 public:
  // The scene outlives the context.  Throws ImportError if objects refer to themselves by a detour,
  // or to each other too deep, so that whoever follows references comes to an end.
  ImportContext(const XmlScene& scene, Diagnosis& diagnosis);

  // What a <ref> means, and any other element itself; null if there is none.
  const XmlElement* known(const XmlElement& element) const;
  // The same, with a fault if there is none.
  const XmlElement* resolved(const XmlElement& element) const;
  // Empty if there is no such file.
  std::filesystem::path known_file(const std::string& name) const;
  // The same, with a fault.
  std::filesystem::path file(const XmlElement& element, const std::string& name) const;

  // Versions before 2 have other defaults.
  bool is_old() const { return scene_.version.starts_with("0."); }

  Diagnosis& diagnosis;

 private:
  void collect(const XmlElement& element);
  // How many references lead on from each other in what is open: a loop goes beyond every limit.
  int references_within(const XmlElement& element, int so_far);

  const XmlScene& scene_;
  std::map<std::string, const XmlElement*> objects_;
  std::map<const XmlElement*, int> references_;  // known of an object
};

}  // namespace wander
