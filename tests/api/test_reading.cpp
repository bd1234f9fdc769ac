#include <array>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/api/perception.h"
#include "elsie/api/reading.h"
#include "elsie/api/sensor.h"
#include "elsie/base/error.h"

using namespace elsie;
using Catch::Contains;

namespace {

struct Blob {
  double distance = 0.0;
  std::array<float, 2> place{};
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("distance", distance, "m");
    visitor("place", place, "px");
  }
};

struct RichReading {
  static constexpr const char* kind = "rich";
  std::vector<double> ranges_m;
  std::uint8_t mode = 3;
  bool is_on = true;
  std::vector<int> heard;
  std::vector<Blob> blobs;
  Image picture;
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("ranges", ranges_m, "m");
    visitor("mode", mode);
    visitor("is_on", is_on);
    visitor("doubled", 2.0 * mode);
    visitor("heard", at_most(3, heard));
    visitor("blobs", at_most(2, blobs));
    visitor("picture", picture);
  }
};

/// Gives what a test has put into `next`.
class Rich final : public SensorOf<RichReading> {
 public:
  std::size_t rays = 3;
  RichReading next;
  RichReading blank() const override {
    RichReading reading;
    reading.ranges_m.resize(rays);
    return reading;
  }
  RichReading sense(const SensorContext&) override { return next; }
};

struct NoFields {
  static constexpr const char* kind = "rich";
  double value = 0.0;
};

struct Speed {
  static constexpr const char* kind = "speed";
  double first = 0.0, second = 0.0;
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("speed", first, "m/s");
  }
};
/// The same size, another field of the same name.
struct OtherSpeed {
  static constexpr const char* kind = "speed";
  double first = 0.0, second = 0.0;
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("speed", second, "m/s");
  }
};

SensorContext nowhere() { return {0.0, 0.01, {}, nullptr, nullptr, nullptr}; }

std::vector<std::string> columns(const RichReading& reading) {
  std::vector<std::string> names;
  visit_fields(reading, [&](const ReadingField& field) {
    for (std::size_t i = 0; i < field.size; ++i) {
      std::string name = field.column(i);
      if (field.is_number() && i < field.count) {
        name += "=" + std::to_string(static_cast<int>(field.number(i)));
      }
      names.push_back(name);
    }
  });
  return names;
}

/// The sentence with which a sensor refuses a reading.
std::string refusal(const RichReading& reading) {
  Rich sensor;
  sensor.fit_value();
  sensor.next = reading;
  try {
    sensor.update(nowhere());
  } catch (const base::Error& error) {
    return error.what();
  }
  return "";
}

RichReading sound() {
  RichReading reading;
  reading.ranges_m = {1.0, 2.0, 3.0};
  return reading;
}

}  // namespace

TEST_CASE("A reading lists numbers, arrays, lists and pictures, each number in a column") {
  RichReading reading = sound();
  reading.heard = {7};
  reading.blobs = {{5.0, {8.0F, 9.0F}}};
  CHECK(columns(reading) ==
        std::vector<std::string>{
            "ranges.0=1", "ranges.1=2", "ranges.2=3", "mode=3", "is_on=1", "doubled=6", "heard.0=7",
            "heard.1", "heard.2", "blobs.0.distance=5", "blobs.0.place.0=8", "blobs.0.place.1=9",
            "blobs.1.distance", "blobs.1.place.0", "blobs.1.place.1", "picture"});
}

TEST_CASE("A field has its unit, and knows whether it is part of the reading") {
  std::vector<std::string> words;
  const RichReading reading = sound();
  visit_fields(reading, [&](const ReadingField& field) {
    if (field.item == 0) {
      words.push_back(field.path() + "|" + std::string(field.unit) +
                      (field.is_stored ? "|stored" : ""));
    }
  });
  CHECK(words == std::vector<std::string>{"ranges|m|stored", "mode||stored", "is_on||stored",
                                          "doubled|", "heard||stored", "blobs.distance|m|stored",
                                          "blobs.place|px|stored", "picture||stored"});
}

TEST_CASE("A number of a reading is changed within its type") {
  RichReading reading = sound();
  const auto set = [&](const std::string& path, double value) {
    visit_fields(reading, [&](const ReadingField& field) {
      if (field.path() == path) field.set_number(0, value);
    });
  };
  set("ranges", 0.25);
  set("mode", 4.4);
  CHECK(reading.ranges_m[0] == 0.25);
  CHECK(reading.mode == 4);
  set("mode", -20.0);
  CHECK(reading.mode == 0);
  set("mode", 300.0);
  CHECK(reading.mode == 255);
}

