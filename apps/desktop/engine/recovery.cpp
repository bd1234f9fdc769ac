#include "engine/recovery.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <csignal>

#include "elsie/base/write_whole.h"

#include "engine/elements.h"

namespace elsie::desktop {
namespace {

QDir folder() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/recovery");
}

}  // namespace

Recovery::Recovery() {
  static int windows = 0;
  kept_in_ = folder().filePath(
      QString("%1-%2.json").arg(QCoreApplication::applicationPid()).arg(++windows));
}

Recovery::~Recovery() { forget(); }

bool Recovery::keep(const QString& file, const QString& text) {
  folder().mkpath(".");
  const Json json{{"file", file.toStdString()}, {"text", text.toStdString()}};
  return base::write_whole(kept_in_.toStdString(), json.dump()) == 0;
}

void Recovery::forget() { QFile::remove(kept_in_); }

std::vector<Recovered> Recovery::left_behind() {
  std::vector<Recovered> all;
  const QDir kept = folder();
  for (const QString& name : kept.entryList({"*-*.json"}, QDir::Files, QDir::Time)) {
    const int process = name.section('-', 0, 0).toInt();
    if (process <= 0 || ::kill(process, 0) == 0) {
      continue;  // its window is open
    }
    QFile file(kept.filePath(name));
    if (!file.open(QIODevice::ReadOnly)) {
      continue;
    }
    const Json json = Json::parse(file.readAll().toStdString(), nullptr, false);
    const auto member = [&json](const char* word) {
      const auto found = json.is_object() ? json.find(word) : json.end();
      return found != json.end() && found->is_string()
                 ? std::optional(QString::fromStdString(found->get<std::string>()))
                 : std::nullopt;
    };
    const auto text = member("text");
    all.push_back(
        {member("file").value_or(QString()), text.value_or(QString()), file.fileName(), !text});
  }
  return all;
}

void Recovery::discard(const Recovered& recovered) { QFile::remove(recovered.kept_in); }

}  // namespace elsie::desktop
