// What can be undone.
#pragma once

#include <QString>
#include <cstdint>
#include <vector>

namespace elsie::desktop {

/// A list of edits that were made, each with a name for the menu, and a place in it. The engine has
/// the inverses; the texts are for an engine that was started again.
class History {
 public:
  struct Entry {
    QString name;    // "move r3"
    QString merge;   // entries of the same sort that follow each other become one; "": never
    QString before;  // the text of the world
    QString after;
    QString file;               // that the texts were written for: they name other files from there
    std::uint64_t inverse = 0;  // the engine's number of what leads back, or again forward; 0: none
    int engine = 0;             // its generation
    qint64 at_ms = 0;
    bool is_opened = false;  // at least one of the texts is no world: it is opened, as a file is
  };

  void clear();
  /// Forgets what was undone. Merges with the last entry if both may be one; one that leads back to
  /// where it began is none.
  void push(Entry entry);
  /// The engine has no inverses any more.
  void drop_inverses();

  const Entry* next_undo() const;
  const Entry* next_redo() const;
  /// To be called when the engine has made it, with the number of the inverse.
  void undone(std::uint64_t inverse, int engine);
  void redone(std::uint64_t inverse, int engine);

  /// What is pushed next does not become one with what is there: the text was saved in between.
  void stop_merging();

 private:
  std::vector<Entry> entries_;
  std::size_t place_ = 0;  // entries before it are made
};

}  // namespace elsie::desktop
