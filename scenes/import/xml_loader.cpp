#include "scenes/import/xml_loader.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <utility>

#include "scenes/format/byte_order_mark.h"
#include "scenes/format/json_text.h"
#include "scenes/format/scene_file_nearest.h"

namespace wander {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largest_file = std::uintmax_t{64} << 20;
constexpr int deepest = 64;  // elements within each other
constexpr std::size_t most_includes = 1000, deepest_include = 15, most_elements = 2'000'000;

bool is_name_character(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

std::string_view words_of(pugi::xml_parse_status status) {
  switch (status) {
    case pugi::status_end_element_mismatch:
      return "an element ends that is not the one that is open, or none ends that is";
    case pugi::status_bad_start_element:
      return "an element has no name, or does not end with >";
    case pugi::status_bad_end_element:
      return "the end of an element is </NAME>";
    case pugi::status_bad_attribute:
      return "an attribute is NAME=\"VALUE\"";
    case pugi::status_bad_comment:
      return "a comment does not end";
    case pugi::status_bad_cdata:
    case pugi::status_bad_pcdata:
      return "a text does not end";
    case pugi::status_bad_doctype:
    case pugi::status_bad_pi:
    case pugi::status_unrecognized_tag:
      return "what begins with < here is no element";
    case pugi::status_no_document_element:
      return "there is no element in it";
    default:
      return "it cannot be read";
  }
}

struct Document {
  std::shared_ptr<const std::string> file;
  std::string text;
  pugi::xml_document xml;
};

class Loader {
 public:
  Loader(const XmlParameters& given, Diagnosis& diagnosis)
      : given_(given), values_(given), diagnosis_(diagnosis) {}

  XmlScene load(const fs::path& path) {
    const fs::path folder = path.parent_path();
    scene_.folders.push_back(folder.empty() ? "." : folder);
    const XmlPlace start{std::make_shared<std::string>(path.string()), 1, 1, "/"};
    include(path, start, [&](pugi::xml_node root, const XmlPlace& place) {
      scene_.root = read(root, place);
      scene_.version = scene_.root.attribute("version");
    });
    if (!scene_.root.tag.empty()) refuse_unused();
    return std::move(scene_);
  }

 private:
  // What a scene that could not be read has nobody knows.
  void refuse_unused() const {
    for (const auto& [name, value] : given_)
      if (!used_.contains(name))
        diagnosis_.fault(scene_.root, fmt::format("-D {}: the scene has no ${}; {}", excerpt(name),
                                                  excerpt(name), suggestion(name, declared_)));
  }

  template <class Use>
  void include(const fs::path& path, const XmlPlace& from, Use&& use) {
    std::error_code problem;
    const fs::path canonical = fs::weakly_canonical(path, problem);
    if (std::ranges::find(open_, canonical) != open_.end())
      return diagnosis_.fault(
          from, fmt::format("{} includes itself, directly or by a detour", excerpt(path.string())));
    if (open_.size() > deepest_include || ++included_ > most_includes)
      return diagnosis_.fault(from, "too many files include each other");
    Document document;
    if (!parse(path, from, document)) return;
    open_.push_back(canonical);
    Document* before = std::exchange(document_, &document);
    Places* places_before = places_;
    Places places(document.text);
    places_ = &places;
    const pugi::xml_node root = document.xml.document_element();
    const XmlPlace place = place_of(root, "/" + std::string(root.name()));
    if (std::string_view(root.name()) != "scene")
      diagnosis_.fault(place, "this is no Mitsuba scene; its outermost element is <scene>");
    else if (!is_too_deep(root))
      use(root, place);
    else
      diagnosis_.fault(place,
                       fmt::format("elements lie within each other more than {} deep", deepest));
    document_ = before;
    places_ = places_before;
    open_.pop_back();
  }

  bool parse(const fs::path& path, const XmlPlace& from, Document& document) {
    document.file = std::make_shared<std::string>(path.string());
    std::error_code problem;
    const bool is_first = open_.empty();
    const auto refuse = [&](const std::string& what) {
      diagnosis_.fault(from, is_first ? what : excerpt(path.string()) + ": " + what);
      return false;
    };
    const fs::file_status status = fs::status(path, problem);
    if (!fs::exists(status)) return refuse("there is no such file; check the path");
    if (fs::is_directory(status)) return refuse("this is a directory; name an XML file in it");
    std::ifstream stream(path, std::ios::binary);
    std::string block(std::size_t{1} << 16, '\0');
    while (stream && document.text.size() <= largest_file) {
      stream.read(block.data(), static_cast<std::streamsize>(block.size()));
      document.text.append(block, 0, static_cast<std::size_t>(stream.gcount()));
    }
    if (document.text.size() > largest_file)
      return refuse(
          fmt::format("the file is too large; a scene may have {} MiB", largest_file >> 20));
    if (!stream.is_open() || stream.bad()) return refuse("the file cannot be read");
    if (document.text.starts_with(byte_order_mark)) document.text.erase(0, byte_order_mark.size());
    const pugi::xml_parse_result result = document.xml.load_buffer(
        document.text.data(), document.text.size(), pugi::parse_default | pugi::parse_trim_pcdata,
        pugi::encoding_utf8);
    if (result && first_bad_byte(document.text))
      return refuse("the file is not in UTF-8; save it so");
    if (result) return true;
    const auto byte = std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)),
                               document.text.size());
    const LineColumn at = Places(document.text).of(byte);
    diagnosis_.fault(XmlPlace{document.file, at.line, at.column, "/"},
                     fmt::format("this is no XML: {}", words_of(result.status)));
    return false;
  }

  // Without recursion, for all others rely on it.
  static bool is_too_deep(pugi::xml_node root) {
    int depth = 1;
    for (pugi::xml_node node = root; node;) {
      if (node.first_child()) {
        node = node.first_child();
        if (++depth > deepest) return true;
        continue;
      }
      while (node != root && !node.next_sibling()) {
        node = node.parent();
        --depth;
      }
      if (node == root) return false;
      node = node.next_sibling();
    }
    return false;
  }

  XmlPlace place_of(pugi::xml_node node, std::string path) {
    const auto name = static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 1));
    const LineColumn at = places_->of(name - 1);  // of its <
    return {document_->file, at.line, at.column, std::move(path)};
  }

  XmlElement read(pugi::xml_node node, const XmlPlace& place) {
    XmlElement element;
    if (++elements_ > most_elements) {
      diagnosis_.fault(place, fmt::format("the scene has more than {} elements", most_elements));
      diagnosis_.require_sound();
    }
    element.tag = node.name();
    element.place = place;
    for (const pugi::xml_attribute attribute : node.attributes())
      element.attributes[attribute.name()] = replaced(attribute.value(), place);
    std::map<std::string, int> counts, number;  // of children with the same tag
    for (const pugi::xml_node child : node.children())
      if (child.type() == pugi::node_element) ++counts[child.name()];
    for (const pugi::xml_node child : node.children()) {
      if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
        diagnosis_.fault(
            place, fmt::format("there is text where elements are: {}", excerpt(child.value())));
      if (child.type() != pugi::node_element) continue;
      const std::string tag = child.name();
      const int nth = ++number[tag];
      std::string path = place.path + "/" + printable(tag);
      if (counts[tag] > 1) path += fmt::format("[{}]", nth);
      add(element, child, place_of(child, std::move(path)));
    }
    return element;
  }

  // What the reader itself understands is no child of the scene.
  void add(XmlElement& parent, pugi::xml_node node, const XmlPlace& place) {
    const std::string_view tag = node.name();
    const auto value = [&](const char* name) {
      return replaced(node.attribute(name).value(), place);
    };
    if (tag == "default") {
      declared_.push_back(value("name"));
      values_.emplace(value("name"), value("value"));
    } else if (tag == "path") {
      scene_.folders.insert(scene_.folders.begin(), scene_.folders.back() / value("value"));
    } else if (tag == "include") {
      const fs::path found = find_file(scene_.folders, value("filename"));
      if (found.empty())
        return diagnosis_.fault(place,
                                fmt::format("there is no file {}; paths are relative to the scene",
                                            excerpt(value("filename"))));
      include(found, place, [&](pugi::xml_node root, const XmlPlace& at) {
        for (XmlElement& child : read(root, at).children)
          parent.children.push_back(std::move(child));
      });
    } else {
      parent.children.push_back(read(node, place));
    }
  }

  // Values that hold others may double with each.
  bool fits(const std::string& value, const XmlPlace& place) {
    if (put_in_ > largest_file) return false;
    put_in_ += value.size();
    if (put_in_ <= largest_file) return true;
    diagnosis_.fault(place, fmt::format("the scene is too large with the values of its parameters; "
                                        "they may have {} MiB",
                                        largest_file >> 20));
    return false;
  }

  // The longest known name after a $ is meant: $width_2 is not $width.
  std::string replaced(std::string_view text, const XmlPlace& place) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
      if (text[i] != '$') {
        result += text[i++];
        continue;
      }
      std::size_t end = i + 1;
      while (end < text.size() && is_name_character(text[end])) ++end;
      const std::string word(text.substr(i + 1, end - i - 1));
      std::string name = word;
      while (!name.empty() && !values_.contains(name)) name.pop_back();
      if (name.empty()) {
        diagnosis_.fault(place, fmt::format("${} has no value; say -D {}=VALUE, or give it a "
                                            "<default name=\"{}\" value=\"...\"/> before",
                                            excerpt(word), excerpt(word), excerpt(word)));
        return result;
      }
      used_.insert(name);
      const std::string& value = values_.find(name)->second;
      if (!fits(value, place)) return {};
      result += value;
      i += 1 + name.size();
    }
    return result;
  }

  const XmlParameters& given_;
  XmlParameters values_;
  Diagnosis& diagnosis_;
  XmlScene scene_;
  std::set<std::string> used_;
  std::vector<std::string> declared_;
  std::vector<fs::path> open_;
  std::size_t included_ = 0, elements_ = 0;
  std::uintmax_t put_in_ = 0;  // characters, for parameters
  Document* document_ = nullptr;
  Places* places_ = nullptr;
};

}  // namespace

XmlScene load_xml(const fs::path& path, const XmlParameters& parameters, Diagnosis& diagnosis) {
  XmlScene scene = Loader(parameters, diagnosis).load(path);
  if (scene.root.tag.empty()) diagnosis.require_sound();
  return scene;
}

fs::path find_file(const std::vector<fs::path>& folders, const std::string& name) {
  std::error_code problem;
  for (const fs::path& folder : folders)
    if (const fs::path path = folder / name; !name.empty() && fs::is_regular_file(path, problem))
      return path;
  return {};
}

}  // namespace wander
