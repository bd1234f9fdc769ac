// Small pictures of worlds, which `elsie picture` draws in the background and which are kept.
#pragma once

#include <QIcon>
#include <QProcess>
#include <QQueue>
#include <functional>
#include <utility>

namespace elsie::desktop {

/// Draws one world at a time, so that the machine stays responsive. A picture is drawn again when
/// its world has changed; a world that cannot be drawn has no picture.
class Thumbnails : public QObject {
  Q_OBJECT

 public:
  static constexpr int kWidth = 240;  // px

  explicit Thumbnails(QString elsie, QObject* parent = nullptr);
  ~Thumbnails() override;

  void draw(const QString& world, std::function<void(const QIcon&)> done);
  /// Drops the worlds that are waiting to be drawn.
  void stop() { waiting_.clear(); }

 private:
  void draw_next();

  QString elsie_;
  QProcess process_;
  QQueue<std::pair<QString, std::function<void(const QIcon&)>>> waiting_;
};

}  // namespace elsie::desktop
