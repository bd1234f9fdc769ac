#include "engine/text_form.h"

#include <QStringDecoder>
#include <algorithm>

namespace elsie::desktop {
namespace {

constexpr auto kMark = "\xEF\xBB\xBF";  // Windows writes it before UTF-8

bool is_utf8(const QByteArray& bytes) {
  QStringDecoder decoder(QStringDecoder::Utf8);
  const QString text = decoder(bytes);
  return !decoder.hasError();
}

}  // namespace

int line_without_utf8(const QByteArray& bytes) {
  if (is_utf8(bytes)) {
    return 0;
  }
  int number = 1;
  for (const QByteArray& line : bytes.split('\n')) {
    if (!is_utf8(line)) {
      return number;
    }
    ++number;
  }
  return 1;
}

TextForm TextForm::take_from(QByteArray& bytes) {
  TextForm form;
  form.has_mark_ = bytes.startsWith(kMark);
  if (form.has_mark_) {
    bytes.remove(0, 3);
  }
  const auto lines = bytes.count('\n'), carriages = bytes.count("\r\n");
  form.most_have_carriages_ = 2 * carriages > lines;
  if (carriages > 0 && carriages < lines) {
    form.lines_ = bytes.split('\n');
    for (QByteArray& line : form.lines_) {
      form.carriages_.push_back(line.endsWith('\r'));
      if (line.endsWith('\r')) line.chop(1);
    }
  }
  bytes.replace("\r\n", "\n");
  return form;
}

// Lines that are in both, in the same order, keep their ends.
std::vector<bool> TextForm::ends_of(const QList<QByteArray>& lines) const {
  std::vector<bool> ends(static_cast<std::size_t>(lines.size()), most_have_carriages_);
  qsizetype first = 0, last = 0;
  const auto shorter = std::min(lines.size(), lines_.size());
  while (first < shorter && lines[first] == lines_[first]) {
    ends[static_cast<std::size_t>(first)] = carriages_[static_cast<std::size_t>(first)];
    ++first;
  }
  while (last < shorter - first &&
         lines[lines.size() - 1 - last] == lines_[lines_.size() - 1 - last]) {
    ++last;
    ends[static_cast<std::size_t>(lines.size() - last)] =
        carriages_[static_cast<std::size_t>(lines_.size() - last)];
  }
  qsizetype from = first;
  for (qsizetype i = first; i < lines.size() - last; ++i) {
    const qsizetype found = lines_.indexOf(lines[i], from);
    if (found >= 0 && found < lines_.size() - last) {
      ends[static_cast<std::size_t>(i)] = carriages_[static_cast<std::size_t>(found)];
      from = found + 1;
    }
  }
  return ends;
}

QByteArray TextForm::bytes_of(const QString& text) const {
  QByteArray bytes = text.toUtf8();
  if (!lines_.isEmpty()) {
    const QList<QByteArray> lines = bytes.split('\n');
    const std::vector<bool> ends = ends_of(lines);
    bytes.clear();
    for (qsizetype i = 0; i + 1 < lines.size(); ++i) {
      bytes += lines[i] + (ends[static_cast<std::size_t>(i)] ? "\r\n" : "\n");
    }
    bytes += lines.back();
  } else if (most_have_carriages_) {
    bytes.replace("\n", "\r\n");
  }
  return (has_mark_ ? QByteArray(kMark) : QByteArray()) + bytes;
}

}  // namespace elsie::desktop
