#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>

#include "elsie/base/fnv1a.h"
#include "elsie/plugin/parameters.h"
#include "elsie/testing/sensor.h"

#include "text.h"
#include "trial.h"

namespace elsie::testing {
namespace {

/// Larger pictures take too long to draw.
constexpr int kMostPixels = 200'000;

/// FNV-1a.
double hash_of(const Image& image) {
  std::uint32_t hash = 2166136261U;
  for (const std::uint8_t byte : image.bytes) {
    hash = (hash ^ byte) * 16777619U;
  }
  return hash;
}

/// Of more numbers in an array, the answer has one that stands for all.
constexpr std::size_t kMostSingly = 64;
double hash_of(const ReadingField& array) {
  base::Fnv1a hash;
  for (std::size_t i = 0; i < array.count; ++i) {
    hash.add(array.number(i));
  }
  return static_cast<double>(hash.value() >> 11U);
}

class SensorTrial final : public Trial {
 public:
  explicit SensorTrial(const TrialSetting& setting)
      : input_(setting.input),
        settings_(setting.plugins.completed(setting.declaration, setting.settings)),
        sensor_(setting.plugins, setting.declaration.name, setting.settings, setting.elements) {
    sensor_.mounted(input_.mounting);
    camera_ = sensor_->camera();
    if (camera_ && camera_->width >= 1 && camera_->height >= 1) {
      if (camera_->width > kMostPixels / camera_->height) {
        throw Refused("its pictures are too large to be drawn for a trial");
      }
      Random random(7);
      for (int i = 0; i < 4; ++i) {
        pictures_.push_back(random_picture(camera_->width, camera_->height, random));
      }
    }
    reading_ = sensor_->reading();
    equipping([&] { sensor_.equip(*input_.scenes.front()); });
  }

  Component& object() override { return *sensor_; }
  void reset(std::uint64_t seed) override {
    sensor_.reset(seed);
    sensor_->notes();
  }
  void configure_again() override {
    plugin::apply_parameters(sensor_.declaration(), *sensor_, settings_);
    equipping([&] { sensor_.equip(*input_.scenes.front()); });
  }

  bool take_over(Trial& before) override {
    return sensor_.take_over(static_cast<SensorTrial&>(before).sensor_);
  }

  void step(std::size_t step, Answer& answer) override {
    require_sound();
    const std::size_t at = step % input_.poses.size();
    Surroundings& around = *input_.scenes[step / 8 % input_.scenes.size()];
    const Pose& pose = input_.poses[at];
    around.at(pose.x, pose.y, degrees(pose.heading_rad));
    sensor_.update(static_cast<const elsie::Surroundings&>(around),
                   pictures_.empty() ? nullptr : &pictures_[at % pictures_.size()]);
    answer.clear();
    std::size_t place = 0;
    const bool is_first = names_.empty();
    sensor_->visit_fields(sensor_->reading(), [&](const ReadingField& field) {
      if (is_first) names_.push_back(field.column(0));
      require_name(place++, field.column(0));
      if (!field.is_number()) {
        answer.add("the picture '" + field.path() + "'", hash_of(field.picture()));
      } else if (field.count > kMostSingly) {
        answer.add("the array '" + field.path() + "'", hash_of(field));
      } else {
        for (std::size_t i = 0; i < field.count; ++i) {
          answer.add(field.column(i), field.number(i));
        }
      }
    });
    if (names_.size() != place) {
      throw Wrong("its reading lists " + std::to_string(place) + " names, and " +
                  std::to_string(names_.size()) + " before");
    }
  }

  std::size_t run_length() const override {
    if (pictures_.empty()) {
      return Trial::run_length();
    }
    // Pictures take a long time.
    const auto pixels =
        static_cast<std::size_t>(camera_->width) * static_cast<std::size_t>(camera_->height);
    return std::clamp<std::size_t>(400'000 / pixels, 10, Trial::run_length());
  }

 private:
  /// Requires that this place of visit() has the name that it had before.
  void require_name(std::size_t place, const std::string& name) const {
    if (place < names_.size() && names_[place] != name) {
      throw Wrong("its reading lists '" + name + "' where it listed '" + names_[place] +
                  "' before");
    }
  }

  void require_sound() const {
    if (camera_ &&
        !(camera_->width >= 1 && camera_->height >= 1 && camera_->horizontal_fov_rad > 0.0 &&
          camera_->horizontal_fov_rad < std::numbers::pi)) {
      throw Wrong("its camera has " + std::to_string(camera_->width) + " x " +
                  std::to_string(camera_->height) + " pixels and a field of view of " +
                  number_text(camera_->horizontal_fov_rad) + " rad, which makes no picture");
    }
    if (sensor_->reading() != reading_) {
      throw Wrong("its reading has moved in memory; derive it from elsie::SensorOf");
    }
    const ReadingDeclaration& declared = sensor_.declaration().produces.front();
    const ReadingKind kind = sensor_->kind();
    if (declared.kind != kind.name || declared.size != kind.size) {
      throw Wrong("it makes readings of the kind '" + std::string(kind.name) + "', but declares '" +
                  declared.kind + "'");
    }
  }

  const Input& input_;
  Settings settings_;
  mutable Sensor sensor_;
  std::optional<Camera> camera_;
  std::vector<Image> pictures_;
  const void* reading_ = nullptr;
  std::vector<std::string> names_;
};

}  // namespace

std::unique_ptr<Trial> make_sensor_trial(const TrialSetting& setting) {
  return std::make_unique<SensorTrial>(setting);
}

}  // namespace elsie::testing
