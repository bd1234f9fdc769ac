// What is asked before a picture or a film is written.
#pragma once

#include <QSize>
#include <QString>
#include <optional>

class QWidget;

namespace elsie::desktop {

/// The file to write, "" if the user cancels. `name`: the proposed one, with its ending.
QString ask_for_file(const QString& title, const QString& name, const QString& kinds,
                     QWidget* parent);

struct FilmChoice {
  QString ending = QStringLiteral("avi");
  QSize size;          // of its pictures
  double speed = 1.0;  // simulated seconds per second of the film
};
/// `shown`: the size of the view. None: the user cancels.
std::optional<FilmChoice> ask_for_film(const QSize& shown, double run_s, QWidget* parent);

inline constexpr double kUsualDpi = 96.0;  // of screens, and units of SVG and PDF per inch
inline constexpr int kNarrowest_px = 200;  // of pictures

struct PictureChoice {
  bool is_from_above = false;  // drawn; otherwise what the view shows
  QString ending = QStringLiteral("png");
  QSize size;  // pixels; from above only the width counts
  double dpi = kUsualDpi;
};
std::optional<PictureChoice> ask_for_picture(const QSize& shown, QWidget* parent);

}  // namespace elsie::desktop
