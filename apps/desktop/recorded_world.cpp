#include "recorded_world.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>

namespace elsie::desktop {
namespace {

constexpr int kPatience_ms = 60'000;

bool begins_with(const QString& file, const QByteArray& mark) {
  QFile opened(file);
  return opened.open(QIODevice::ReadOnly) && opened.read(mark.size()) == mark;
}

}  // namespace

bool may_be_database(const QString& file) {
  // https://www.sqlite.org/fileformat.html, "The Database Header"
  return begins_with(file, QByteArray("SQLite format 3\0", 16));
}

bool may_be_run(const QString& file) {
  // https://mcap.dev/spec, "Magic"
  return may_be_database(file) || begins_with(file, "\x89MCAP0\r\n") || file.endsWith(".mcap");
}

std::optional<RecordedWorld> world_of_run(const QString& elsie, const QStringList& options,
                                          const QString& file, std::optional<int> run,
                                          QString& why) {
  // It stays until the system clears its folder of temporary files: the window works on it.
  QTemporaryDir folder;
  folder.setAutoRemove(false);
  RecordedWorld world{folder.filePath(QFileInfo(file).completeBaseName() + ".xml"), 1};
  QStringList words{"replay", file};
  if (run) {
    words << QString::number(*run);
  }
  QProcess replay;
  replay.start(elsie, words + QStringList{"--world", world.file} + options);
  if (!replay.waitForFinished(kPatience_ms)) {
    why = QCoreApplication::translate("RecordedWorld", "'%1' could not be read within %2 s.")
              .arg(file)
              .arg(kPatience_ms / 1000);
    return std::nullopt;
  }
  if (replay.exitCode() != 0 || !QFileInfo::exists(world.file)) {
    why = QString::fromUtf8(replay.readAllStandardError()).trimmed();
    return std::nullopt;
  }
  static const QRegularExpression seed("^the same run: .* --seed (\\d+)");
  world.seed = seed.match(QString::fromUtf8(replay.readAllStandardOutput()).section('\n', 0, 0))
                   .captured(1)
                   .toULongLong();
  return world;
}

}  // namespace elsie::desktop
