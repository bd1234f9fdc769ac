// @name@: what it changes, in a sentence.
#include <elsie/api/rule.h>

class @Class@ final : public elsie::Rule {
 public:
  // Parameters of the world file. Their defaults are set only here.
  std::string robot;
  double below = 2.0;

  // Called before the first run: throws if there is no such robot.
  void equipped(const elsie::Observation& start) override { start.robot(robot); }

  void reset(elsie::Random&) override { filled_ = 0; }

  // The world at the start, then after every step. Robots may come and go: they are looked for by their ids.
  void apply(const elsie::Observation& now, elsie::WorldChanges& world) override {
    for (const elsie::ObservedRobot& each : now.robots) {
      if (each.id != robot || each.energy >= below) continue;
      world.set("robot[" + robot + "]/@energy", each.capacity);  // before the next step
      world.raise({"filled"}, robot);
      ++filled_;
    }
  }

  int filled() const { return filled_; }

 private:
  int filled_ = 0;
};

ELSIE_RULE(@Class@, "@name@", "Fills the battery of a robot that is nearly empty",
           elsie::parameter("robot", &@Class@::robot,
                            {.meaning = "id of the robot", .required = true}),
           elsie::parameter("below", &@Class@::below,
                            {.unit = "units", .min = 0, .meaning = "what counts as nearly empty"}),
           elsie::raises("filled", "the battery of the robot was filled"),
           elsie::publishes("filled", &@Class@::filled, {.meaning = "how often it did so"}));
