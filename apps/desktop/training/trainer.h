// Trains the network of a coordinator in a separate process, `elsie train`.
#pragma once

#include <QObject>
#include <QStringList>
#include <memory>
#include <optional>

#include "engine/elements.h"

class QProcess;

namespace elsie::desktop {

/// What a network is trained with.
struct Lesson {
  QString world;                      // its text
  QString file;                       // its name; other files are searched next to it
  QStringList edits;                  // made in it first, such as those that add the coordinator
  QString coordinator;                // its path: "robot[r1]/behavior[roam]/coordinator"
  std::optional<std::uint64_t> seed;  // none if the coordinator has its own

  bool operator==(const Lesson&) const = default;
};

class Trainer : public QObject {
  Q_OBJECT

 public:
  /// `elsie` is the program; `options` say where it finds plugins.
  Trainer(QString elsie, QStringList options, QObject* parent = nullptr);
  ~Trainer() override;

  bool is_busy() const { return process_ != nullptr; }
  /// Starts a training, which ends with trained() or with failed(). Must not be called while busy.
  void train(const Lesson& lesson, const QString& weights);
  /// Stops the training: nothing is written, and no more signals come.
  void cancel();

 Q_SIGNALS:
  void progressed(double presentations, double most, double error);
  /// The weights are written; the report is what `elsie train --json` prints.
  void trained(const elsie::desktop::Json& report);
  void failed(const QString& sentence);

 private:
  void read();
  void end(int exit_code);

  QString elsie_;
  QStringList options_;
  std::unique_ptr<QProcess> process_;
  Json report_;
};

}  // namespace elsie::desktop
