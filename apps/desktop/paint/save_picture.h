// Pictures that are written whole or not at all.
#pragma once

#include <QString>

class QImage;

namespace elsie::desktop {

/// Writes the picture in the format of the file's ending. Returns "", or why it was not written;
/// the file is then unchanged.
QString save_picture(const QImage& picture, const QString& file);

}  // namespace elsie::desktop
