// A world file that is edited: its text changes only where an edit touches it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "elsie/world/description.h"
#include "elsie/world/markup.h"
#include "elsie/world/reader.h"

namespace elsie::editing {

/// Which members of lists keep a name that they have by their position when an edit shifts it.
enum class Names {
  used,  // those whose name is used elsewhere in the world
  all,   // as in a running world, where an object with another name would be another object
};

/// The text of a world file and the world that it describes, which always agree.
///
/// An edit changes the text only where necessary: comments, the order of elements and attributes,
/// blanks, quotes and line ends stay. A removed element is removed with its line; an added element
/// gets a line of its own, indented like its siblings. The content of a robot's template is
/// overridden in the robot's own element; other files never change.
///
/// A list member without an id in the text is named by its position. A member that keeps its name
/// when an edit shifts it (Names) gets it as an attribute `id`.
class Document {
 public:
  /// The content of `file` is `text`, whatever is on disk. Templates and data files are searched in
  /// its folder first. The host must outlive the document. ReadOptions::edits are not used:
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

  /// Makes the edits, and checks the result like a file. Each is one of ReadOptions::edits:
  /// "robot[r1]/@max_speed=0.3". Throws WorldError and changes nothing if they are impossible, or
  /// if a file cannot express their result.
  void apply(const std::vector<std::string>& edits, Names names = Names::used);

  /// Replaces the whole text of the file; with an earlier text, this undoes what came after it.
  /// Throws WorldError and changes nothing if the text is not a valid world.
  void become(std::string text);

  /// The text for a file in another folder. It replaces the names of files that would not lead to
  /// the same files from there, including those of ReadOptions::files. Throws WorldError if the
  /// folder does not exist.
  std::string text_for(const std::string& folder) const;

 private:
  struct State;
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::editing
