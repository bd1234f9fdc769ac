#include "training/trainer.h"

#include <QProcess>
#include <QTimer>

namespace elsie::desktop {
namespace {

constexpr int kUntrained = 1;  // exit code for a network on the plateau, which is written
constexpr int kGrace_ms = 1000;

/// The ids of the behaviours in the path of a coordinator, in the form of `elsie train --behavior`.
QString behavior_of(const QString& coordinator) {
  QStringList ids;
  for (const QString& step : coordinator.split('/')) {
    if (step.startsWith("behavior[") && step.endsWith(']')) {
      ids << step.mid(9).chopped(1);
    }
  }
  return ids.join('/');
}

}  // namespace

Trainer::Trainer(QString elsie, QStringList options, QObject* parent)
    : QObject(parent), elsie_(std::move(elsie)), options_(std::move(options)) {}

Trainer::~Trainer() { cancel(); }

void Trainer::train(const Lesson& lesson, const QString& weights) {
  QStringList arguments{"train",
                        lesson.file,
                        "--stdin",
                        "--json",
                        "--progress",
                        "--robot",
                        robot_id(lesson.coordinator),
                        "--weights",
                        weights};
  if (const QString behavior = behavior_of(lesson.coordinator); !behavior.isEmpty()) {
    arguments << "--behavior" << behavior;
  }
  if (lesson.seed) {
    arguments << "--seed" << QString::number(*lesson.seed);
  }
  for (const QString& edit : lesson.edits) {
    arguments << "--set" << edit;
  }
  report_ = {};
  process_ = std::make_unique<QProcess>();
  connect(process_.get(), &QProcess::readyReadStandardOutput, this, &Trainer::read);
  connect(process_.get(), &QProcess::finished, this, &Trainer::end);
  connect(process_.get(), &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) {
      const QString why = process_->errorString();
      process_.release()->deleteLater();
      Q_EMIT failed(tr("'%1' does not start: %2").arg(elsie_, why));
    }
  });
  process_->start(elsie_, arguments + options_);
  if (!process_) {
    return;  // it has already failed
  }
  process_->write(lesson.world.toUtf8());
  process_->closeWriteChannel();
}

// The process ends by itself, and deletes what it had begun to write.
void Trainer::cancel() {
  if (!process_) {
    return;
  }
  QProcess* ending = process_.release();
  disconnect(ending, nullptr, this, nullptr);
  connect(ending, &QProcess::finished, ending, &QObject::deleteLater);
  ending->terminate();
  QTimer::singleShot(kGrace_ms, ending, &QProcess::kill);
}

void Trainer::read() {
  while (process_ && process_->canReadLine()) {
    Json line = Json::parse(process_->readLine().toStdString(), nullptr, false);
    if (!line.is_object()) {
      continue;
    }
    if (line.contains("curve")) {
      report_ = std::move(line);
    } else {
      Q_EMIT progressed(number_of(line, "presentations"), number_of(line, "of"),
                        number_of(line, "error"));
    }
  }
}

void Trainer::end(int exit_code) {
  read();
  if (!process_) {
    return;
  }
  const bool is_crash = process_->exitStatus() == QProcess::CrashExit;
  QString said = QString::fromUtf8(process_->readAllStandardError()).trimmed();
  process_.release()->deleteLater();
  if (!is_crash && (exit_code == 0 || exit_code == kUntrained) && report_.is_object()) {
    Q_EMIT trained(report_);
    return;
  }
  said.remove("elsie: ");
  Q_EMIT failed(said.isEmpty() ? tr("The training ended without a message.") : said);
}

}  // namespace elsie::desktop
