// Unsaved work, kept where a crash does not reach it.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace elsie::desktop {

/// A change that the text does not have yet, because the engine has not made it.
struct WaitingEdits {
  QString name;  // for undo
  QStringList edits;
};

/// What a window had open that was not closed properly.
struct Recovered {
  QString file;  // that the world was opened from; may be empty
  QString text;
  QString kept_in;
  bool is_borrowed = false;  // the file belongs to a recording: the world is saved elsewhere
  bool is_damaged = false;   // then it has neither file nor text
  std::vector<WaitingEdits> waiting = {};
};

/// Keeps the unsaved text of one window in a file of its own, below the user's data folder. The
/// system holds a lock for as long as the window's process lives: numbers of processes are used
/// again, and each container has its own.
class Recovery {
 public:
  Recovery();
  /// What is kept stays: only a user gives it up.
  ~Recovery();
  Recovery(const Recovery&) = delete;
  Recovery& operator=(const Recovery&) = delete;

  /// False if the disk is full or the folder cannot be written.
  bool keep(const QString& file, const QString& text, bool is_borrowed,
            const std::vector<WaitingEdits>& waiting = {});
  /// Everything is saved, or given up.
  void forget();

  /// What windows left behind that are not open any more.
  static std::vector<Recovered> left_behind();
  static void discard(const Recovered& recovered);

 private:
  QString kept_in_;
  int lock_ = -1;  // a descriptor
};

}  // namespace elsie::desktop
