#include "engine/text_form.h"

#include <QStringDecoder>

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
  form.has_carriages_ = 2 * bytes.count("\r\n") > bytes.count('\n');
  bytes.replace("\r\n", "\n");
  return form;
}

QByteArray TextForm::bytes_of(const QString& text) const {
  QByteArray bytes = text.toUtf8();
  if (has_carriages_) {
    bytes.replace("\n", "\r\n");
  }
  return (has_mark_ ? QByteArray(kMark) : QByteArray()) + bytes;
}

}  // namespace elsie::desktop
