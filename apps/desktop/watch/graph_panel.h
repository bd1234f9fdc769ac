// The states or the tree of a robot's coordinators, with where it is.
#pragma once

#include <QScrollArea>
#include <QStringList>
#include <memory>
#include <optional>

#include "engine/past.h"

namespace elsie::desktop {

/// The graphs of the selected robot's coordinators, as `elsie run --graph` draws them. What is
/// running, or has succeeded or failed, is in colour; while the window looks back, as it was at the
/// shown time. A graph that is larger than the panel shrinks as long as it can be read.
class GraphPanel : public QScrollArea {
  Q_OBJECT

 public:
  explicit GraphPanel(QWidget* parent = nullptr);
  ~GraphPanel() override;

  void set_robot(const QString& id);
  /// The stored numbers(), which must outlive the panel. Call it again when they have changed.
  void set_samples(const Samples& samples);
  /// Takes a `state` event.
  void add(const Json& state);
  /// Shows what was lit at that time, s; none: what is lit now.
  void look_back(std::optional<double> time_s);
  void clear();
  /// The stored numbers that the panel needs to look back.
  QStringList numbers() const;

  /// The labels of the nodes that are running, in their order.
  QStringList running() const;
  /// What the panel says in place of a graph; "" if it shows one.
  QString notice() const;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  class Page;

  Page* page_;
};

}  // namespace elsie::desktop
