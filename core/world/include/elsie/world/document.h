// A world file as its author wrote it: comments, blank lines, order of attributes, references to
// templates. For editors: what is not changed stays as it is, to the byte.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace elsie::world {

struct Path;
struct Element;

/// Paths are those of ReadOptions::overrides and address what stands in this file, not
/// what a template brings in. All members that change something throw std::invalid_argument with a
/// sentence, and leave the text as it was, when a path leads nowhere or the result would not be
/// well-formed. A document is checked as a world by parse_world(document.text(), ...) only.
class Document {
 public:
  /// Throws WorldError when the text is not well-formed.
  Document(std::string text, std::string file);
  /// Throws WorldError when the file cannot be read or is not well-formed.
  static Document load(const std::string& file);

  const std::string& text() const { return text_; }
  const std::string& file() const { return file_; }

  /// The attribute's text, if the file gives it. The path must lead to one element.
  std::optional<std::string> attribute(std::string_view path) const;

  /// Sets an attribute on every element that the path leads to. An element that may stand only once
  /// ("physics", "robot[r1]/body") is added when it is not there.
  void set(std::string_view path, std::string_view value);
  /// Takes an attribute out, so that the default, or what the template says, holds again.
  void reset(std::string_view path);
  /// Adds elements, given as XML, at the end of the one that the path leads to ("" is the root).
  void insert(std::string_view path, std::string_view markup);
  /// Takes out every element that the path leads to.
  void erase(std::string_view path);

  /// Writes the text to a file, which is replaced as a whole or not at all. Throws WorldError when
  /// it cannot be written.
  void save(const std::string& file) const;

 private:
  void add_missing(const Path& path);
  void insert_into(const Element& parent, std::string_view markup);
  void replace(std::string text);

  std::string text_;
  std::string file_;
};

}  // namespace elsie::world
