#include "account.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "elsie/base/error.h"
#include "elsie/base/near_name.h"

#include "columns.h"

namespace elsie::python {
namespace {

using traces::CoordinatorAccount;
using traces::Episode;
using traces::TraceRobot;

/// An array of `rows` rows; `fill` gets each, with its index.
template <class Fill>
py::array filled(const Columns& columns, std::size_t rows, const Fill& fill) {
  const std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows)};
  py::array array(columns.dtype(), shape);
  auto* row = static_cast<std::byte*>(array.mutable_data());
  for (std::size_t i = 0; i < rows; ++i, row += columns.row_bytes()) fill(i, row);
  return array;
}

std::string path_of(const TraceRobot& robot, int member) {
  return member < 0 ? "" : robot.members[static_cast<std::size_t>(member)].path;
}

std::string decider_of(const TraceRobot& robot, traces::Decider decider) {
  return decider == traces::kTogether ? "*" : path_of(robot, decider);
}

/// The episodes of a coordinator in each part of the run with the same behaviours.
struct Part {
  const TraceRobot* robot;
  const Episode* episode;
};

}  // namespace

py::list Account::coordinators() const {
  py::list all;
  for (std::size_t i = 0; i < recorder_->robots().size(); ++i) {
    const TraceRobot& robot = recorder_->robots()[i];
    for (const CoordinatorAccount& each : recorder_->accounts()[i].coordinators) {
      all.append(py::make_tuple(robot.id, path_of(robot, each.parent)));
    }
  }
  return all;
}

py::array Account::episodes(const std::string& id, const std::string& inside) const {
  std::vector<Part> parts;
  std::set<std::string> robots, places;
  bool is_there = false;
  for (std::size_t i = 0; i < recorder_->robots().size(); ++i) {
    const TraceRobot& robot = recorder_->robots()[i];
    robots.insert(robot.id);
    if (robot.id != id) continue;
    for (const CoordinatorAccount& each : recorder_->accounts()[i].coordinators) {
      places.insert(path_of(robot, each.parent));
      if (path_of(robot, each.parent) != inside) continue;
      is_there = true;
      for (const Episode& episode : each.episodes) parts.push_back({&robot, &episode});
    }
  }
  if (!robots.contains(id)) {
    throw base::BadInput("no robot '" + id + "' was in this run" +
                         base::near_or_all(id, {robots.begin(), robots.end()}, "there were"));
  }
  if (!is_there) {
    throw base::BadInput("no behaviour '" + inside + "' of the robot '" + id +
                         "' has a coordinator" +
                         base::near_or_all(inside, {places.begin(), places.end()}, "there are"));
  }
  const auto& reasons = recorder_->reasons();
  std::size_t path_letters = 1, reason_letters = 1;
  for (const auto& [robot, episode] : parts) {
    const Episode::Part& part = episode->parts.front();
    path_letters = std::max(path_letters, decider_of(*robot, part.decider).size());
    reason_letters = std::max(reason_letters, reasons[part.reason].size());
  }
  Columns columns;
  const std::size_t from = columns.add(column_of("from_s", FieldType::real64));
  const std::size_t to = columns.add(column_of("to_s", FieldType::real64));
  const std::size_t decider = columns.add(text_column("decider", path_letters));
  const std::size_t share = columns.add(column_of("share", FieldType::real64));
  const std::size_t weight = columns.add(column_of("weight", FieldType::real64));
  const std::size_t reason = columns.add(text_column("reason", reason_letters));
  return filled(columns, parts.size(), [&](std::size_t i, std::byte* row) {
    const auto& [robot, episode] = parts[i];
    const Episode::Part& part = episode->parts.front();
    put_number(episode->from_s, columns[from], row);
    put_number(episode->to_s, columns[to], row);
    put_text(decider_of(*robot, part.decider), columns[decider], row);
    put_number(part.share, columns[share], row);
    put_number(part.weight, columns[weight], row);
    put_text(reasons[part.reason], columns[reason], row);
  });
}

py::array Account::behaviors(const std::string& id) const {
  struct Row {
    const traces::TraceMember* member;
    const traces::MemberAccount* account;
  };
  std::vector<Row> rows;
  std::size_t letters = 1;
  for (std::size_t i = 0; i < recorder_->robots().size(); ++i) {
    const TraceRobot& robot = recorder_->robots()[i];
    if (robot.id != id) continue;
    for (std::size_t k = 0; k < robot.members.size(); ++k) {
      rows.push_back({&robot.members[k], &recorder_->accounts()[i].members[k]});
      letters = std::max(letters, robot.members[k].path.size());
    }
  }
  if (rows.empty()) throw base::BadInput("no robot '" + id + "' with behaviours was in this run");
  Columns columns;
  const std::size_t path = columns.add(text_column("path", letters));
  std::vector<std::pair<std::size_t, double traces::MemberAccount::*>> numbers;
  const auto add = [&](const char* name, double traces::MemberAccount::*number) {
    numbers.emplace_back(columns.add(column_of(name, FieldType::real64)), number);
  };
  add("decided_s", &traces::MemberAccount::decided_s);
  add("longest_s", &traces::MemberAccount::longest_s);
  add("asked_s", &traces::MemberAccount::asked_s);
  add("share", &traces::MemberAccount::share);
  add("robot_share", &traces::MemberAccount::robot_share);
  add("weight", &traces::MemberAccount::weight);
  add("activation", &traces::MemberAccount::activation);
  add("strength", &traces::MemberAccount::strength);
  const std::size_t periods = columns.add(column_of("periods", FieldType::int64));
  return filled(columns, rows.size(), [&](std::size_t i, std::byte* row) {
    put_text(rows[i].member->path, columns[path], row);
    for (const auto& [column, number] : numbers) {
      put_number(rows[i].account->*number, columns[column], row);
    }
    put_number(static_cast<std::int64_t>(rows[i].account->periods), columns[periods], row);
  });
}

}  // namespace elsie::python
