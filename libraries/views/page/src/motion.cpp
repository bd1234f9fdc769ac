#include "motion.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "elsie/base/number_text.h"
#include "elsie/files/base64.h"
#include "elsie/files/clean_text.h"
#include "elsie/picture/top_view.h"

namespace elsie::page {
namespace {

/// Replaces the earlier key.
constexpr auto kLater = [](auto&, const auto&) {};

std::string quoted(const std::string& text) { return nlohmann::json(files::one_line(text)).dump(); }

template <class Value, class Of>
std::vector<std::int64_t> each(const Keys<Value>& keys, const Of& of) {
  std::vector<std::int64_t> numbers;
  numbers.reserve(keys.size());
  for (const Key<Value>& key : keys) numbers.push_back(of(key));
  return numbers;
}

template <class Value>
std::vector<std::int64_t> samples_of(const Keys<Value>& keys) {
  return each(keys, [](const auto& key) { return key.sample; });
}

/// The numbers of the keys for which something is true.
template <class Value, class If>
std::vector<std::size_t> which(const Keys<Value>& keys, const If& is) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (is(keys[i].value)) found.push_back(i);
  }
  return found;
}

std::string list_of(const Colour& colour) {
  std::string text;
  append_list(text, std::array<int, 3>{colour.red, colour.green, colour.blue});
  return text;
}

/// A place in the frame of a pose.
Vector2 seen_from(const Pose& pose, double x, double y) {
  const double c = std::cos(pose.heading_rad), s = std::sin(pose.heading_rad);
  const double dx = x - pose.x, dy = y - pose.y;
  return {c * dx + s * dy, c * dy - s * dx};
}

}  // namespace

bool is_finite(const Pose& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading_rad);
}

bool SampledLayer::thin() {
  if (last_ / every_ <= fewest_) return false;
  every_ *= 2;
  thin_keys(every_, last_);
  return true;
}

void Poses::put(std::size_t body, Sample sample, const Pose& pose, bool set) {
  if (body >= places_.size()) places_.resize(body + 1);
  Keys<Place>& keys = places_[body];
  constexpr double kFar = 1e5;  // m, rad; a pose beyond it does not fit, nor into a page
  const auto fits = [](double number) { return std::abs(number) <= kFar; };  // false for NaN
  if (!fits(pose.x) || !fits(pose.y) || !fits(pose.heading_rad)) return;
  // Headings go on beyond pi, so that they can be drawn between two samples.
  const double turn = 2.0 * std::numbers::pi;
  double heading_rad = pose.heading_rad;
  if (!keys.empty()) {
    heading_rad += turn * std::round((keys.back().value.heading * 1e-4 - heading_rad) / turn);
  }
  if (!fits(heading_rad)) {  // after thousands of turns it begins anew
    heading_rad = pose.heading_rad;
    set = true;
  }
  Place place{static_cast<std::int32_t>(fine(pose.x)), static_cast<std::int32_t>(fine(pose.y)),
              static_cast<std::int32_t>(fine(heading_rad)), true, false};
  if (!keys.empty()) {
    Place same = keys.back().value;
    same.set = false;
    if (same == place) return;
    place.set = set || !same.there;
  }
  keys.push_back({sample, place});
  ++size_;
}

void Poses::add(Sample sample, const recording::RecordedRun& run, const world::World& world,
                Bodies& bodies) {
  last_ = sample;
  std::vector<bool> seen(places_.size(), false);
  const auto put_and_see = [&](const std::string& name, const Pose& pose, bool set) {
    const std::size_t body = bodies.number(name);
    put(body, sample, pose, set);
    seen.resize(std::max(seen.size(), body + 1), false);
    seen[body] = true;
  };
  for (const picture::RobotTrack& track : run.robots) {
    const std::size_t placed = track.placed.size();
    put_and_see(Bodies::robot(track.id), track.now,
                std::exchange(times_placed_[track.id], placed) < placed);
    for (std::size_t k = 0; k < track.segments.size(); ++k) {
      put_and_see(Bodies::segment(track.id, k), track.segments[k], false);
    }
  }
  for (const world::Obstacle& box : world.obstacles) {
    if (!run.standing.contains(box.id)) continue;
    const auto known = run.starts.find(box.id);
    const Pose start = known != run.starts.end() ? known->second : picture::start_of(box);
    const auto moved = run.moved.find(box.id);
    const auto [before, is_new] = starts_.try_emplace(box.id, start);
    const bool set = !is_new && std::exchange(before->second, start) != start;
    put_and_see(Bodies::box(box.id), moved != run.moved.end() ? moved->second : start, set);
  }
  for (std::size_t body = 0; body < places_.size(); ++body) {
    Keys<Place>& keys = places_[body];
    if ((body < seen.size() && seen[body]) || keys.empty() || !keys.back().value.there) continue;
    Place gone = keys.back().value;
    gone.there = gone.set = false;
    keys.push_back({sample, gone});
  }
}

