// The stored past of the run, as far as the window has asked the engine for it.
#pragma once

#include <QHash>
#include <QObject>
#include <QStringList>
#include <map>
#include <optional>
#include <vector>

#include "engine/json.h"

namespace elsie::desktop {

class Workbench;

/// Curves over the same times: one sample per period, from the beginning of the run.
class Samples {
 public:
  /// Ascending, s.
  const std::vector<double>& times() const { return times_; }
  /// The values at these times; NaN where there is none. Null for an unknown curve.
  const std::vector<float>* curve(const QString& name) const;
  QStringList names() const;
  /// Grows when earlier samples are dropped; otherwise samples are only appended.
  int revision() const { return revision_; }
  /// The number of samples until a time, s; rounding errors in sums of steps do not count.
  std::size_t count_until(double time_s) const;
  /// The value of the last sample until a time; NaN if there is none.
  float at(const QString& name, double time_s) const;

  void clear();
  /// Adds the samples of an answer to `paths` or `numbers` (docs/internals/session.md). A curve
  /// that is new has no values before. When the engine has dropped every second sample since the
  /// last answer, this drops the same ones. Throws base::Error for an invalid answer.
  void add(const Json& answer);

 private:
  void thin_out();

  double period_s_ = 0.0;
  std::vector<double> times_;
  std::map<QString, std::vector<float>> curves_;
  int revision_ = 0;
};

/// What is stored of a time in the past, besides places: the answer to `at`
/// (docs/internals/session.md).
struct Instant {
  double time_s = 0.0;
  Json numbers;  // by name
  Json look;     // what is no number, of the robots that were watched then; null: nothing is stored

  /// NaN if it is not stored.
  double number(const QString& name) const { return number_of(numbers, name.toUtf8().constData()); }
  /// The numbers of a robot in the form of an event `state`: its speed and energy, and for the
  /// behaviours that were asked their weights.
  Json state_of(const QString& robot) const;
};

/// An edit put a robot somewhere else, where it did not drive.
struct Placed {
  QString robot;
  double time_s = 0.0;
};

/// Asks for what is requested: at most once for each picture during a run, and when the run pauses
/// or the request changes.
class Past : public QObject {
  Q_OBJECT

 public:
  explicit Past(Workbench& workbench, QObject* parent = nullptr);

  /// Whether the paths of all robots are requested.
  void request_paths(bool is_requested);
  /// Requests these numbers, and the names of all numbers of these robots; no robots: of all.
  void request_numbers(const QStringList& numbers, const QStringList& robots);
  void request_no_numbers();

  /// The curves "r1/x" and "r1/y" of all robots, m.
  const Samples& paths() const { return paths_.samples; }
  const std::vector<Placed>& placed() const { return placed_; }
  const Samples& numbers() const { return numbers_.samples; }

 Q_SIGNALS:
  void paths_changed();
  void numbers_changed();
  /// The names of all numbers of the requested robots, and the units of those that have one.
  void named(const QStringList& names, const QHash<QString, QString>& units);

 private:
  struct Part {
    bool is_requested = false;
    bool is_asked = false;
    bool is_asked_for_later = false;  // a later picture was shown meanwhile
    int turn = 0;                     // answers to earlier turns are dropped
    Samples samples;
  };

  void restart();
  void ask_again(Part& part);
  void look();
  void ask(Part& part);
  void take_paths(const Json& answer, double after_s);
  void take_numbers(const Json& answer);

  Workbench& workbench_;
  Part paths_, numbers_;
  std::vector<Placed> placed_;
  QStringList requested_, robots_;
  std::optional<Samples> next_;  // with new numbers; replaces the samples when it is complete
  std::uint64_t layout_ = 0;
};

}  // namespace elsie::desktop
