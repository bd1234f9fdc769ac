#include "paint/save_picture.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QImage>
#include <QImageWriter>
#include <QSaveFile>

namespace elsie::desktop {

namespace {

QByteArray format_of(const QString& file) { return QFileInfo(file).suffix().toLower().toLatin1(); }

}  // namespace

QString wrong_picture_name(const QString& file) {
  return QImageWriter::supportedImageFormats().contains(format_of(file))
             ? QString()
             : QCoreApplication::translate(
                   "elsie::desktop",
                   "'%1' is not a name of a picture: it must end with .png or .jpg.")
                   .arg(file);
}

QString save_picture(const QImage& picture, const QString& file) {
  const auto tr = [](const char* text) {
    return QCoreApplication::translate("elsie::desktop", text);
  };
  if (const QString why = wrong_picture_name(file); !why.isEmpty()) return why;
  QSaveFile written(file);
  written.setDirectWriteFallback(false);
  if (!written.open(QIODevice::WriteOnly)) {
    return tr("'%1' cannot be written: %2.").arg(file, written.errorString());
  }
  QImageWriter writer(&written, format_of(file));
  // commit() alone does not notice a full disk.
  if (!writer.write(picture) || !written.flush() || !written.commit()) {
    return tr("The picture could not be written to '%1': %2. What was there before is unchanged.")
        .arg(file, written.error() != QFileDevice::NoError ? written.errorString()
                                                           : writer.errorString());
  }
  return {};
}

}  // namespace elsie::desktop