TEST_CASE("A sensor gives arrays the sizes of a blank reading") {
  CHECK(refusal(sound()).empty());
  RichReading reading = sound();
  reading.ranges_m.push_back(4.0);
  CHECK_THAT(refusal(reading), Contains("'ranges' of its reading has 4 numbers, and 3 in a blank"));
  reading.ranges_m.resize(2);
  CHECK_THAT(refusal(reading), Contains("'ranges' of its reading has 2 numbers, and 3 in a blank"));
}

TEST_CASE("A list is no longer than it may be") {
  RichReading reading = sound();
  reading.heard = {1, 2, 3};
  reading.blobs.resize(2);
  CHECK(refusal(reading).empty());
  reading.heard.push_back(4);
  CHECK_THAT(refusal(reading),
             Contains("'heard' of its reading has 4 numbers; expected at most 3"));
  reading.heard.clear();
  reading.blobs.resize(3);
  CHECK_THAT(refusal(reading), Contains("the list 'blobs' of its reading is longer than it may"));
}

TEST_CASE("A number that is not finite names its column") {
  RichReading reading = sound();
  reading.ranges_m[1] = std::numeric_limits<double>::infinity();
  CHECK_THAT(refusal(reading), Contains("the number 'ranges.1' of its reading is inf"));
  reading = sound();
  reading.blobs.resize(2);
  reading.blobs[1].distance = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(refusal(reading), Contains("the number 'blobs.1.distance' of its reading is nan"));
}

TEST_CASE("A sensor's reading is blank until it is updated, at one address") {
  Rich sensor;
  const void* const address = sensor.reading();
  sensor.fit_value();
  CHECK(static_cast<const RichReading*>(address)->ranges_m.size() == 3);
  sensor.next = sound();
  sensor.update(nowhere());
  CHECK(sensor.reading() == address);
  sensor.fit_value();  // its parameters are the same
  CHECK(static_cast<const RichReading*>(address)->ranges_m[0] == 1.0);
  sensor.rays = 5;
  sensor.fit_value();
  CHECK(static_cast<const RichReading*>(address)->ranges_m == std::vector<double>(5, 0.0));
}

TEST_CASE("A reading is copied without its type") {
  Rich sensor;
  sensor.fit_value();
  sensor.next = sound();
  sensor.update(nowhere());
  const auto copy = sensor.new_value();
  CHECK(columns(*static_cast<const RichReading*>(copy.get()))[0] == "ranges.0=0");
  sensor.copy_value(sensor.reading(), copy.get());
  CHECK(columns(*static_cast<const RichReading*>(copy.get()))[0] == "ranges.0=1");
}

TEST_CASE("Kinds of one name are the same if their fields are") {
  CHECK(ReadingKind::of<Speed>() == ReadingKind::of<Speed>());
  CHECK_FALSE(ReadingKind::of<Speed>() == ReadingKind::of<OtherSpeed>());
  CHECK_FALSE(ReadingDeclaration::of<Speed>().fits(ReadingDeclaration::of<OtherSpeed>()));
  CHECK_FALSE(ReadingDeclaration::of<RichReading>().fits(ReadingDeclaration::of<NoFields>()));
}

TEST_CASE("Who needs a kind by its name alone takes any layout") {
  const ReadingDeclaration by_name{.kind = "speed"};
  CHECK(by_name.fits(ReadingDeclaration::of<Speed>()));
  CHECK(ReadingDeclaration::of<OtherSpeed>().fits(by_name));
}

TEST_CASE("A declaration visits readings of its kind for who does not know the struct") {
  const RichReading reading = sound();
  std::vector<std::string> fields, declared;
  ReadingDeclaration::of<RichReading>().visit(&reading, [&](const ReadingField& field) {
    fields.push_back(field.path() + "=" + std::to_string(field.count));
  });
  visit_fields(reading, [&](const ReadingField& field) {
    declared.push_back(field.path() + "=" + std::to_string(field.count));
  });
  CHECK(fields == declared);
  CHECK_FALSE(fields.empty());
}

TEST_CASE("A reading of another layout is refused where it is read") {
  const Speed speed;
  const Mounting mounting;
  const SensedReading sensed[] = {{&speed, &mounting, "meter"}};
  const ReadingGroup groups[] = {{ReadingKind::of<Speed>(), sensed}};
  Perception::Data data;
  data.groups = groups;
  Random random;
  const Perception now(data, random);
  CHECK(now.readings<Speed>().size() == 1);
  CHECK_THROWS_WITH(now.readings<OtherSpeed>(),
                    Contains("its readings of the kind 'speed' list other fields in visit() than "
                             "those of the sensor 'meter'"));
}
