#include "messages.h"

#include <cmath>

#include "elsie/base/number_text.h"
#include "elsie/files/base64.h"
#include "elsie/picture/image_file.h"
#include "elsie/traces/trace_rows.h"
#include "elsie/world/writer.h"

namespace elsie::recording {
namespace {

constexpr std::uint64_t kSecond = 1'000'000'000;

}  // namespace

std::string text_of(const Json& message) {
  return message.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json time_json(std::uint64_t time_ns) {
  return {{"sec", time_ns / kSecond}, {"nsec", time_ns % kSecond}};
}

std::uint64_t nanoseconds(double time_s) {
  return static_cast<std::uint64_t>(std::llround(time_s * static_cast<double>(kSecond)));
}

Json position_json(const Vector3& position) {
  return {{"x", position.x}, {"y", position.y}, {"z", position.z}};
}

// The quaternion of a rotation matrix, by its largest component (S. W. Shepperd, "Quaternion from
// rotation matrix", 1978). The matrix has the axes as columns.
Json rotation_json(const Frame& frame) {
  const Vector3 &f = frame.forward, &l = frame.left, &u = frame.up;
  const double squares[] = {1.0 + f.x + l.y + u.z, 1.0 + f.x - l.y - u.z, 1.0 - f.x + l.y - u.z,
                            1.0 - f.x - l.y + u.z};  // of w, x, y, z, times four
  int largest = 0;
  for (int i = 1; i < 4; ++i) {
    largest = squares[i] > squares[largest] ? i : largest;
  }
  const double twice = std::sqrt(squares[largest]);
  const double part = 0.5 / twice;
  const double wx = (l.z - u.y) * part, wy = (u.x - f.z) * part, wz = (f.y - l.x) * part;
  const double xy = (f.y + l.x) * part, xz = (u.x + f.z) * part, yz = (l.z + u.y) * part;
  const double half = 0.5 * twice;
  switch (largest) {
    case 0:
      return {{"x", wx}, {"y", wy}, {"z", wz}, {"w", half}};
    case 1:
      return {{"x", half}, {"y", xy}, {"z", xz}, {"w", wx}};
    case 2:
      return {{"x", xy}, {"y", half}, {"z", yz}, {"w", wy}};
    default:
      return {{"x", xz}, {"y", yz}, {"z", half}, {"w", wz}};
  }
}

Frame frame_of(const Pose& pose, double z) {
  return Frame::turned({pose.x, pose.y, z}, pose.heading_rad, 0.0);
}

std::string world_text(const simulation::Simulation& simulation, const std::string& program,
                       std::span<const std::size_t> crowd) {
  const world::World& world = simulation.world();
  Json robots = Json::array();
  for (const world::Robot& robot : world.robots) {
    robots.push_back(robot.id);
  }
  Json message{{"name", world.name},
               {"file", world.file},
               {"seed", std::to_string(simulation.seed())},
               {"program", program},
               {"robots", std::move(robots)}};
  for (const std::size_t place : crowd) {
    message["crowd"].push_back(world.robots[place].id);
  }
  // A world may have a hundred thousand robots: it is not copied without need.
  std::string xml = world::write_world(world);
  if (simulation.has_edits()) {
    if (std::string start = world::write_world(simulation.start()); start != xml) {
      message["start_xml"] = std::move(start);
    }
  }
  std::string text = text_of(message);
  text.pop_back();
  text += ",\"xml\":";
  text += text_of(std::move(xml));
  return text += '}';
}

void add_to_schema(const ReadingField& field, Json& properties) {
  if (!field.is_number() || field.item > 0) return;
  Json* place = &properties;
  if (!field.group.empty()) {
    Json& list = properties[std::string(field.group)];
    list["type"] = "array";
    list["items"]["type"] = "object";
    place = &list["items"]["properties"];
  }
  Json number{{"type", "number"}};
  if (!field.unit.empty()) number["description"] = field.unit;
  (*place)[std::string(field.name)] =
      field.is_array ? Json{{"type", "array"}, {"items", std::move(number)}} : number;
}

void add_to_message(const ReadingField& field, Json& sensor) {
  if (!field.is_number()) return;
  Json* place = &sensor;
  if (!field.group.empty()) {
    Json& list = sensor[std::string(field.group)];
    if (list.is_null()) list = Json::array();
    if (!field.in_list) return;
    place = &list[field.item];
  }
  Json& value = (*place)[std::string(field.name)];
  if (!field.is_array) {
    value = field.number(0);
    return;
  }
  value = Json::array();
  for (std::size_t i = 0; i < field.count; ++i) {
    value.push_back(field.number(i));
  }
}

Json pose_message(std::uint64_t time_ns, const Pose& pose) {
  const Frame frame = frame_of(pose);
  return {
      {"timestamp", time_json(time_ns)},
      {"frame_id", kWorldFrame},
      {"pose", {{"position", position_json(frame.origin)}, {"orientation", rotation_json(frame)}}}};
}

Json state_message(std::uint64_t time_ns, const simulation::Simulation& simulation,
                   std::size_t place) {
  const simulation::RobotView robot = simulation.robot(place);
  Json message{{"timestamp", time_json(time_ns)},
               {"x_m", robot.pose.x},
               {"y_m", robot.pose.y},
               {"heading_rad", robot.pose.heading_rad},
               {"forward_m_s", robot.moving.forward},
               {"lateral_m_s", robot.moving.lateral},
               {"turn_rad_s", robot.moving.turn},
               {"distance_m", robot.distance_m},
               {"energy", robot.state->energy},
               {"collisions", robot.collisions}};
  for (std::size_t a = 0; a < simulation.actuators(place); ++a) {
    const simulation::ActuatorView actuator = simulation.actuator(place, a);
    if (!actuator.shine) continue;
    message["lights"].push_back({{"by", actuator.id},
                                 {"x_m", actuator.frame.origin.x},
                                 {"y_m", actuator.frame.origin.y},
                                 {"z_m", actuator.frame.origin.z},
                                 {"red", actuator.shine->red},
                                 {"green", actuator.shine->green},
                                 {"blue", actuator.shine->blue}});
  }
  return message;
}

Json command_message(std::uint64_t decided_ns, const simulation::RobotView& robot) {
  return {{"timestamp", time_json(decided_ns)},       {"asked_forward_m_s", robot.asked.forward},
          {"asked_lateral_m_s", robot.asked.lateral}, {"asked_turn_rad_s", robot.asked.turn},
          {"forward_m_s", robot.command.forward},     {"lateral_m_s", robot.command.lateral},
          {"turn_rad_s", robot.command.turn}};
}

TraceTexts::TraceTexts(const simulation::RobotView& robot) {
  for (const simulation::TracedMember& member : robot.trace) {
    std::string start = text_of(
        {{"path", member.path}, {"plugin", member.plugin}, {"coordinator", member.coordinator}});
    start.pop_back();
    starts_.push_back(std::move(start));
  }
}

const std::string& TraceTexts::message(std::uint64_t decided_ns, const simulation::RobotView& robot,
                                       bool with_times) {
  text_ = "{\"timestamp\":{\"sec\":" + std::to_string(decided_ns / kSecond) +
          ",\"nsec\":" + std::to_string(decided_ns % kSecond) + "}";
  const Motion asked = traces::kept(robot.asked);
  add("asked_forward_m_s", asked.forward);
  add("asked_lateral_m_s", asked.lateral);
  add("asked_turn_rad_s", asked.turn);
  add(traces::kept(robot.command));
  text_ += ",\"behaviors\":[";
  for (std::size_t i = 0; i < starts_.size(); ++i) {
    const TraceRow row = traces::kept(robot.trace[i].member->trace);
    text_ += (i > 0 ? "," : "") + starts_[i];
    text_ += row.asked ? ",\"asked\":true" : ",\"asked\":false";
    add(row.command);
    add("activation", row.activation);
    add("strength", row.strength);
    add("weight", row.weight);
    add("share", row.share);
    const simulation::TracedMember* inhibitor = traces::inhibitor_of(robot.trace[i], robot.trace);
    text_ += ",\"inhibited_by\":" + text_of(inhibitor ? inhibitor->path : "");
    text_ += ",\"reason\":" + text_of(row.reason);
    if (with_times) {
      add("time_s", row.time_s);
    }
    text_ += '}';
  }
  return text_ += "]}";
}

void TraceTexts::add(const Motion& motion) {
  add("forward_m_s", motion.forward);
  add("lateral_m_s", motion.lateral);
  add("turn_rad_s", motion.turn);
}

void TraceTexts::add(const char* name, double value) {
  if (std::isfinite(value)) {
    ((text_ += ",\"") += name) += "\":";
    text_ += base::NumberText(value).view();
  }
}

std::map<std::string, std::string> trace_metadata(const simulation::RobotView& robot) {
  Json behaviors = Json::array();
  for (const simulation::TracedMember& member : robot.trace) {
    behaviors.push_back({{"path", member.path},
                         {"plugin", member.plugin},
                         {"coordinator", member.coordinator},
                         {"priority", member.member->priority()}});
  }
  const auto& coordinator = robot.description->coordinator;
  return {{"robot", robot.description->id},
          {"team", robot.description->team},
          {kCoordinator, coordinator ? coordinator->plugin : ""},
          {kBehaviors, text_of(behaviors)}};
}

Json image_message(std::uint64_t decided_ns, std::string_view robot, const Image& image) {
  return {{"timestamp", time_json(decided_ns)},
          {"frame_id", robot_frame(robot)},
          {"data", files::base64(picture::png(image))},
          {"format", "png"}};
}

Json event_message(std::uint64_t time_ns, const simulation::EventRecord& event, const Pose* where) {
  const events::Facts* const facts = events::facts_of(event.event);
  const bool bad = facts && facts->is_warning;
  const std::string name = event.name(), detail = event.detail();
  Json message{{"timestamp", time_json(time_ns)},
               {"level", bad ? kWarning : kInfo},
               {"message", detail.empty() ? name : name + ": " + detail},
               {"name", event.robot},
               {"file", ""},
               {"line", 0},
               {"event", name},
               {"detail", detail}};
  if (const auto* const edit = event.as<events::Changed>()) {
    message["element"] = edit->element;
    message["attribute"] = edit->attribute;
    message["value"] = edit->value;
    if (!edit->rule.empty()) message["rule"] = edit->rule;
  }
  if (where) {
    message["x_m"] = where->x;
    message["y_m"] = where->y;
  }
  return message;
}

Json transform_json(std::uint64_t time_ns, const std::string& child, const Frame& frame,
                    double heading_rad) {
  return {{"timestamp", time_json(time_ns)},  {"parent_frame_id", kWorldFrame},
          {"child_frame_id", child},          {"translation", position_json(frame.origin)},
          {"rotation", rotation_json(frame)}, {"heading_rad", heading_rad}};
}

}  // namespace elsie::recording
