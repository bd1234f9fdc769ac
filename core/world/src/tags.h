// The tags of an XML text with their places in it, to the byte: what an edit that leaves everything
// else alone needs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace elsie::world {

struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
};

struct TagAttribute {
  std::string_view name;
  Span whole;  // with the blanks before it
  Span value;  // between the quotes
};

struct Tag {
  enum class Kind { start, end, empty };
  Kind kind = Kind::start;
  std::string_view name;
  Span span;
  int line = 0;  // where it begins
  std::vector<TagAttribute> attributes;
};

/// All tags in order. The views point into `text`. Throws WorldError for what no file of ours
/// may hold: a document type declaration, an entity that is not one of XML's own five or a
/// character reference, markup that is cut off, attributes that are not separated or quoted.
std::vector<Tag> scan_tags(std::string_view text, const std::string& file);

}  // namespace elsie::world
