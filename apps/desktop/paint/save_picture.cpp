#include "paint/save_picture.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QImage>
#include <QImageWriter>
#include <QSaveFile>

namespace elsie::desktop {

QString save_picture(const QImage& picture, const QString& file) {
  const auto tr = [](const char* text) {
    return QCoreApplication::translate("elsie::desktop", text);
  };
  const QByteArray format = QFileInfo(file).suffix().toLower().toLatin1();
  if (!QImageWriter::supportedImageFormats().contains(format)) {
    return tr("'%1' is not a name of a picture: it must end with .png or .jpg.").arg(file);
  }
  QSaveFile written(file);
  written.setDirectWriteFallback(false);
  if (!written.open(QIODevice::WriteOnly)) {
    return tr("'%1' cannot be written: %2.").arg(file, written.errorString());
  }
  QImageWriter writer(&written, format);
  // commit() alone does not notice a full disk.
  if (!writer.write(picture) || !written.flush() || !written.commit()) {
    return tr("The picture could not be written to '%1': %2. What was there before is unchanged.")
        .arg(file, written.error() != QFileDevice::NoError ? written.errorString()
                                                           : writer.errorString());
  }
  return {};
}

}  // namespace elsie::desktop
