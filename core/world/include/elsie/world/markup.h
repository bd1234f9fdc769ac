// XML as a light tree of elements, each with its place in the file. Comments and blanks are left
// out; Document keeps those.
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
};

struct Element {
  static constexpr std::size_t kMade = static_cast<std::size_t>(-1);

  std::string name;
  Location where;
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  // What stands between its tags besides elements, unless it is blank, and on which line.
  std::string text{};
  int text_line = 0;
  std::size_t number = kMade;  // its start tag's among the start tags of the file
  bool incomplete = false;     // its template could not be read: what is missing may stand there
  std::optional<Location> removed_by{};  // the override that takes it away in the end

  const Attribute* find(std::string_view attribute) const;
  std::string value(std::string_view attribute) const;  // "" when it is not there
  void set(std::string_view attribute, std::string value, const Location& where);
  void erase(std::string_view attribute);
  Element* child(std::string_view child_name);
  const Element* child(std::string_view child_name) const;
};

/// The content of a file. Throws WorldError when it is not there, not a file, not readable or
/// larger than a world can be (kLargestFile).
std::string read_text(const std::string& file);
inline constexpr std::size_t kLargestFile = 32'000'000;  // bytes

/// The root element. Throws WorldError when the text is not well-formed XML in UTF-8, has a
/// document type declaration (entities could make a small file huge) or is nested deeper than any
/// world. `kind` is the root element that the file should have.
Element parse_markup(std::string_view text, const std::string& file,
                     const std::string& kind = "world");

/// `speed="5" of <roam>`
std::string in_words(const Attribute& attribute, const Element& element);

/// The element as text that parses as the same: on one line, without the comments that stood in it.
std::string markup_of(const Element& element);

}  // namespace elsie::world
