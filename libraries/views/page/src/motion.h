// What moves and changes in a run, sample by sample: poses, what robots shine and plugins draw,
// fields of the floor.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "elsie/api/image.h"
#include "elsie/page/viewer.h"
#include "elsie/recording/recorded_run.h"
#include "elsie/world/description.h"

#include "layer.h"

namespace elsie::page {

bool is_finite(const Pose& pose);

/// Bodies have numbers, in the order in which they first appear.
class Bodies {
 public:
  std::size_t number(const std::string& name) {
    return numbers_.try_emplace(name, numbers_.size()).first->second;
  }
  std::size_t size() const { return numbers_.size(); }

  static std::string robot(const std::string& id) { return "robot/" + id; }
  static std::string segment(const std::string& id, std::size_t k) {
    return robot(id) + "/" + std::to_string(k);
  }
  static std::string box(const std::string& id) { return "box/" + id; }

 private:
  std::map<std::string, std::size_t> numbers_;
};

/// A part with keys at samples, of which each `every`th is left.
class SampledLayer : public Layer {
 public:
  /// `fewest`: as many samples stay.
  explicit SampledLayer(Sample fewest) : fewest_(fewest) {}
  bool thin() override;
  /// Leaves each `every`th key also of what was added since it last did so.
  void settle() {
    if (every_ > 1) thin_keys(every_, last_);
  }
  Sample every() const { return every_; }
  /// How many numbers it has, about.
  std::size_t size() const { return size_; }

 protected:
  virtual void thin_keys(Sample every, Sample last) = 0;

  Sample last_ = 0;
  Sample every_ = 1;
  std::size_t size_ = 0;

 private:
  Sample fewest_;
};

/// What is more than where things are may become very coarse.
inline constexpr Sample kFewestOthers = 8;

class Poses final : public SampledLayer {
 public:
  Poses() : SampledLayer(kFewestSamples) {}
  void add(Sample sample, const recording::RecordedRun& run, const world::World& world,
           Bodies& bodies);
  std::string text() const override;

 private:
  struct Place {
    std::int32_t x = 0, y = 0, heading = 0;
    bool there = false;
    bool set = false;  // put there, and not driven
    friend bool operator==(const Place&, const Place&) = default;
  };

  void put(std::size_t body, Sample sample, const Pose& pose, bool set);
  void thin_keys(Sample every, Sample last) override;

  std::vector<Keys<Place>> places_;
  std::map<std::string, std::size_t> times_placed_;  // of robots
  std::map<std::string, Pose> starts_;               // of boxes
};

/// What robots shine.
class Lights final : public SampledLayer {
 public:
  Lights() : SampledLayer(kFewestOthers) {}
  void add(Sample sample, const recording::RecordedRun& run, Bodies& bodies);
  std::string text() const override;

 private:
  struct Light {
    std::array<int, 2> place{};  // ahead and to the left of the robot, 0.1 mm
    Colour colour;
    friend bool operator==(const Light&, const Light&) = default;
  };
  void thin_keys(Sample every, Sample last) override;

  std::map<std::size_t, Keys<std::vector<Light>>> lights_;  // by body
};

/// What plugins draw, in the frames of their robots, mm.
class Sketches final : public SampledLayer {
 public:
  Sketches() : SampledLayer(kFewestOthers) {}
  void add(Sample sample, const recording::RecordedRun& run, Bodies& bodies);
  std::string text() const override;

 private:
  struct Marks {
    std::vector<int> numbers;  // kind * 8 + role, number of places, their x, y, z, mm
    std::vector<std::string> texts;
    friend bool operator==(const Marks&, const Marks&) = default;
  };
  static void append(Marks& marks, const Sketch& sketch, const Pose& robot);
  void thin_keys(Sample every, Sample last) override;

  std::map<int, Keys<Marks>> marks_;  // by body; -1: of measures
};

/// Fields of the floor, as opacities.
class Fields final : public SampledLayer {
 public:
  Fields() : SampledLayer(kFewestOthers) {}
  void add(Sample sample, const recording::RecordedRun& run, const world::World& world);
  std::string text() const override;

 private:
  struct Grid {
    std::size_t columns = 0, rows = 0;
    std::vector<std::uint8_t> cells;
    friend bool operator==(const Grid&, const Grid&) = default;
  };
  struct Field {
    Colour colour;
    Keys<Grid> grids;
    Keys<std::string> tops;  // the values that are shown as solid, units/m2
  };
  void thin_keys(Sample every, Sample last) override;

  std::map<std::string, Field> fields_;
};

}  // namespace elsie::page
