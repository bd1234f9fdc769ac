// The bytes of a text file that are not in its text: mark and line ends.
#pragma once

#include <QByteArray>
#include <QString>
#include <vector>

namespace elsie::desktop {

/// Whether a file begins with the mark of UTF-8, and how each of its lines ends. A changed text
/// gets these back; its new lines end as most lines of the file do.
class TextForm {
 public:
  TextForm() = default;
  /// Removes the mark from the bytes, and the carriage return from the end of each line.
  static TextForm take_from(QByteArray& bytes);

  QByteArray bytes_of(const QString& text) const;

 private:
  std::vector<bool> ends_of(const QList<QByteArray>& lines) const;

  bool has_mark_ = false;
  bool most_have_carriages_ = false;
  // Only for a file whose lines do not all end alike.
  QList<QByteArray> lines_;
  std::vector<bool> carriages_;
};

/// The first line that is not UTF-8, from 1; 0 if all lines are.
int line_without_utf8(const QByteArray& bytes);

}  // namespace elsie::desktop
