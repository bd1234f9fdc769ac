// XML as a light tree of elements with their places in the file, without comments and blanks.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/world/description.h"

namespace elsie::world {

struct Attribute {
  std::string name;
  std::string value;
  Location where;
  bool completed = false;  // a default id, which no file contains
};

class WorldTree;

struct Element {
  std::string name;
  Location where;
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  // The text between its tags, without blanks around it, and the line where it begins.
  std::string text{};
  int text_line = 0;
  bool incomplete = false;  // its template could not be read, so elements may be missing
  std::optional<Location> removed_by{};  // the edit that removes it
  std::optional<std::size_t> object{};   // a number for its meaning; see tree.h and world_tree.h
  WorldTree* unread = nullptr;           // not null: has only the id so far; the tree completes it

  const Attribute* find(std::string_view attribute) const;
  std::string value(std::string_view attribute) const;  // "" without this attribute
  void set(std::string_view attribute, std::string value, const Location& location);
  void erase(std::string_view attribute);
  Element* child(std::string_view child_name);
  const Element* child(std::string_view child_name) const;
};

/// Calls `visit` with an element and all elements inside it, outer ones before inner ones.
template <class AnyElement, class Function>
void for_each_element(AnyElement& root, const Function& visit) {
  visit(root);
  for (auto& child : root.children) {
    for_each_element(child, visit);
  }
}

/// The place of an element in a text; all offsets are in bytes.
struct ElementSpan {
  struct Attribute {
    std::size_t begin = 0;  // of its name
    std::size_t name_end = 0;
    std::size_t value = 0;  // between the quotes
    std::size_t end = 0;    // after the closing quote
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::size_t begin = 0;     // of its start tag
  std::size_t name_end = 0;  // of the name in that tag
  std::size_t open_end = 0;  // the end of that tag
  std::size_t close = 0;     // the start of its end tag, unless it is empty
  std::size_t end = 0;       // the end of the element
  bool empty = false;        // true for <roam/>
  std::size_t parent = kNone;
  std::vector<Attribute> attributes{};
};

/// The content of a file. Throws WorldError when the file does not exist, is not a regular file,
/// cannot be read, or has more than 256 MB.
std::string read_text(const std::string& file);

/// Parses a text and returns its root element. Throws WorldError when the text is not well-formed
/// XML in UTF-8, has a document type declaration (entities could make a small file huge) or more
/// than 50 levels. `kind` is the expected root element. `spans` receives the places of all elements
/// in the order of their start tags.
Element parse_markup(std::string_view text, const std::string& file,
                     const std::string& kind = "world", std::vector<ElementSpan>* spans = nullptr);

/// `speed="5" of <roam>`
std::string in_words(const Attribute& attribute, const Element& element);

/// The start tag of an element without its end: `<roam speed="5"`.
std::string start_tag(const Element& element);
/// The element as one line of text, which parse_markup() reads as the same element.
std::string markup_of(const Element& element);

}  // namespace elsie::world
