// Unsaved work, kept where a crash does not reach it.
#pragma once

#include <QString>
#include <optional>
#include <vector>

namespace elsie::desktop {

/// What a window had open that was not closed properly.
struct Recovered {
  QString file;  // that the world was opened from; may be empty
  QString text;
  QString kept_in;
  bool is_damaged = false;  // then it has neither file nor text
};

/// Keeps the unsaved text of one window in a file of its own, below the user's data folder.
class Recovery {
 public:
  Recovery();
  /// Takes the file away.
  ~Recovery();
  Recovery(const Recovery&) = delete;
  Recovery& operator=(const Recovery&) = delete;

  /// False if the disk is full or the folder cannot be written.
  bool keep(const QString& file, const QString& text);
  /// Everything is saved.
  void forget();

  /// What windows left behind whose process is not there any more.
  static std::vector<Recovered> left_behind();
  static void discard(const Recovered& recovered);

 private:
  QString kept_in_;
};

}  // namespace elsie::desktop
