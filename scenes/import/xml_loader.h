// Reading of Mitsuba's XML: one tree of elements from a file and all that it includes.
//
// Any input is safe to read: sizes, depths and numbers of elements are bounded, files that include
// each other are refused, and entities of a document type are not expanded.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scenes/import/diagnosis.h"

namespace wander {

// Values that replace $name, by name.
using XmlParameters = std::map<std::string, std::string, std::less<>>;

struct XmlScene {
  XmlElement root;
  std::string version;
  std::vector<std::filesystem::path> folders;  // where files are looked for, in this order
};

// Faults of the files go into the diagnosis; throws ImportError where nothing more can be read.
XmlScene load_xml(const std::filesystem::path& path, const XmlParameters& parameters,
                  Diagnosis& diagnosis);

// The first of the folders that has the file; empty if none has.
std::filesystem::path find_file(const std::vector<std::filesystem::path>& folders,
                                const std::string& name);

}  // namespace wander