void Poses::thin_keys(Sample every, Sample last) {
  size_ = 0;
  for (Keys<Place>& keys : places_) {
    page::thin(keys, every, last, [](Place& kept, const Place& lost) {
      kept.set = kept.set || (lost.set && kept.there);
    });
    size_ += keys.size();
  }
}

std::string Poses::text() const {
  std::string out = "\"poses\":{\"every\":" + std::to_string(every_) + ",\"bodies\":[";
  char separator = ' ';
  for (const Keys<Place>& keys : places_) {
    (out += std::exchange(separator, ',')) += "{\"s\":";
    append_differences(out, samples_of(keys));
    append_differences(out += ",\"x\":", each(keys, [](const auto& key) { return key.value.x; }));
    append_differences(out += ",\"y\":", each(keys, [](const auto& key) { return key.value.y; }));
    append_differences(out += ",\"h\":",
                       each(keys, [](const auto& key) { return key.value.heading; }));
    append_list(out += ",\"set\":", which(keys, [](const Place& place) { return place.set; }));
    append_list(out += ",\"gone\":", which(keys, [](const Place& place) { return !place.there; }));
    out += '}';
  }
  return out += "]}";
}

void Lights::add(Sample sample, const recording::RecordedRun& run, Bodies& bodies) {
  last_ = sample;
  for (const picture::RobotTrack& track : run.robots) {
    const auto body = bodies.number(Bodies::robot(track.id));
    if (track.lights.empty() && !lights_.contains(body)) continue;
    std::vector<Light> lights;
    for (const picture::Light& light : track.lights) {
      const Vector2 at = seen_from(track.now, light.place.x, light.place.y);
      constexpr double kMm = 1e3;
      lights.push_back({{static_cast<int>(10 * std::lround(at.x * kMm)),
                         static_cast<int>(10 * std::lround(at.y * kMm))},
                        light.colour});
    }
    const std::size_t numbers = 5 * lights.size();
    if (hold(lights_[body], sample, std::move(lights))) size_ += numbers;
  }
}

void Lights::thin_keys(Sample every, Sample last) {
  size_ = 0;
  for (auto& [body, keys] : lights_) {
    page::thin(keys, every, last, kLater);
    for (const auto& key : keys) size_ += 5 * key.value.size();
  }
}

std::string Lights::text() const {
  std::string out = "\"lights\":[";
  char separator = ' ';
  for (const auto& [body, keys] : lights_) {
    (out += std::exchange(separator, ',')) += "{\"body\":" + std::to_string(body) + ",\"s\":";
    append_differences(out, samples_of(keys));
    out += ",\"of\":[";
    for (std::size_t i = 0; i < keys.size(); ++i) {
      std::vector<int> numbers;
      for (const Light& light : keys[i].value) {
        numbers.insert(numbers.end(), {light.place[0], light.place[1], light.colour.red,
                                       light.colour.green, light.colour.blue});
      }
      append_list(out += i > 0 ? "," : "", numbers);
    }
    out += "]}";
  }
  return out += ']';
}

void Sketches::append(Marks& marks, const Sketch& sketch, const Pose& robot) {
  constexpr double kMm = 1e3, kFar = 1e6;  // m; beyond it nothing is visible
  for (const Sketch::Mark& mark : sketch.marks()) {
    marks.numbers.push_back(static_cast<int>(mark.kind) * 8 + static_cast<int>(mark.role));
    marks.numbers.push_back(static_cast<int>(mark.count));
    for (const Vector3& place : sketch.places(mark)) {
      const Vector2 at = seen_from(robot, place.x, place.y);
      for (const double number : {at.x, at.y, place.z}) {
        marks.numbers.push_back(
            static_cast<int>(std::lround(kMm * std::clamp(number, -kFar, kFar))));
      }
    }
    if (mark.kind == Sketch::Kind::text) marks.texts.push_back(files::one_line(mark.text));
  }
}

