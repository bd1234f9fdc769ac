// A world file that is edited: its text changes only where an edit touches it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "elsie/world/description.h"
#include "elsie/world/markup.h"
#include "elsie/world/reader.h"

namespace elsie::editing {

/// One or several edits, which are made together or not at all.
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
  /// Of an inverse: the piece of text that was there before.
  std::shared_ptr<const Restored> restored_;
};

/// The text of a world file and the world that it describes, always both.
///
/// An edit changes the text only where it has to: comments, the order of elements and attributes,
/// blanks, quotes and line ends stay. A removed element takes its line with it; an added one stands
/// on a line of its own, as far in as its siblings. What a robot's template says is overridden in
/// the robot's own element; no other file is ever changed.
///
/// A member of a list that has no id in the text is named by its place there. When an edit changes
/// these names, members whose names are used elsewhere in the world keep them, as an attribute.
class Document {
 public:
  /// The file is `text`, whatever is on disk; its folder is where templates and data files are
  /// searched first. The host must outlive the document. Edits come from apply() only:
  /// ReadOptions::overrides are not used. Throws WorldError if the text is not a right world.
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
  /// The elements of the world, those of templates among them; valid until the next edit.
  const world::Element& tree() const;
  /// An element of the tree as the text has it: a robot with `template`, and without what the
  /// template adds. Null if it stands in a template only.
  const world::Element* written(const world::Element& element) const;

  /// Makes the edits, checks the result as a file is checked, and returns the edits that undo them.
  /// Applied next, these restore the text byte for byte; applied to any other text, they do what
  /// their texts say. Throws WorldError and changes nothing if the edits are impossible, or if the
  /// file cannot say what they ask for.
  Edits apply(const Edits& edits);

  /// Takes another text of the same file, and returns the edits that undo this, as apply() does.
  /// Throws WorldError and changes nothing if the text is not a right world.
  Edits become(std::string text);

  /// The text for a file in another folder: names of files that would not lead to the same files
  /// from there are replaced, those of ReadOptions::files among them. Throws WorldError if there is
  /// no such folder.
  std::string text_for(const std::string& folder) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::editing
