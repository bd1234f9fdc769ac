#include "engine/past.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "elsie/base/error.h"
#include "elsie/files/base64.h"

#include "engine/workbench.h"

namespace elsie::desktop {
namespace {

constexpr double kRounding_s = 1e-6;  // rounding errors in sums of steps
constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

template <class Number>
std::vector<Number> unpacked(const Json& text) {
  std::optional<std::vector<Number>> numbers;
  if (text.is_string()) {
    numbers = files::unpacked<Number>(text.get_ref<const std::string&>());
  }
  if (!numbers) {
    throw base::Error("samples of the past are no numbers in base64");
  }
  return *std::move(numbers);
}

template <class Number>
void drop_every_second(std::vector<Number>& numbers) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    numbers[kept++] = numbers[i];
  }
  numbers.resize(kept);
}

}  // namespace

const std::vector<float>* Samples::curve(const QString& name) const {
  const auto found = curves_.find(name);
  return found == curves_.end() ? nullptr : &found->second;
}

QStringList Samples::names() const {
  QStringList names;
  for (const auto& [name, values] : curves_) {
    names << name;
  }
  return names;
}

std::size_t Samples::count_until(double time_s) const {
  return static_cast<std::size_t>(
      std::upper_bound(times_.begin(), times_.end(), time_s + kRounding_s) - times_.begin());
}

float Samples::at(const QString& name, double time_s) const {
  const std::vector<float>* const values = curve(name);
  const std::size_t count = count_until(time_s);
  return values && count > 0 ? (*values)[count - 1] : kMissing;
}

void Samples::clear() {
  times_.clear();
  curves_.clear();
  period_s_ = 0.0;
  ++revision_;
}

void Samples::thin_out() {
  drop_every_second(times_);
  for (auto& [name, values] : curves_) {
    drop_every_second(values);
  }
  period_s_ *= 2.0;
  ++revision_;
}

void Samples::add(const Json& answer) {
  const double period_s = number_of(answer, "period_s");
  const std::vector<double> times = unpacked<double>(member(answer, "times"));
  if (!(period_s > 0.0) || !std::is_sorted(times.begin(), times.end()) ||
      (!times.empty() && !times_.empty() && times.front() <= times_.back())) {
    throw base::Error("samples of the past are not in the order of their times");
  }
  if (period_s_ == 0.0) {
    period_s_ = period_s;
  }
  while (period_s_ < 0.75 * period_s) {
    thin_out();
  }
  const Json& names = member(answer, "curves");
  const std::vector<float> values = unpacked<float>(member(answer, "values"));
  if (values.size() != names.size() * times.size()) {
    throw base::Error("samples of the past have more or fewer values than curves and times");
  }
  auto from = values.begin();
  for (const Json& name : names) {
    const auto end = from + static_cast<std::ptrdiff_t>(times.size());
    if (!name.is_string()) {
      throw base::Error("a curve of the past has no name");
    }
    std::vector<float>& curve = curves_[QString::fromStdString(name.get_ref<const std::string&>())];
    curve.resize(times_.size(), kMissing);
    curve.insert(curve.end(), from, end);
    from = end;
  }
  times_.insert(times_.end(), times.begin(), times.end());
  for (auto& [name, curve] : curves_) {
    curve.resize(times_.size(), kMissing);
  }
}

Json Instant::state_of(const QString& robot) const {
  const std::string before = robot.toStdString() + '/';
  const std::string asked = "/asked";  // of a behaviour; that of the robot has parts
  Json of_robot{{"id", robot.toStdString()}, {"members", Json::array()}};
  for (const auto& [name, value] : numbers.items()) {
    if (!name.starts_with(before)) continue;
    const std::string rest = name.substr(before.size());
    if (rest == "speed" || rest == "energy") of_robot[rest] = value;
    if (rest.ends_with(asked) && value != 0.0) {
      const std::string path = rest.substr(0, rest.size() - asked.size());
      of_robot["members"].push_back(
          {{"path", path},
           {"asked", true},
           {"weight", number_of(numbers, (before + path + "/weight").c_str())}});
    }
  }
  return {{"time_s", time_s}, {"robots", {of_robot}}};
}

