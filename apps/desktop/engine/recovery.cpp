#include "engine/recovery.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QUuid>
#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "elsie/files/write_whole.h"

#include "engine/json.h"

namespace elsie::desktop {
namespace {

QDir folder() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/recovery");
}

QString lock_of(const QString& kept_in) { return kept_in + ".lock"; }

/// A descriptor that holds the lock until it is closed; -1 if another process holds it, or if there
/// is no such file.
int locked(const QString& kept_in, int flags) {
  const int descriptor =
      ::open(QFile::encodeName(lock_of(kept_in)).constData(), O_RDWR | O_CLOEXEC | flags, 0600);
  if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    const int error = errno;
    ::close(descriptor);
    errno = error;
    return -1;
  }
  return descriptor;
}

bool is_open_in_a_window(const QString& kept_in) {
  const int lock = locked(kept_in, 0);
  const bool is_held = lock < 0 && errno == EWOULDBLOCK;
  if (lock >= 0) {
    ::close(lock);
  }
  return is_held;
}

}  // namespace

Recovery::Recovery()
    : kept_in_(folder().filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) + ".json")) {}

Recovery::~Recovery() {
  if (lock_ >= 0) {
    if (!QFile::exists(kept_in_)) {
      QFile::remove(lock_of(kept_in_));
    }
    ::close(lock_);
  }
}

bool Recovery::keep(const Recovered& work) {
  folder().mkpath(".");
  if (lock_ < 0) {
    lock_ = locked(kept_in_, O_CREAT);
  }
  Json json{{"file", work.file.toStdString()},
            {"text", work.text.toStdString()},
            {"borrowed", work.is_borrowed}};
  for (const auto& [name, all] : {std::pair{"typed", &work.typed}, {"sources", &work.sources}}) {
    for (const Typed& each : *all) {
      json[name].push_back({{"path", each.path.toStdString()}, {"text", each.text.toStdString()}});
    }
  }
  for (const QString& each : work.plugins) json["plugins"].push_back(each.toStdString());
  return files::write_whole(kept_in_.toStdString(), json.dump()) == 0;
}

void Recovery::forget() { QFile::remove(kept_in_); }

std::vector<Recovered> Recovery::left_behind() {
  std::vector<Recovered> all;
  const QDir kept = folder();
  for (const QString& name : kept.entryList({"*.json"}, QDir::Files, QDir::Time)) {
    const QString path = kept.filePath(name);
    QFile file(path);
    if (is_open_in_a_window(path) || !file.open(QIODevice::ReadOnly)) {
      continue;
    }
    const Json json = Json::parse(file.readAll().toStdString(), nullptr, false);
    all.push_back({text_of(json, "file"), text_of(json, "text"), member(json, "borrowed") == true,
                   path, !member(json, "text").is_string()});
    for (const Json& each : member(json, "plugins")) all.back().plugins << written(each);
    for (const auto& [what, list] :
         {std::pair{"typed", &all.back().typed}, {"sources", &all.back().sources}}) {
      for (const Json& each : member(json, what)) {
        list->push_back({text_of(each, "path"), text_of(each, "text")});
      }
    }
  }
  return all;
}

void Recovery::discard(const Recovered& recovered) {
  QFile::remove(recovered.kept_in);
  QFile::remove(lock_of(recovered.kept_in));
}

}  // namespace elsie::desktop
