// XML as a light tree of elements, each with its place in the file, without comments and blanks.
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
  bool completed = false;  // an id that no file gives
};

struct Element {
  std::string name;
  Location where;
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  // The first text between its tags that is not blank, and its line.
  std::string text{};
  int text_line = 0;
  bool incomplete = false;  // its template could not be read, and may hold what is missing
  std::optional<Location> removed_by{};  // the override that removes it
  std::optional<std::size_t> object{};   // what it stands for; see tree.h and world_tree.h

  const Attribute* find(std::string_view attribute) const;
  std::string value(std::string_view attribute) const;  // "" without this attribute
  void set(std::string_view attribute, std::string value, const Location& where);
  void erase(std::string_view attribute);
  Element* child(std::string_view child_name);
  const Element* child(std::string_view child_name) const;
};

/// Calls `visit` with an element and all in it, each before those that it holds.
template <class AnyElement, class Function>
void for_each_element(AnyElement& root, const Function& visit) {
  visit(root);
  for (auto& child : root.children) {
    for_each_element(child, visit);
  }
}

/// Where an element stands in a text; all places are counted in bytes.
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
  std::size_t open_end = 0;  // of that tag
  std::size_t close = 0;     // of its end tag, unless it is empty
  std::size_t end = 0;       // of the element
  bool empty = false;        // <roam/>
  std::size_t parent = kNone;
  std::vector<Attribute> attributes{};
};

/// The content of a file. Throws WorldError when there is no such file, when it is no regular file,
/// cannot be read, or has more than 32 MB.
std::string read_text(const std::string& file);

/// Returns the root element. Throws WorldError when the text is not well-formed XML in UTF-8, has a
/// document type declaration (entities could make a small file huge) or more than 50 levels.
/// `kind` is the root element that the file should have. `spans` gets the places of all elements,
/// in the order of their start tags.
Element parse_markup(std::string_view text, const std::string& file,
                     const std::string& kind = "world", std::vector<ElementSpan>* spans = nullptr);

/// `speed="5" of <roam>`
std::string in_words(const Attribute& attribute, const Element& element);

/// `<roam speed="5"`, without its end.
std::string start_tag(const Element& element);
/// The element as text on one line that parse_markup() reads as the same element.
std::string markup_of(const Element& element);

}  // namespace elsie::world