Past::Past(Workbench& workbench, QObject* parent) : QObject(parent), workbench_(workbench) {
  connect(&workbench_, &Workbench::snapshot, this, &Past::look);
  connect(&workbench_, &Workbench::run_changed, this, [this] {
    if (workbench_.run_state() == Workbench::Run::ready ||
        workbench_.run_state() == Workbench::Run::none) {
      restart();
    }
    look();
  });
  // An edit at the start changes the start; later ones change what follows.
  connect(&workbench_, &Workbench::described, this, [this] {
    if (workbench_.run_state() == Workbench::Run::ready) {
      restart();
    }
    look();
  });
  connect(&workbench_, &Workbench::engine_lost, this, [this] { restart(); });
}

/// Drops the answer that may be on its way.
void Past::ask_again(Part& part) {
  part.is_asked = false;
  ++part.turn;
}

void Past::restart() {
  for (Part* part : {&paths_, &numbers_}) {
    ask_again(*part);
    part->samples.clear();
  }
  placed_.clear();
  next_.reset();
  layout_ = 0;
  Q_EMIT paths_changed();
  Q_EMIT numbers_changed();
}

void Past::request_paths(bool is_requested) {
  paths_.is_requested = is_requested;
  ask(paths_);
}

void Past::request_numbers(const QStringList& numbers, const QStringList& robots) {
  const bool are_new = std::any_of(numbers.begin(), numbers.end(), [this](const QString& name) {
    return !requested_.contains(name);
  });
  const bool are_others = robots != robots_;
  requested_ = numbers;
  robots_ = robots;
  numbers_.is_requested = true;
  if (are_others) {
    layout_ = 0;
  }
  if (are_new) {
    next_.emplace();
  }
  if (are_new || are_others) {
    ask_again(numbers_);
  }
  ask(numbers_);
}

void Past::request_no_numbers() { numbers_.is_requested = false; }

void Past::look() {
  ask(paths_);
  ask(numbers_);
}

void Past::ask(Part& part) {
  if (!part.is_requested || part.is_asked || !workbench_.tree().is_object()) {
    part.is_asked_for_later = part.is_asked;
    return;
  }
  const bool of_numbers = &part == &numbers_;
  const Samples& samples = of_numbers && next_ ? *next_ : part.samples;
  const double after_s = samples.times().empty() ? -1.0 : samples.times().back();
  Json order{{"do", of_numbers ? "numbers" : "paths"}, {"after_s", after_s}};
  if (of_numbers) {
    order["names"] = list_of(requested_);
    order["robots"] = list_of(robots_);
    order["layout"] = layout_;
  }
  part.is_asked = true;
  part.is_asked_for_later = false;
  workbench_.ask(order, [this, &part, turn = part.turn, after_s](const Json& answer) {
    if (turn != part.turn) {
      return;
    }
    part.is_asked = false;
    if (!answer.contains("times")) {
      return;  // it was refused
    }
    &part == &paths_ ? take_paths(answer, after_s) : take_numbers(answer);
    if (answer.value("more", false) || part.is_asked_for_later) {
      ask(part);
    }
  });
}

void Past::take_paths(const Json& answer, double after_s) {
  paths_.samples.add(answer);
  while (!placed_.empty() && placed_.back().time_s >= after_s) {
    placed_.pop_back();  // it comes again
  }
  for (const Json& each : member(answer, "placed")) {
    placed_.push_back({text_of(each, "robot"), number_of(each, "time_s")});
  }
  Q_EMIT paths_changed();
}

void Past::take_numbers(const Json& answer) {
  (next_ ? *next_ : numbers_.samples).add(answer);
  if (next_ && !answer.value("more", false)) {
    numbers_.samples = *std::exchange(next_, std::nullopt);
  }
  if (answer.contains("names")) {
    layout_ = answer.value("layout", std::uint64_t{0});
    QStringList names;
    for (const Json& each : answer["names"]) {
      if (each.is_string()) names << QString::fromStdString(each.get<std::string>());
    }
    QHash<QString, QString> units;
    for (const auto& [name, unit] : member(answer, "units").items()) {
      if (unit.is_string()) {
        units[QString::fromStdString(name)] = QString::fromStdString(unit.get<std::string>());
      }
    }
    Q_EMIT named(names, units);
  }
  Q_EMIT numbers_changed();
}

}  // namespace elsie::desktop
