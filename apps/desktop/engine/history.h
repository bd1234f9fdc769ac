// What can be undone.
#pragma once

#include <QElapsedTimer>
#include <QString>
#include <vector>

namespace elsie::desktop {

/// A list of edits that were made, each with a name for the menu, and a place in this list. The
/// engine goes back and forth by the texts.
class History {
 public:
  struct Entry {
    QString name;    // "move r3"
    QString merge;   // consecutive entries with the same text become one; "": never
    QString before;  // the text of the world
    QString after;
    QString file;            // of the texts: their file names start from there
    bool is_opened = false;  // one of the texts is not a world: they are opened, as a file is
    qint64 at_ms = 0;        // set by push()
  };

  static constexpr qint64 kMerging_ms = 2000;

  History() { clock_.start(); }

  void clear();
  /// Adds an entry, and forgets the undone ones. Merges it with the last entry if both allow that
  /// and less than kMerging_ms lie between them; an entry that then leads back to where it began is
  /// dropped.
  void push(Entry entry);

  const Entry* next_undo() const;
  const Entry* next_redo() const;
  /// Call these when the engine has undone or redone the entry.
  void undone();
  void redone();

  /// Keeps the next entry from being merged with the last one, because the text was saved in
  /// between.
  void stop_merging();

 private:
  std::vector<Entry> entries_;
  std::size_t place_ = 0;  // the entries before it are in effect
  QElapsedTimer clock_;
};

}  // namespace elsie::desktop
