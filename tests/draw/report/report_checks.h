// What tests of reports need: a page read as XML, strictly, and what is asked of it.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace wander::test {

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;  // up to the first tag within
};

struct Page {
  std::vector<Element> elements;  // in the order in which they open
  std::string fault;              // the first that an XML parser would refuse; empty if none
};

// Elements, attributes and texts of a document without comments, CDATA or processing instructions.
class PageReader {
 public:
  explicit PageReader(std::string_view text) : text_(text) {}

  Page read() {
    constexpr std::string_view doctype = "<!DOCTYPE html>";
    if (text_.starts_with(doctype)) text_.remove_prefix(doctype.size());
    while (page_.fault.empty() && !text_.empty()) {
      read_text();
      if (!text_.empty()) read_tag();
    }
    if (page_.fault.empty() && !open_.empty()) page_.fault = open_.back() + " is not closed";
    return std::move(page_);
  }

 private:
  void refuse(std::string_view what, std::string_view where) {
    if (page_.fault.empty())
      page_.fault = std::string(what) + ": " + std::string(where.substr(0, 200));
  }

  void check_text(std::string_view text) {
    if (text.find('>') != std::string_view::npos && open_.back() != "style")
      refuse("a bare >", text);
    for (auto at = text.find('&'); at != std::string_view::npos; at = text.find('&', at + 1)) {
      const std::string_view rest = text.substr(at);
      if (!rest.starts_with("&lt;") && !rest.starts_with("&gt;") && !rest.starts_with("&amp;") &&
          !rest.starts_with("&quot;"))
        refuse("a bare &", rest);
    }
  }

  void read_text() {
    const std::size_t end = std::min(text_.find('<'), text_.size());
    const std::string_view text = text_.substr(0, end);
    if (text.find_first_not_of(" \n") != std::string_view::npos) {
      if (open_.empty()) return refuse("text outside", text);
      check_text(text);
      if (fresh_) page_.elements.back().text = text;
    }
    text_.remove_prefix(end);
  }

  void read_tag() {
    const std::size_t end = text_.find('>');
    if (end == std::string_view::npos) return refuse("an open tag", text_);
    std::string_view tag = text_.substr(1, end - 1);
    text_.remove_prefix(end + 1);
    if (tag.starts_with('/')) return close(tag.substr(1));
    const bool empty = tag.ends_with('/');
    if (empty) tag.remove_suffix(1);
    open(tag);
    if (empty && !open_.empty()) open_.pop_back();
    fresh_ = !empty;
  }

  void close(std::string_view name) {
    if (open_.empty() || open_.back() != name) return refuse("closes nothing", name);
    open_.pop_back();
    fresh_ = false;
  }

  void open(std::string_view tag) {
    Element element;
    element.name = tag.substr(0, tag.find(' '));
    tag.remove_prefix(element.name.size());
    while (tag.find_first_not_of(' ') != std::string_view::npos) {
      tag.remove_prefix(tag.find_first_not_of(' '));
      const std::size_t equals = tag.find("=\"");
      const std::size_t end = equals == tag.npos ? tag.npos : tag.find('"', equals + 2);
      if (end == tag.npos) return refuse("no attribute", tag);
      const std::string_view value = tag.substr(equals + 2, end - equals - 2);
      if (value.find('<') != value.npos) refuse("a bare <", value);
      if (!element.attributes.emplace(tag.substr(0, equals), value).second)
        refuse("an attribute twice", tag);
      tag.remove_prefix(end + 1);
    }
    open_.push_back(element.name);
    page_.elements.push_back(std::move(element));
  }

  std::string_view text_;
  Page page_;
  std::vector<std::string> open_;
  bool fresh_ = false;  // nothing but text since the last element opened
};

inline Page read_page(std::string_view text) { return PageReader(text).read(); }

// Every id once, and every reference to one that exists.
inline testing::AssertionResult has_whole_references(const Page& page) {
  std::set<std::string> ids;
  for (const Element& element : page.elements)
    if (const auto id = element.attributes.find("id"); id != element.attributes.end())
      if (!ids.insert(id->second).second)
        return testing::AssertionFailure() << id->second << " twice";
  const auto exists = [&](std::string_view id) { return ids.contains(std::string(id)); };
  for (const Element& element : page.elements)
    for (const auto& [name, value] : element.attributes) {
      if (name == "href" && !(value.starts_with('#') && exists(value.substr(1))))
        return testing::AssertionFailure() << "to nowhere: " << value;
      if (value.starts_with("url(#") && !exists(value.substr(5, value.size() - 6)))
        return testing::AssertionFailure() << "no " << value;
      if (name != "aria-labelledby") continue;
      for (std::string_view rest = value; !rest.empty();) {
        const std::string_view id = rest.substr(0, rest.find(' '));
        if (!exists(id)) return testing::AssertionFailure() << "no label " << id;
        rest.remove_prefix(std::min(rest.size(), id.size() + 1));
      }
    }
  return testing::AssertionSuccess();
}

// One h1 that comes first, and no level that is left out on the way down.
inline testing::AssertionResult has_headings_in_order(const Page& page) {
  int level = 0;
  for (const Element& element : page.elements) {
    if (element.name.size() != 2 || element.name[0] != 'h' || element.name[1] > '6') continue;
    const int next = element.name[1] - '0';
    if (next > level + 1 || (next == 1 && level != 0))
      return testing::AssertionFailure() << element.name << " after h" << level;
    level = next;
  }
  return level > 0 ? testing::AssertionSuccess() : testing::AssertionFailure() << "no heading";
}

// What holds of every report.
inline void expect_sound(const std::string& html) {
  const Page page = read_page(html);
  EXPECT_EQ(page.fault, "");
  EXPECT_TRUE(has_whole_references(page));
  EXPECT_TRUE(has_headings_in_order(page));
  EXPECT_LT(html.size(), 2'000'000u);
  static const std::regex not_a_number(R"([^a-zA-Z](nan|NaN|-?inf)[^a-zA-Z])");
  std::smatch found;
  for (const Element& element : page.elements) {
    EXPECT_FALSE(std::regex_search(element.text, found, not_a_number) && element.name != "pre")
        << element.text;
    for (const auto& [name, value] : element.attributes)
      EXPECT_FALSE(value == "nan" || value == "inf") << element.name << ' ' << name;
  }
}

}  // namespace wander::test
