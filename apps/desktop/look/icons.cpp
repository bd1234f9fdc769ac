#include "look/icons.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

#include "look/theme.h"
#include "paint/axes.h"

void load_icons() { Q_INIT_RESOURCE(icons); }  // the macro wants no namespace

namespace elsie::desktop {
namespace {

QString file_of(const QString& name) { return ":/elsie/icons/" + name + ".svg"; }

/// Draws the lines of a picture in the colour of texts next to it.
class LineIcon : public QIconEngine {
 public:
  explicit LineIcon(QString name) : name_(std::move(name)) {
    QFile file(file_of(name_));
    if (file.open(QIODevice::ReadOnly)) lines_ = file.readAll();
  }

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    const double scale = painter->device() ? painter->device()->devicePixelRatioF() : 1.0;
    painter->drawPixmap(rect, scaledPixmap(rect.size() * scale, mode, state, scale));
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    return scaledPixmap(size, mode, state, 1.0);
  }

  /// `size` is in pixels of the device.
  QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State, qreal scale) override {
    const QPalette palette = QGuiApplication::palette();
    const bool is_off = mode == QIcon::Disabled;
    const QColor lines =
        mode == QIcon::Selected
            ? palette.color(QPalette::HighlightedText)
            : palette.color(is_off ? QPalette::Disabled : QPalette::Active, QPalette::ButtonText);
    const bool is_plain = is_off || mode == QIcon::Selected;
    const QString key =
        QString("%1 %2 %3 %4 %5").arg(name_, lines.name()).arg(size.width()).arg(scale).arg(mode);
    QPixmap drawn;
    if (!QPixmapCache::find(key, &drawn)) {
      const QByteArray line = lines.name().toLatin1();
      QByteArray picture = lines_;
      picture.replace("currentColor", line);
      picture.replace("accentColor", is_plain ? line : accent(palette).name().toLatin1());
      picture.replace("errorColor", is_plain ? line : red(palette).name().toLatin1());
      drawn = QPixmap(size);
      drawn.fill(Qt::transparent);
      QPainter painter(&drawn);
      QSvgRenderer(picture).render(&painter, QRectF(QPointF(), size));
      painter.end();
      QPixmapCache::insert(key, drawn);
    }
    drawn.setDevicePixelRatio(scale);
    return drawn;
  }

  QIconEngine* clone() const override { return new LineIcon(*this); }

 private:
  QString name_;
  QByteArray lines_;
};

}  // namespace

QIcon icon(const QString& name) {
  static const bool is_loaded = (load_icons(), true);
  return is_loaded && QFile::exists(file_of(name)) ? QIcon(new LineIcon(name)) : QIcon();
}

}  // namespace elsie::desktop
