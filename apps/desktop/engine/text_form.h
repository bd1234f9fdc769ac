// The bytes of a text file that are not in its text: mark and line ends.
#pragma once

#include <QByteArray>
#include <QString>

namespace elsie::desktop {

/// Whether a file begins with the mark of UTF-8, and whether its lines end as on Windows: those of
/// most lines, if they differ. A changed text gets these back.
class TextForm {
 public:
  TextForm() = default;
  /// Removes the mark from the bytes, and the carriage return from the end of each line.
  static TextForm take_from(QByteArray& bytes);

  QByteArray bytes_of(const QString& text) const;

 private:
  bool has_mark_ = false;
  bool has_carriages_ = false;
};

/// The first line that is not UTF-8, from 1; 0 if all lines are.
int line_without_utf8(const QByteArray& bytes);

}  // namespace elsie::desktop
