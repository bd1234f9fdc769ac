// The fuzzy models of a robot, with their present values.
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "engine/json.h"

class QComboBox;

namespace elsie::desktop {

class ControlSurface;
struct FuzzyInstant;

/// For the chosen model: each input with its terms, the present value and its degrees; the rules
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
  void clear();

  /// What the chosen model computes from the last state.
  const FuzzyInstant& now() const;
  /// Why the model cannot be shown; "" if it can.
  QString problem() const;

 private:
  class Page;

  void load();

  QString robot_;
  QComboBox* models_;
  Page* page_;
  ControlSurface* surface_;
};

}  // namespace elsie::desktop
