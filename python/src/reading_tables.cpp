// Tables of readings and of published numbers.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "elsie/base/error.h"
#include "elsie/base/near_name.h"

#include "columns.h"
#include "tables.h"

namespace elsie::python {
namespace {

using simulation::SensorView;

constexpr std::int32_t kOfNoRobot = -1;

/// A row of a table of readings.
struct Place {
  std::size_t robot, sensor;
  std::string id;
  std::vector<int> columns{};  // of each field that visit_reading() lists; -1: none
};

std::vector<Place> sensors_named(const simulation::Simulation& now, const std::string& name) {
  std::vector<Place> by_id, by_plugin, by_kind;
  std::set<std::string> names;
  for (std::size_t i = 0; i < now.robots(); ++i) {
    for (std::size_t k = 0; k < now.sensors(i); ++k) {
      const SensorView view = now.sensor(i, k);
      const Place place{i, k, std::string(view.id)};
      const std::string kind = view.sensor->kind().name;
      if (view.id == name) by_id.push_back(place);
      if (view.plugin == name) by_plugin.push_back(place);
      if (kind == name) by_kind.push_back(place);
      names.insert({place.id, std::string(view.plugin), kind});
    }
  }
  if (!by_id.empty()) return by_id;
  if (!by_plugin.empty()) return by_plugin;
  if (!by_kind.empty()) return by_kind;
  throw base::BadInput("no sensor has the id, the plugin or the kind of reading '" + name + "'" +
                       base::near_or_all(name, {names.begin(), names.end()}, "there are"));
}

/// What is known of a field after a look at all sensors of a table.
struct Known {
  FieldType type = FieldType::real64;
  bool is_list = false;  // an array or a field in a list of structs
  bool varies = false;
  std::size_t most = 0;
};

void learn(const ReadingField& field, std::map<std::string, Known>& fields,
           std::vector<std::string>& order) {
  if (!field.is_number()) return;
  const auto [known, is_new] = fields.try_emplace(field.path(), Known{.type = field.type});
  if (is_new) order.push_back(field.path());
  Known& of = known->second;
  if (of.type != field.type) of.type = FieldType::real64;
  of.is_list = of.is_list || field.is_array || !field.group.empty();
  of.varies = of.varies || field.varies;
  of.most = std::max(of.most, field.group.empty() ? field.size : field.item + field.size);
}

void put(const ReadingField& field, const Column& column, std::byte* row) {
  if (field.count == 0) return;
  const std::size_t first = field.group.empty() ? 0 : field.item;
  const std::size_t room = std::max<std::size_t>(column.most, 1);
  if (first >= room) return;
  const std::size_t count = std::min(field.count, room - first);
  std::byte* const at = row + column.at + first * column.size;
  if (column.format == column_of("", field.type).format) {
    std::memcpy(at, field.at, count * column.size);
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {  // sensors of one id, with other types
    const double number = field.number(i);
    std::memcpy(at + i * sizeof number, &number, sizeof number);
  }
}

struct Readings {
  Columns columns;
  std::vector<Place> places;

  void fill(const simulation::Simulation& now, std::span<std::byte> memory) const {
    std::byte* row = memory.data();
    for (const Place& place : places) {
      for (std::size_t i = 2; i < columns.size(); ++i) columns[i].clear(row);
      put_number(static_cast<std::int32_t>(place.robot), columns[0], row);
      put_text(place.id, columns[1], row);
      std::size_t next = 0;
      now.visit_reading(place.robot, place.sensor, [&](const ReadingField& field) {
        const int column = next < place.columns.size() ? place.columns[next] : -1;
        ++next;
        if (column >= 0) put(field, columns[static_cast<std::size_t>(column)], row);
      });
      row += columns.row_bytes();
    }
  }
};

}  // namespace

Table table_of_readings(const simulation::Simulation& now, const std::string& name) {
  Readings table;
  table.places = sensors_named(now, name);
  std::map<std::string, Known> fields;
  std::vector<std::string> order;
  std::size_t letters = 0;
  for (const Place& place : table.places) {
    letters = std::max(letters, place.id.size());
    now.visit_reading(place.robot, place.sensor,
                      [&](const ReadingField& field) { learn(field, fields, order); });
  }
  table.columns.add(column_of("robot", FieldType::int32));
  table.columns.add(text_column("sensor", letters));
  std::map<std::string, int> indices;
  for (const std::string& field : order) {
    const Known& known = fields.at(field);
    indices[field] = static_cast<int>(table.columns.add(
        column_of(field, known.type, known.is_list ? std::max<std::size_t>(known.most, 1) : 0)));
  }
  for (Place& place : table.places) {
    now.visit_reading(place.robot, place.sensor, [&](const ReadingField& field) {
      place.columns.push_back(field.is_number() ? indices.at(field.path()) : -1);
    });
  }
  const auto rows = static_cast<py::ssize_t>(table.places.size());
  const py::dtype dtype = table.columns.dtype();
  return {dtype,
          {rows},
          [table = std::make_shared<const Readings>(std::move(table))](
              const simulation::Simulation& then, std::span<std::byte> memory) {
            table->fill(then, memory);
          }};
}

Table table_of_published(const simulation::Simulation& now, const std::string& name) {
  struct Row {
    std::int32_t robot;
    std::string path;
  };
  std::vector<Row> rows;
  std::set<std::string> names;
  std::size_t letters = 0;
  const auto visit_all = [](const simulation::Simulation& then, const auto& visit) {
    for (std::size_t i = 0; i < then.robots(); ++i) {
      then.visit_published(i, [&](const simulation::PublishedValue& value) {
        visit(static_cast<std::int32_t>(i), value);
      });
    }
    then.visit_published(
        [&](const simulation::PublishedValue& value) { visit(kOfNoRobot, value); });
  };
  visit_all(now, [&](std::int32_t robot, const simulation::PublishedValue& value) {
    names.insert(value.number.name);
    if (value.number.name != name) return;
    rows.push_back({robot, std::string(value.path)});
    letters = std::max(letters, value.path.size());
  });
  if (rows.empty()) {
    throw base::BadInput("no plugin publishes a number '" + name + "'" +
                         base::near_or_all(name, {names.begin(), names.end()}, "there are"));
  }
  Columns columns;
  columns.add(column_of("robot", FieldType::int32));
  columns.add(text_column("plugin", letters));
  columns.add(column_of("value", FieldType::real64));
  const auto count = static_cast<py::ssize_t>(rows.size());
  const py::dtype dtype = columns.dtype();
  return {
      dtype,
      {count},
      [columns, visit_all, name](const simulation::Simulation& then, std::span<std::byte> memory) {
        std::byte* row = memory.data();
        const std::byte* const end = row + memory.size();
        visit_all(then, [&](std::int32_t robot, const simulation::PublishedValue& value) {
          if (value.number.name != name || row == end) return;
          put_number(robot, columns[0], row);
          put_text(value.path, columns[1], row);
          put_number(value.value, columns[2], row);
          row += columns.row_bytes();
        });
      }};
}

}  // namespace elsie::python
