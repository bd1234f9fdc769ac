#include "answer.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <elsie/base/near_name.h>
#include <elsie/base/words.h>

namespace remote {
namespace {

constexpr const char* kSignal = "remote_signal";

/// A value for a message. What nests is named only: there is no end to how deep it may.
std::string shown(const Json& value) {
  if (value.is_structured()) return value.is_array() ? "a list" : "an object";
  return elsie::base::in_quotes(value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// A message of this kind with these numbers. It is what a struct of double numbers is in C++, so
/// that behaviours in C++ hear it as theirs.
std::shared_ptr<const elsie::AnyMessage> message(std::string kind, elsie::NamedNumbers numbers) {
  struct Content {
    std::string kind;
    elsie::NamedNumbers named;
    std::vector<double> numbers;
  };
  const auto content = std::make_shared<Content>(Content{std::move(kind), std::move(numbers), {}});
  elsie::ReadingDeclaration layout;
  for (const auto& [name, value] : content->named) {
    elsie::FieldDeclaration field;
    field.name = name;
    field.offset = layout.fields.size() * sizeof value;
    field.is_single = true;
    layout.fields.push_back(std::move(field));
    content->numbers.push_back(value);
  }
  content->numbers.resize(std::max(content->numbers.size(), std::size_t{1}));
  const auto visit = [content](const void* at, const elsie::FieldVisit& see) {
    for (std::size_t i = 0; i < content->named.size(); ++i) {
      elsie::ReadingField field;
      field.name = content->named[i].first;
      field.at = static_cast<const double*>(at) + i;
      see(field);
    }
  };
  const elsie::ReadingKind of{content->kind.c_str(), content->numbers.size() * sizeof(double),
                              layout.layout()};
  return std::make_shared<const elsie::AnyMessage>(
      of, std::shared_ptr<const void>(content, content->numbers.data()), visit);
}

}  // namespace

Answer::Answer(const Json& object, std::string where)
    : object_(&object), where_(std::move(where)) {}

const Json* Answer::find(const std::string& name) {
  read_.push_back(name);
  const auto found = object_->find(name);
  return found == object_->end() ? nullptr : &*found;
}

void Answer::refuse(const std::string& problem) const { throw Unexpected(where_ + problem); }

void Answer::refuse(const std::string& name, const Json& found, const std::string& expected) const {
  refuse("its " + elsie::base::in_quotes(name) + " is " + shown(found) + "; expected " + expected);
}

std::optional<double> Answer::number(const std::string& name) {
  const Json* const found = find(name);
  if (!found) return std::nullopt;
  if (!found->is_number()) refuse(name, *found, "a number");
  return found->get<double>();
}

double Answer::degree(const std::string& name, double otherwise) {
  const double value = number(name).value_or(otherwise);
  if (!(value >= 0.0 && value <= 1.0)) refuse(name, (*object_)[name], "a number from 0 to 1");
  return value;
}

bool Answer::flag(const std::string& name) {
  const Json* const found = find(name);
  if (found && !found->is_boolean()) refuse(name, *found, "true or false");
  return found && found->get<bool>();
}

std::string Answer::text(const std::string& name, const std::string& otherwise) {
  const Json* const found = find(name);
  if (found && !found->is_string()) refuse(name, *found, "a text");
  return found ? found->get<std::string>() : otherwise;
}

std::vector<double> Answer::weights(const std::string& name, std::size_t size) {
  const Json* const found = find(name);
  std::vector<double> values;
  if (!found) return values;
  const auto refuse_list = [&] {
    refuse(name, *found,
           "a list with a number of at least 0 for each of the " +
               elsie::base::counted(size, "member"));
  };
  if (!found->is_array() || found->size() != size) refuse_list();
  for (const Json& each : *found) {
    if (!each.is_number() || each.get<double>() < 0.0) refuse_list();
    values.push_back(each.get<double>());
  }
  return values;
}

std::vector<Answer> Answer::list(const std::string& name) {
  const Json* const found = find(name);
  std::vector<Answer> items;
  if (!found) return items;
  if (!found->is_array()) refuse(name, *found, "a list of objects: [{...}]");
  for (const Json& each : *found) {
    if (!each.is_object()) refuse(name, *found, "a list of objects: [{...}]");
    items.emplace_back(each, "in '" + name + "', ");
  }
  return items;
}

std::vector<std::string> Answer::texts(const std::string& name) {
  const Json* const found = find(name);
  std::vector<std::string> items;
  if (!found) return items;
  if (!found->is_array()) refuse(name, *found, "a list of texts");
  for (const Json& each : *found) {
    if (!each.is_string()) refuse(name, *found, "a list of texts");
    items.push_back(each.get<std::string>());
  }
  return items;
}

elsie::NamedNumbers Answer::numbers(const std::string& name) {
  const Json* const found = find(name);
  if (!found) return {};
  if (!found->is_object()) refuse(name, *found, "an object of numbers: {\"x\":1}");
  return Answer(*found, where_ + "in '" + name + "', ").rest();
}

elsie::NamedNumbers Answer::rest() {
  elsie::NamedNumbers all;
  for (const auto& [name, value] : object_->items()) {
    if (std::find(read_.begin(), read_.end(), name) != read_.end()) continue;
    if (value.is_boolean()) {
      all.emplace_back(name, value.get<bool>() ? 1.0 : 0.0);
    } else if (value.is_number()) {
      all.emplace_back(name, value.get<double>());
    } else {
      refuse(name, value, "a number");
    }
  }
  return all;
}

std::optional<elsie::Motion> Answer::motion(const elsie::WheelPair& wheels) {
  const auto left = number("left"), right = number("right");
  const auto forward = number("forward"), lateral = number("lateral"), turn = number("turn");
  const bool has_motion = forward || lateral || turn;
  if (left.has_value() != right.has_value()) {
    refuse(std::string("it has '") + (left ? "left" : "right") + "' without '" +
           (left ? "right" : "left") + "'; expected the rates of both wheels");
  }
  if (left && has_motion) {
    refuse(
        "it has wheel rates ('left', 'right') and a motion ('forward', 'lateral', 'turn'); "
        "expected one of the two");
  }
  if (left) return wheels.motion({*left, *right});
  if (has_motion) {
    return elsie::Motion{forward.value_or(0.0), lateral.value_or(0.0), turn.value_or(0.0)};
  }
  return std::nullopt;
}

elsie::Status Answer::status() {
  const std::string status = text("status", "running");
  if (status == "running") return elsie::Status::running;
  if (status == "success") return elsie::Status::success;
  if (status == "failure") return elsie::Status::failure;
  refuse("status", (*object_)["status"], "\"running\", \"success\" or \"failure\"");
}

void Answer::finish() {
  for (const auto& [name, value] : object_->items()) {
    if (std::find(read_.begin(), read_.end(), name) == read_.end()) {
      refuse("there is no field " + elsie::base::in_quotes(name) +
             elsie::base::near_or_all(name, read_, "it may have"));
    }
  }
}

elsie::Response response(Answer& answer, const elsie::WheelPair& wheels) {
  elsie::Response response;
  response.command = answer.motion(wheels).value_or(elsie::Motion{});
  response.activation = answer.degree("activation", 1.0);
  response.strength = answer.degree("strength", 1.0);
  response.speed_strength = answer.degree("speed_strength", 1.0);
  response.lateral_strength = answer.degree("lateral_strength", 1.0);
  response.turn_strength = answer.degree("turn_strength", 1.0);
  response.matters_rad = answer.number("matters");
  response.status = answer.status();
  response.charge = answer.flag("charge");
  for (const std::string& event : answer.texts("events")) {
    if (event != kSignal) {
      throw Unexpected("it raises the event " + elsie::base::in_quotes(event) + "; expected '" +
                       kSignal + "', the only one that a program may raise");
    }
    response.events.push_back({event});
  }
  for (Answer& act : answer.list("acts")) {
    std::string actuator = act.text("actuator"), kind = act.text("kind");
    response.acts.emplace_back(std::move(actuator), std::move(kind), act.rest());
  }
  for (Answer& said : answer.list("say")) {
    std::string kind = said.text("kind"), to = said.text("to"), by = said.text("by");
    elsie::NamedNumbers numbers = said.numbers("numbers");
    said.finish();
    if (kind.empty()) throw Unexpected("a message in 'say' has no 'kind'; expected its name");
    response.act(std::move(by),
                 elsie::SayCommand{message(std::move(kind), std::move(numbers)), std::move(to)});
  }
  answer.finish();
  return response;
}

}  // namespace remote
