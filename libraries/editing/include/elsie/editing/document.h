// A world file that is edited: its text changes only where an edit touches it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "elsie/world/description.h"
#include "elsie/world/markup.h"
#include "elsie/world/reader.h"

namespace elsie::editing {

/// One or more edits, which are made together or not at all.
class Edits {
 public:
  Edits() = default;
  /// Each text is one of ReadOptions::overrides: "robot[r1]/@max_speed=0.3".
  Edits(std::vector<std::string> texts) : texts_(std::move(texts)) {}  // NOLINT(*-explicit-*)
  Edits(std::string text) : texts_{std::move(text)} {}                 // NOLINT(*-explicit-*)
  Edits(const char* text) : texts_{text} {}                            // NOLINT(*-explicit-*)

  const std::vector<std::string>& texts() const { return texts_; }

 private:
  friend class Document;
  struct Restored;

  std::vector<std::string> texts_;
  /// For edits that undo others: the earlier piece of text.
  std::shared_ptr<const Restored> restored_;
};

/// The text of a world file and the world that it describes, which always agree.
///
/// An edit changes the text only where necessary: comments, the order of elements and attributes,
/// blanks, quotes and line ends stay. A removed element is removed with its line; an added element
/// gets a line of its own, indented like its siblings. The content of a robot's template is
/// overridden in the robot's own element; other files never change.
///
/// A list member without an id in the text is named by its position. If an edit would change the
/// name of a member that is used elsewhere in the world, the member keeps it as an attribute `id`.
class Document {
 public:
  /// The content of `file` is `text`, whatever is on disk. Templates and data files are searched in
  /// its folder first. The host must outlive the document. ReadOptions::overrides are not used:
  /// apply() makes all edits. Throws WorldError if the text is not a valid world.
  Document(std::string text, std::string file, const plugin::Host& host,
           world::ReadOptions options = {});
  /// Reads the file; see read_world().
  static Document open(const std::string& file, const plugin::Host& host,
                       world::ReadOptions options = {});
  Document(Document&&) noexcept;
  Document& operator=(Document&&) noexcept;
  ~Document();

  const std::string& file() const;
  const std::string& text() const;
  const world::World& world() const;
  /// The elements of the world, including those of templates. Valid until the next edit.
  const world::Element& tree() const;
  /// An element of the tree as the text has it: a robot with its attribute `template`, but without
  /// the content of the template. Null if the element is in a template only.
  const world::Element* written(const world::Element& element) const;

  /// Makes the edits, checks the result like a file, and returns the edits that undo them. If these
  /// are applied next, they restore the text byte for byte; applied to another text, they act like
  /// other edits. Throws WorldError and changes nothing if the edits are impossible, or if a file
  /// cannot express their result.
  Edits apply(const Edits& edits);

  /// Replaces the whole text of the file, and returns the edits that undo this, as apply() does.
  /// Throws WorldError and changes nothing if the text is not a valid world.
  Edits become(std::string text);

  /// The text for a file in another folder. It replaces the names of files that would not lead to
  /// the same files from there, including those of ReadOptions::files. Throws WorldError if the
  /// folder does not exist.
  std::string text_for(const std::string& folder) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::editing
