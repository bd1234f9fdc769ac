// The training page in the dialog of a coordinator that learns.
#pragma once

#include <QWidget>

#include "engine/catalog.h"
#include "training/trainer.h"

class QCheckBox;
class QHBoxLayout;
class QLabel;
class QSpinBox;

namespace elsie::desktop {

class LearningCurve;
class Workbench;

/// Shows the network's inputs and outputs, its layers, and its learning curve.
class TrainingPage : public QWidget {
  Q_OBJECT

 public:
  /// `coordinator` is its path, even if it is not in the world yet.
  TrainingPage(Workbench& workbench, const Kind& kind, QString coordinator,
               QWidget* parent = nullptr);
  ~TrainingPage() override;

  /// Whether coordinators of this kind learn; all that do have the same parameters.
  static bool learns(const Kind& kind);

  /// Shows the layers in `hidden`, such as "4 4"; "auto" and "" stand for those of a new network.
  void show_hidden(const QString& hidden);
  /// Whether the network must be trained before it is used; false while the world has no file of
  /// its own.
  bool is_wished() const;
  void wish(bool training);

  /// Trains with these edits made in the world, and with the seed of the run unless `has_seed`.
  void train(const QStringList& edits, bool has_seed);
  /// Whether the last training had these edits and the present world.
  bool has_trained(const QStringList& edits, bool has_seed) const;
  /// Stops a training; returns whether one was under way.
  bool cancel();
  /// The file that was written, as the world names it.
  QString weights() const { return weights_; }
  /// Appends a sentence to the training's report.
  void say_more(const QString& sentence);
  /// A world uses the weights now: keeps their file, and says so. Otherwise the file is deleted
  /// with this page.
  void keep_weights();

 Q_SIGNALS:
  void hidden_wished(const QString& hidden);
  /// `warning` is a sentence that says why the network is of little use; "" if it is good.
  /// `has_reached_goal`: its error is below the threshold at which the training was to end.
  void trained(const QString& warning, bool has_reached_goal);
  void failed(const QString& sentence);

 private:
  void show_sizes(const Kind& kind);
  void show_report(const Json& report);
  void remove_weights();
  void show_layers(const QStringList& sizes);
  QStringList layers() const;
  Lesson lesson(const QStringList& edits, bool has_seed) const;
  void set_busy(bool is_busy);
  /// Whether the world has a file of its own, next to which the weights are written.
  bool has_place() const;
  void show_place(bool has_place);

  Workbench& workbench_;
  QString coordinator_;
  Trainer trainer_;
  std::optional<Lesson> trained_;
  QString weights_;       // as the world names it
  QString weights_file_;  // its path, until a world uses it
  QLabel* sizes_;
  QSpinBox* count_;
  QHBoxLayout* layers_;
  QCheckBox* wished_;
  bool wish_ = false;  // while the world has no file, for when it has one
  QLabel* where_;
  QLabel* progress_;
  LearningCurve* curve_;
};

}  // namespace elsie::desktop
