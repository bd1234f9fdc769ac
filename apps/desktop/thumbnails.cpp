#include "thumbnails.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace elsie::desktop {
namespace {

/// The file of the picture of a world in its present state on disk.
QString picture_of(const QString& world) {
  const QFileInfo file(world);
  const QString which = file.absoluteFilePath() + u'\n' +
                        QString::number(file.lastModified().toMSecsSinceEpoch()) + u'\n' +
                        QString::number(file.size());
  const QString folder =
      QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/pictures";
  QDir().mkpath(folder);
  return folder + '/' + QCryptographicHash::hash(which.toUtf8(), QCryptographicHash::Sha1).toHex() +
         ".png";
}

}  // namespace

Thumbnails::Thumbnails(QString elsie, QObject* parent)
    : QObject(parent), elsie_(std::move(elsie)), process_(this) {
  process_.setStandardOutputFile(QProcess::nullDevice());
  process_.setStandardErrorFile(QProcess::nullDevice());
  const auto end = [this] {
    if (!waiting_.isEmpty()) {
      const auto [world, done] = waiting_.dequeue();
      const QIcon icon(picture_of(world));
      if (!icon.isNull()) {
        done(icon);
      }
      draw_next();
    }
  };
  connect(&process_, &QProcess::finished, this, end);
  connect(&process_, &QProcess::errorOccurred, this, [end](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) end();
  });
}

Thumbnails::~Thumbnails() {
  process_.disconnect(this);
  process_.kill();
  process_.waitForFinished(1000);
}

void Thumbnails::draw(const QString& world, std::function<void(const QIcon&)> done) {
  const QString picture = picture_of(world);
  if (QFileInfo::exists(picture)) {
    done(QIcon(picture));
    return;
  }
  waiting_.enqueue({world, std::move(done)});
  if (process_.state() == QProcess::NotRunning) {
    draw_next();
  }
}

void Thumbnails::draw_next() {
  if (!waiting_.isEmpty()) {
    const QString& world = waiting_.head().first;
    process_.start(elsie_, {"picture", world, "--bare", "--output", picture_of(world), "--width",
                            QString::number(kWidth)});
  }
}

}  // namespace elsie::desktop
