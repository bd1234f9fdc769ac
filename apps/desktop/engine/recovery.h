// Keeps unsaved work where it survives a crash.
#pragma once

#include <QStringList>
#include <vector>

namespace elsie::desktop {

/// What was typed and not entered: a value, an element in a dialog, or the text of a source.
struct Typed {
  QString path;  // of the attribute, "robot[r1]/@x", of the element, "sensor[+]", or of the file
  QString text;

  friend bool operator==(const Typed&, const Typed&) = default;
};

/// The unsaved work of a window, as it is kept for the case that the window is not closed properly.
struct Recovered {
  QString file;  // from which the world was opened; may be empty
  QString text;
  bool is_borrowed = false;  // the file belongs to a recording; the world is then saved elsewhere
  QString kept_in = {};
  bool is_damaged = false;  // there is then neither file nor text
  std::vector<Typed> typed = {};
  std::vector<Typed> sources = {};
  QStringList plugins = {};  // sources that were written in the window, which the world may need
};

/// Keeps the unsaved text of one window in a file of its own, below the user's data folder. A lock
/// on that file, which ends with the window's process, shows that the file is in use. Process
/// numbers would not: they are used again, and each container has its own.
class Recovery {
 public:
  Recovery();
  /// Recovery files stay until the user discards them.
  ~Recovery();
  Recovery(const Recovery&) = delete;
  Recovery& operator=(const Recovery&) = delete;

  /// Stores the work. Returns false if the disk is full or the folder cannot be written.
  bool keep(const Recovered& work);
  /// Deletes the file, because everything is saved or discarded.
  void forget();

  /// The work of windows that are no longer open.
  static std::vector<Recovered> left_behind();
  static void discard(const Recovered& recovered);

 private:
  QString kept_in_;
  int lock_ = -1;  // a descriptor
};

}  // namespace elsie::desktop
