// The fuzzy models of a robot, with what they compute now.
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include <nlohmann/json_fwd.hpp>

class QComboBox;

namespace elsie::desktop {

/// For the chosen model: each input with its terms, the present value and its degrees; the rules
/// with how far each fires; each output with its accumulated set and its value.
class FuzzyPanel : public QWidget {
  Q_OBJECT

 public:
  explicit FuzzyPanel(QWidget* parent = nullptr);
  ~FuzzyPanel() override;

  void set_robot(const QString& id);
  /// Takes a `state` event.
  void add(const nlohmann::ordered_json& state);
  void clear();

  /// How far each rule fires now, in the order of the file; empty before any input.
  std::vector<double> rule_degrees() const;
  /// Why the model's file cannot be shown; or "".
  QString problem() const;

 private:
  class Page;

  void load();

  QString robot_;
  QComboBox* models_;
  Page* page_;
};

}  // namespace elsie::desktop