void Sketches::add(Sample sample, const recording::RecordedRun& run, Bodies& bodies) {
  last_ = sample;
  const auto take = [&](int body, const std::vector<Sketch>& sketches, const Pose& frame) {
    if (sketches.empty() && !marks_.contains(body)) return;
    Marks marks;
    for (const Sketch& sketch : sketches) append(marks, sketch, frame);
    const std::size_t numbers = marks.numbers.size();
    if (hold(marks_[body], sample, std::move(marks))) size_ += numbers;
  };
  for (const picture::RobotTrack& track : run.robots) {
    if (!is_finite(track.now)) continue;
    take(static_cast<int>(bodies.number(Bodies::robot(track.id))), track.sketches, track.now);
  }
  constexpr int kMeasures = -1;
  take(kMeasures, run.sketches, {});
}

void Sketches::thin_keys(Sample every, Sample last) {
  size_ = 0;
  for (auto& [body, keys] : marks_) {
    page::thin(keys, every, last, kLater);
    for (const auto& key : keys) size_ += key.value.numbers.size();
  }
}

std::string Sketches::text() const {
  std::string out = "\"sketches\":[";
  char separator = ' ';
  for (const auto& [body, keys] : marks_) {
    (out += std::exchange(separator, ',')) += "{\"body\":" + std::to_string(body) + ",\"s\":";
    append_differences(out, samples_of(keys));
    out += ",\"marks\":[";
    for (std::size_t i = 0; i < keys.size(); ++i) {
      append_list(out += i > 0 ? "," : "", keys[i].value.numbers);
    }
    out += "],\"texts\":[";
    for (std::size_t i = 0; i < keys.size(); ++i) {
      out += i > 0 ? ",[" : "[";
      for (std::size_t k = 0; k < keys[i].value.texts.size(); ++k) {
        out += (k > 0 ? "," : "") + quoted(keys[i].value.texts[k]);
      }
      out += ']';
    }
    out += "]}";
  }
  return out += ']';
}

void Fields::add(Sample sample, const recording::RecordedRun& run, const world::World& world) {
  last_ = sample;
  for (const world::ScalarField& known : world.fields) {
    const auto recorded = run.fields.find(known.id);
    if (recorded == run.fields.end()) continue;
    picture::FloorField shown = recorded->second;
    shown.colour = known.colour;
    shown.full = known.full;
    Field& field = fields_[known.id];
    field.colour = known.colour;
    const bool is_new = hold(field.grids, sample, {shown.columns, shown.rows, shown.opacities()});
    if (is_new) size_ += shown.values.size();
    const double top = shown.solid();
    constexpr int kDigits = 3;
    hold(field.tops, sample, std::isfinite(top) ? base::number_text(top, kDigits) : "0");
  }
}

void Fields::thin_keys(Sample every, Sample last) {
  size_ = 0;
  for (auto& [id, field] : fields_) {
    page::thin(field.grids, every, last, kLater);
    page::thin(field.tops, every, last, kLater);
    for (const auto& key : field.grids) size_ += key.value.cells.size();
  }
}

std::string Fields::text() const {
  std::string out = "\"fields\":[";
  char separator = ' ';
  for (const auto& [id, field] : fields_) {
    (out += std::exchange(separator, ',')) +=
        "{\"id\":" + quoted(id) + ",\"colour\":" + list_of(field.colour) + ",\"s\":";
    append_differences(out, samples_of(field.grids));
    append_list(out += ",\"columns\":",
                each(field.grids, [](const auto& key) { return key.value.columns; }));
    out += ",\"cells\":[";
    for (std::size_t i = 0; i < field.grids.size(); ++i) {
      (out += i > 0 ? ",\"" : "\"") += files::packed(field.grids[i].value.cells) + '"';
    }
    append_differences(out += "],\"tops\":{\"s\":", samples_of(field.tops));
    out += ",\"v\":";
    char before = '[';
    for (const auto& key : field.tops) (out += std::exchange(before, ',')) += key.value;
    out += "]}}";
  }
  return out += ']';
}

}  // namespace elsie::page
