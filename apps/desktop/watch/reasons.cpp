#include "watch/reasons.h"

#include <QCoreApplication>
#include <cmath>

namespace elsie::desktop {
namespace {

class Reasons {
  Q_DECLARE_TR_FUNCTIONS(Reasons)

 public:
  static QString stuck(const Json& robot, double now_s);
  static QString missing(const Json& goal);
  static QString broken(const Json& event);
  static QString outcome(const Json& end);
  static QString others(int count) { return tr("Other robots that stood still: %1.").arg(count); }
};

QString Reasons::stuck(const Json& robot, double now_s) {
  const QString why = text_of(robot, "why");
  const Json& behaviors = member(robot, "behaviors");
  const auto behavior = [&](std::size_t i) {
    return i < behaviors.size() ? written(behaviors[i]) : QString();
  };
  const QString for_s =
      QString::number(std::floor(std::max(0.0, now_s - number_of(robot, "since_s")) + 1e-6));
  const QString id = text_of(robot, "robot");
  if (why == "cancel") {
    return tr("%1 has been stuck for %2 s: %3 and %4 cancel each other.")
        .arg(id, for_s, behavior(0), behavior(1));
  }
  if (why == "blocked") {
    return tr("%1 has been stuck for %2 s: %3 drives it against something.")
        .arg(id, for_s, behavior(0));
  }
  if (why == "turning") {
    return tr("%1 has turned on the spot for %2 s: %3 decides.").arg(id, for_s, behavior(0));
  }
  if (why == "empty") {
    return tr("%1 has stood still for %2 s: its battery is empty.").arg(id, for_s);
  }
  return tr("%1 has stood still for %2 s: no behaviour asks it to move.").arg(id, for_s);
}

QString Reasons::missing(const Json& goal) {
  const QString what = text_of(goal, "goal");
  const int missing = integer_of(goal, "missing", 0), of = integer_of(goal, "of", 0);
  const QString far_m = QString::number(number_of(goal, "missing_m"), 'f', 2);
  if (what == "collect") {
    return tr("Resources that were not collected: %1 of %2.").arg(missing).arg(of);
  }
  if (what == "reach") {
    return tr("%1 ended %2 m away from the place that it should reach.")
        .arg(text_of(goal, "robot"), far_m);
  }
  if (what == "travel") {
    return tr("%1 should have driven %2 m farther.").arg(text_of(goal, "robot"), far_m);
  }
  if (what == "push") {
    return tr("'%1' ended %2 m away from the place to which it should be pushed.")
        .arg(text_of(goal, "obstacle"), far_m);
  }
  return tr("Events '%1' that a goal asks for and that did not happen: %2 of %3.")
      .arg(text_of(goal, "name"))
      .arg(missing)
      .arg(of);
}

QString Reasons::broken(const Json& event) {
  const QString robot = text_of(event, "robot"), detail = text_of(event, "detail");
  const QString time_s = QString::number(number_of(event, "time_s"), 'f', 2);
  return text_of(event, "name") == "collision"
             ? tr("%1 touched '%2' at %3 s.").arg(robot, detail, time_s)
             : tr("The battery of %1 was empty at %2 s.").arg(robot, time_s);
}

QString Reasons::outcome(const Json& end) {
  const QString outcome = text_of(end, "outcome");
  const QString time_s = QString::number(number_of(end, "time_s"), 'f', 1);
  if (outcome == "success") return tr("Success after %1 s").arg(time_s);
  if (outcome == "failure") return tr("Failed after %1 s").arg(time_s);
  if (outcome == "time_limit") return tr("Time is up after %1 s").arg(time_s);
  if (outcome == "no_goals") return tr("Ended after %1 s").arg(time_s);
  return end.contains("time_s") ? tr("Stopped after %1 s").arg(time_s) : tr("The run was stopped");
}

}  // namespace

QString why_stuck(const Json& robot, double now_s) { return Reasons::stuck(robot, now_s); }

bool is_trouble(const Json& robot) { return text_of(robot, "why") != "idle"; }

QStringList why_failed(const Json& end) {
  QStringList sentences;
  const QString outcome = text_of(end, "outcome");
  if (outcome == "success" || outcome == "no_goals") {
    return sentences;
  }
  QString reason = text_of(end, "reason");
  if (!reason.isEmpty() && outcome != "time_limit") {  // which says no more than the outcome
    reason[0] = reason[0].toUpper();
    sentences << (reason.endsWith('.') ? reason : reason + '.');
  }
  if (const Json& event = member(end, "broken_by"); event.is_object()) {
    sentences << Reasons::broken(event);
    return sentences;  // what else is open did not end it
  }
  for (const Json& goal : member(end, "open_goals")) sentences << Reasons::missing(goal);
  const double now_s = number_of(end, "time_s");
  constexpr int kMost = 3;
  int count = 0;
  for (const Json& robot : member(end, "stuck")) {
    if (++count <= kMost) sentences << Reasons::stuck(robot, now_s);
  }
  if (const int all = integer_of(end, "stuck_count", 0); all > kMost) {
    sentences << Reasons::others(all - kMost);
  }
  return sentences;
}

QString outcome_words(const Json& end) { return Reasons::outcome(end); }

}  // namespace elsie::desktop
