// What a run came to, as a card over the view, and what is wrong with one that goes on.
#pragma once

#include "engine/json.h"
#include "watch/card.h"

class QFormLayout;
class QLabel;
class QPushButton;

namespace elsie::desktop {

/// The end of a run: outcome, collected, distance, collisions, state hash, and why it failed. It
/// grows upwards, so that its buttons stay under the mouse from run to run.
class RunCard : public Card {
  Q_OBJECT

 public:
  explicit RunCard(QWidget* parent);

  void show_end(const Json& end);

 Q_SIGNALS:
  void again_wished();  // with the same seed
  void next_wished();   // with the next one
  void said(const QString& sentence);

 private:
  QLabel* title_;
  QLabel* why_;
  QLabel* collected_;
  QLabel* distance_;
  QLabel* collisions_;
  QLabel* seed_;
  QLabel* hash_;
  QFormLayout* facts_;
};

/// Robots that are stuck while the run goes on and, less loudly, those that nobody asks to move
/// although a goal waits for them.
class StuckNotice : public Card {
  Q_OBJECT

 public:
  explicit StuckNotice(QWidget* parent);

  /// Takes the event `stuck`. Once the user has closed the notice, it comes again when others are
  /// stuck.
  void take(const Json& event);
  void clear();
  /// Counts on.
  void show_time(double time_s);

 Q_SIGNALS:
  void robot_wished(const QString& id);

 private:
  void show_text();

  QLabel* text_;
  QPushButton* select_;
  QString robot_;  // the first that is stuck
  Json stuck_ = Json::array();
  int count_ = 0;      // of such robots, also beyond the list
  QStringList known_;  // who is stuck and why, without times
  int second_ = 0;
};

}  // namespace elsie::desktop
