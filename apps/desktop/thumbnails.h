// Small pictures of worlds, drawn by `elsie picture` in the background and kept.
#pragma once

#include <QIcon>
#include <QProcess>
#include <QQueue>
#include <functional>
#include <utility>

namespace elsie::desktop {

/// One world at a time, so that the machine stays the user's. A picture is drawn again when its
/// world has changed; a world that cannot be drawn has none.
class Thumbnails : public QObject {
  Q_OBJECT

 public:
  static constexpr int kWidth = 240;  // px

  explicit Thumbnails(QString elsie, QObject* parent = nullptr);
  ~Thumbnails() override;

  void draw(const QString& world, std::function<void(const QIcon&)> done);
  /// Those that have not been drawn are drawn no more.
  void stop() { waiting_.clear(); }

 private:
  void draw_next();

  QString elsie_;
  QProcess process_;
  QQueue<std::pair<QString, std::function<void(const QIcon&)>>> waiting_;
};

}  // namespace elsie::desktop
