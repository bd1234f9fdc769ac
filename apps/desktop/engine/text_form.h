// What the bytes of a text file have beyond its text.
#pragma once

#include <QByteArray>
#include <QString>
#include <vector>

namespace elsie::desktop {

/// Whether a file begins with the mark of UTF-8, and how each of its lines ends. A text that was
/// changed gets these back: its new lines end as most of them do.
class TextForm {
 public:
  TextForm() = default;
  /// Takes the mark off the bytes, and the carriage return off the end of each line.
  static TextForm take_from(QByteArray& bytes);

  QByteArray bytes_of(const QString& text) const;

 private:
  std::vector<bool> ends_of(const QList<QByteArray>& lines) const;

  bool has_mark_ = false;
  bool most_have_carriages_ = false;
  // Only of a file whose lines do not all end alike.
  QList<QByteArray> lines_;
  std::vector<bool> carriages_;
};

/// The first line, from 1, that is no UTF-8; 0: all are.
int line_without_utf8(const QByteArray& bytes);

}  // namespace elsie::desktop
