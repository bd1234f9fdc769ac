// Pictures that are written whole or not at all.
#pragma once

#include <QString>

class QImage;

namespace elsie::desktop {

/// Why no picture can have this name; "" if one can.
QString wrong_picture_name(const QString& file);
/// Writes the picture in the format of the file's ending. Returns "", or why it was not written;
/// the file is then unchanged.
QString save_picture(const QImage& picture, const QString& file);

}  // namespace elsie::desktop
