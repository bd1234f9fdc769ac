// The fuzzy models of a robot, with their values, now or at the shown time of the past.
#pragma once

#include <QWidget>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "elsie/fuzzy/model.h"

#include "engine/past.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace elsie::desktop {

class ControlSurface;
struct FuzzyInstant;

/// For the chosen model: each input with its terms, its value and its degrees; the rules
/// with the degree to which each fires; each output with its accumulated set, its centre of gravity
/// and its value; the control surface.
class FuzzyPanel : public QWidget {
  Q_OBJECT

 public:
  explicit FuzzyPanel(QWidget* parent = nullptr);
  ~FuzzyPanel() override;

  void set_robot(const QString& id);
  /// Takes a `state` event.
  void add(const Json& state);
  /// Shows the values of that time; null: those of the present.
  void look_back(const Instant* then);
  /// Forgets the robot's values and all models, as for another world.
  void clear();
  /// Reads all models again, as a run does that begins; until then they are shown as they were.
  void read_again();
  /// What is wrong with a file of models, as it is on disk; "" if nothing is.
  QString mistake_in(const QString& file) const;

  /// What the chosen model computes from the shown values.
  const FuzzyInstant& now() const;
  /// Why the model cannot be shown; "" if it can.
  QString problem() const;
  /// What it says of values that are not stored; "" if they are.
  QString notice() const;

 Q_SIGNALS:
  void edit_wished(const QString& file);

 private:
  class Page;
  struct Reading {
    std::optional<fuzzy::Model> model;
    QString problem;  // why there is none
  };

  static Reading read(const QStringList& source);
  const Reading& reading_of(const QStringList& source);
  void empty();
  void load();
  void show_values();

  QString robot_;
  std::map<QStringList, Reading> read_;  // by file and block, of all robots shown
  std::map<QString, Json> present_;      // by name: each model in the last state that had it
  std::optional<Instant> then_;
  QLabel* notice_;
  QComboBox* models_;
  QPushButton* edit_;
  Page* page_;
  ControlSurface* surface_;
};

}  // namespace elsie::desktop
