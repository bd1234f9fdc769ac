// What can be undone.
#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <vector>

namespace elsie::desktop {

/// A list of edits that were made, each with a name for the menu, and a place in it. The engine has
/// the inverses; the texts are for an engine that was started anew.
class History {
 public:
  struct Entry {
    QString name;    // "move r3"
    QString merge;   // entries of the same sort that follow each other become one; "": never
    QString before;  // the text of the world
    QString after;
    std::uint64_t inverse = 0;  // the engine's number of what leads back, or again forward; 0: none
    int engine = 0;             // its generation
    qint64 at_ms = 0;
  };

  void clear();
  /// Forgets what was undone. Merges with the last entry if both may be one; one that leads back to
  /// where it began is none.
  void push(Entry entry);

  const Entry* next_undo() const;
  const Entry* next_redo() const;
  /// To be called when the engine has made it, with the number of the inverse.
  void undone(std::uint64_t inverse, int engine);
  void redone(std::uint64_t inverse, int engine);

  /// Whether the text is that which was saved last.
  bool is_clean() const { return clean_ == place_; }
  void set_clean() { clean_ = place_; }
  void set_dirty() { clean_ = std::nullopt; }

 private:
  std::vector<Entry> entries_;
  std::size_t place_ = 0;  // entries before it are made
  std::optional<std::size_t> clean_ = 0;
};

}  // namespace elsie::desktop
