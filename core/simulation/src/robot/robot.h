// A robot at run time: its plugin objects, its own state, and its decisions.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elsie/api/actuator.h"
#include "elsie/api/drive.h"
#include "elsie/api/localisation.h"
#include "elsie/api/perception.h"
#include "elsie/api/sensor.h"
#include "elsie/base/fnv1a.h"
#include "elsie/physics/engine.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/description.h"
#include "elsie/world/drive_check.h"

#include "plugins/guard.h"
#include "plugins/plugin_object.h"
#include "robot/common_data.h"
#include "robot/controller.h"
#include "robot/disturbed_value.h"

namespace elsie::simulation {

class EditTransaction;
class Cameras;
class Fields;
class RobotSurroundings;
class Swap;

/// Time and identity of a control step, the same for all robots.
struct Instant {
  double time_s = 0.0;
  double period_s = 0.0;
  std::uint64_t step = 0;
};

/// Sums for one robot since the run began.
struct Tally {
  double distance_m = 0.0;
  double energy_used = 0.0;  // taken from the battery, units
  int collected = 0;
  int collisions = 0;
  Talk talk;
};

/// How the body of a robot has come to where it is.
enum class Arrival {
  started,  // its run has begun there
  placed,   // an edit has placed it
  stayed    // it is as it was
};

class Robot final : private RobotRequests {
 public:
  /// Makes the plugin objects of a robot of the world. Throws world::WorldError.
  Robot(const world::World& world, std::size_t index, const std::shared_ptr<CommonData>& common,
        const plugin::Host& host, const Options& options);
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;

  /// Called before a run: returns to the description, restarts random streams, resets plugin
  /// objects.
  void reset(std::uint64_t seed);

  /// Has the processor fetch what sense() reads: the slots of the sensors or, later, their objects.
  void fetch(bool objects) const;
  /// Updates all sensors. Throws PluginFault.
  void sense(const RobotSurroundings& surroundings, const Instant& now);
  /// Asks the coordinator. Its command is then in asked(), the motion of the drive in command(),
  /// the set points of the joints in wanted_joints(). Throws PluginFault.
  void decide(const Instant& now);
  /// Lets the actuators carry out what the decision tells them. Throws PluginFault.
  void act(const Instant& now, const Fields& fields);
  /// Adds what the actuators have deposited.
  void deposit_into(Fields& fields) const;
  /// Shows to others what the actuators have done; call it when all robots have acted.
  void show_effects(double next_s);
  /// Hears what other robots have sent. `loudest_m`: the largest range of a message.
  void listen(const RobotSurroundings& surroundings, double loudest_m, const Instant& now);
  /// The largest range of a message that is heard in this control period, m; 0: none is.
  double loudest_m() const;
  std::span<const HeardMessage> heard() const { return heard_; }
  /// Adds its messages that nobody has heard yet.
  void add_messages(base::Fnv1a& hash) const;
  /// How far its actuator reaches for something to hold, m; none: it holds nothing.
  const std::optional<double>& grasp(std::size_t actuator) const {
    return actuators_[actuator]->effect.grasp;
  }
  Vector3 actuator_place(std::size_t actuator) const {
    return frame_of(*actuators_[actuator]->place).origin;
  }
  /// Notes what it holds.
  void set_held(std::vector<HeldThing> held) {
    held_ = std::move(held);
    state_.held = held_;
  }
  /// Appends what its actuators shine.
  void list_lights(std::vector<LampView>& lights) const;
  /// Subtracts the energy that sensors and actuators use in a control period.
  void use_energy(double period_s);
  /// Charges for a control period if a behaviour asked for it, until full. `rate`: of the charger
  /// at the robot's place, units per second; 0 without one.
  void charge(double period_s, double rate);
  /// Copies the state of the body.
  void set_body(const physics::RobotState& state, std::span<const JointSetting> joints,
                Arrival arrival);
  /// Copies the state of the body after a step, and adds up the distance.
  void moved(const physics::RobotState& state, std::span<const JointSetting> joints, double time_s,
             double step_s);
  /// Takes over where its segments are, if sensors are on some; call it after set_body(), moved()
  /// and become().
  void take_segments(const physics::Engine& engine, std::size_t index) {
    if (!segments_.empty()) look_at_segments(engine, index);
  }
  /// Adds the energy of a collected resource, up to the capacity.
  void collect(double energy);

  // Edits by a user between two steps.

  /// m/s; the present motion of the drive is limited at once.
  void set_max_speed(double max_speed);
  /// Units, at most the battery's capacity; at 0 the robot stops.
  void set_energy(double units);
  /// See Simulation::set_priority().
  void set_priority(std::size_t behavior, double priority);
  /// Takes over attributes of the description that can be changed in place.
  void take_live(bool has_new_drive, bool has_new_energy);
  /// Visits all its plugin objects: sensors, actuators, the drive, the localisation, then
  /// behaviours and coordinators.
  void for_each(Order order, const Visit& visit) const;
  /// The object for a use of a plugin; null when it does not belong to this robot.
  PluginObject* find_object(const world::PluginUse& use) const;
  /// The same. Throws std::invalid_argument when there is none.
  Component& object(const world::PluginUse& use) const;
  /// Checks whether the plugin accepts these parameters, without setting them; passes on its
  /// exceptions. Returns the camera that a sensor would then have.
  std::optional<Camera> try_out(const PluginObject& object, const Setup& setup) {
    return object.try_out(setup, example());
  }
  /// Sets them. Passes on exceptions of the plugin, with the old parameters restored; if it refuses
  /// these, throws PluginFault.
  void set_up(PluginObject& object, const Setup& setup);

  /// Replaces the objects whose plugins have changed. Throws ReplacementRefused.
  void replace(Swap& swap, const Cameras& cameras);

  /// Takes a copy of its description with the same objects in it; the other must live on.
  void describe(const world::Robot& next);
  /// Becomes the robot with this index; `was` is its present description. Objects with unchanged
  /// descriptions stay. Adds problems to `transaction`.
  void become(const world::Robot& was, const world::World& world, std::size_t index,
              CommonData& common, EditTransaction& transaction);

  /// Collects notes and curves of the plugins after a reset. Throws PluginFault.
  void ask(Statements& said);
  /// Appends notes on what its plugins changed in the program since the run began.
  void list_late_notes(std::vector<Note>& notes) const { guard_.list_notes(notes); }
  /// Adds an event of the simulator to the next perception and to the log.
  template <class Kind>
  void raise(Kind event) {
    static_assert(Kind::kFacts.is_perceived);
    raised_.emplace_back(std::move(event));
  }
  /// The same for an event of a rule.
  void raise_by_rule(const Event& event) { raise(event); }
  void collided(events::Collision collision) {
    ++tally_.collisions;
    raise(std::move(collision));
  }
  /// Appends the numbers of one sensor's reading, or of one actuator's command. Throws PluginFault.
  void visit_reading(std::size_t sensor, const FieldVisit& visit) const {
    visit_value(*sensors_[sensor], sensors_[sensor]->declaration->produces.front(), visit);
  }
  void visit_command(std::size_t actuator, const FieldVisit& visit) const {
    visit_value(*actuators_[actuator], actuators_[actuator]->declaration->takes.front(), visit);
  }
  /// Calls `visit` for each number that its plugins publish. Throws PluginFault.
  void visit_published(const VisitPublished& visit) const;
  /// The sketches of its plugins that are not empty. Throws PluginFault.
  std::vector<PluginSketch> sketches() const;
  /// The graphs of its coordinators that show one. Throws PluginFault.
  std::vector<LitGraph> graphs() const {
    std::vector<LitGraph> list;
    controller_->list_graphs("", list);
    return list;
  }
  /// The inferences of its plugins in the last decision. Throws PluginFault.
  std::vector<MadeInference> inferences() const {
    std::vector<MadeInference> list;
    controller_->list_inferences("", list);
    return list;
  }
  /// Returns whether charge() or take_log() would do anything.
  bool needs_attention() const {
    return charge_asked_ || state_.charging || logged_ < raised_.size();
  }
  /// Appends the events since the last call to the log.
  void take_log(double time_s, std::vector<EventRecord>& log);

  const world::Robot& description() const { return *description_; }
  const OwnState& state() const { return state_; }
  /// Where it is and how it moves, whatever it believes.
  const Belief& truth() const { return truth_; }
  TeamState& team() { return team_; }
  std::span<const Colour> resource_colours() const { return resource_colours_; }
  std::vector<TeamMate>& mates() { return mates_; }
  bool empty() const { return empty_; }
  /// The last command of the coordinator.
  const Motion& asked() const { return asked_; }
  /// The same, as the drive can make it.
  const Motion& command() const { return state_.commanded; }
  /// The set points of the joints that can be set, for this command.
  std::span<const JointSetting> wanted_joints() const {
    return std::span(joints_).subspan(joint_count_);
  }
  std::span<const JointSetting> joints() const { return std::span(joints_).first(joint_count_); }
  /// The parts of its drive, for Robot::driven of the description; call it once. Empty for the
  /// default drive.
  BodyPlan take_driven() { return std::move(driven_); }
  std::span<const Member> members() const { return controller_->members(); }
  /// Listed when it is first asked for: few robots of a crowd are watched.
  std::span<const TracedMember> trace() const {
    if (trace_.empty()) controller_->list_members("", 0, -1, trace_);
    return trace_;
  }
  const Tally& tally() const { return tally_; }
  /// None: it has no actuator that hears messages.
  std::optional<Talk> talk() const {
    return state_.hears_messages ? std::optional(tally_.talk) : std::nullopt;
  }
  /// Returns whether all its plugins may be called while other threads call those of other robots.
  bool may_share_threads() const { return may_share_threads_; }
  /// Whether one of its sensors asks for contacts.
  bool feels_contacts() const { return feels_contacts_; }
  /// Notes its contacts in a step, for its sensors.
  void touched(std::span<const physics::BodyContact> contacts);
  std::span<const Contact> contacts() const { return contacts_; }
  const Motion& rolled() const { return rolled_; }
  std::size_t actuator_count() const { return actuators_.size(); }
  /// The id of an actuator.
  std::string_view actuator(std::size_t index) const override { return actuators_[index]->use->id; }
  ActuatorView actuator_view(std::size_t index) const;
  std::size_t sensor_count() const { return sensors_.size(); }
  SensorView sensor(std::size_t index) const;
  Frame sensor_frame(std::size_t index) const { return frame_of(*sensors_[index]->place); }
  /// The camera of a sensor, if it has one.
  const std::optional<Camera>& camera(std::size_t i) const { return sensors_[i]->extras().camera; }
  bool has_camera() const {
    return std::any_of(sensors_.begin(), sensors_.end(),
                       [](const auto& slot) { return slot->extras().camera.has_value(); });
  }
  /// The picture of that camera; fill it before sense().
  Image& picture(std::size_t sensor) {
    auto& picture = sensors_[sensor]->own_extras().picture;
    if (!picture) picture = std::make_unique<Image>();
    return *picture;
  }

 private:
  using LocalisationSlot = ObjectOf<Localisation, PluginKind::localisation>;
  /// A sensor or an actuator.
  template <class Object, PluginKind kKind>
  struct MountedSlot : ObjectOf<Object, kKind> {
    MountedSlot(const world::MountedUse& described, const plugin::Host& host,
                const Robot& its_robot)
        : ObjectOf<Object, kKind>(described, host), robot(its_robot) {}
    void reset(std::uint64_t seed, const std::string& path) override {
      if (disturbed) disturbed->reset(seed, path);
      PluginObject::reset(seed, path);
    }
    void forget() override { this->object().forget(); }

    const SensorPlace* place = nullptr;
    const Robot& robot;
    mutable std::unique_ptr<DisturbedValue> disturbed;  // null: neither noise nor failures
  };
  struct SensorSlot final : MountedSlot<Sensor, PluginKind::sensor> {
    using MountedSlot::MountedSlot;
    void equip(Component& object, const Example& example) const override;
    std::optional<Camera> camera_of(const Component& object) const override {
      return static_cast<const Sensor&>(object).camera();
    }

    std::size_t sensed = 0;  // the place of its reading in sensed_
  };
  /// What an actuator does in a control period.
  struct Effect {
    std::optional<Colour> shine;  // none: it is dark
    double intensity = 0.0;
    double power = 0.0;           // units per second
    std::optional<double> grasp;  // how far it reaches, m; none: it is open
  };

  struct ActuatorSlot final : MountedSlot<Actuator, PluginKind::actuator>, private Effects {
    using MountedSlot::MountedSlot;
    void equip(Component& object, const Example& example) const override;
    void shine(const Colour& colour, double intensity) override;
    void deposit(std::string_view field, double amount) override;
    void draw_power(double units_per_s) override;
    void hold(double reach_m) override;
    void transmit(const std::shared_ptr<const AnyMessage>& message, const std::string& to,
                  const Transmission& how) override;
    Effects& effects() { return *this; }
    /// Forgets its command, and those that are late.
    void forget() override;

    /// An amount for a field, by its index.
    struct Deposit {
      std::size_t field;
      Vector2 place;
      double amount;
    };
    /// A message that was sent.
    struct Sent {
      std::shared_ptr<const AnyMessage> message;
      std::string to;
      Transmission how;
      double said_s;
    };

    bool is_new = false;  // it was commanded in the last decision
    std::string by;       // Act::by() of the present command; empty: there was none
    Effect effect, shown;
    std::vector<Sent> under_way, sounding;  // sounding: heard in this control period
    double now_s = 0.0;                     // when it carries out its command
    Vector2 at;                             // where it is then
    const Fields* fields = nullptr;
    std::vector<Deposit> deposits;  // in this control period
  };

  /// A message with the id of its sender.
  struct Overheard {
    std::string_view sender;
    const ActuatorSlot* device;  // that hears it
    HeardMessage message;
  };
  void hear(const ActuatorSlot& device, const RobotSurroundings& surroundings, double loudest_m,
            const Instant& now, std::vector<Overheard>& all) const;
  void disturb(const ActuatorSlot& device, HeardMessage& heard);
  bool is_lost(const ActuatorSlot::Sent& sent, const Robot& sender, const ActuatorSlot& device,
               const Instant& now) const;
  /// How far the place is from the robot's middle, m.
  double reach_of(const SensorPlace& device) const;
  void look_at_segments(const physics::Engine& engine, std::size_t index);
  /// The frame of what a sensor or an actuator is mounted on.
  const Frame& frame_below(const SensorPlace& place) const {
    const int segment = place.mounting.segment;
    return segment == 0 ? body_frame_ : segments_[static_cast<std::size_t>(segment) - 1];
  }
  void raise(const Event& event) override {
    raised_.emplace_back(events::Raised{std::string(event.name)});
  }
  void ask_for_charge() override { charge_asked_ = true; }
  std::size_t actuator_for(Act& act) const override;
  Frame frame_of(const SensorPlace& place) const { return frame_below(place).frame(place.frame); }
  template <class Slot>
  static void fit_disturbances(const Slot& slot, Disturbable& object, const char* list,
                               const std::vector<std::string>& others = {});
  /// Throws PluginFault; passes on what `visit` throws.
  void visit_value(const PluginObject& slot, const ReadingDeclaration& declared,
                   const FieldVisit& visit) const;
  void update(SensorSlot& slot, const RobotSurroundings& surroundings, const Instant& now);
  /// Exchanges a sensor or an actuator; returns whether it did. `makes`, `made`: its values.
  template <class Slot>
  static bool exchange(Swap& swap, Slot& slot, const std::string& path, const char* makes,
                       const char* made);
  void replace_sensor(Swap& swap, SensorSlot& slot, const Cameras& cameras);
  void replace_drive(Swap& swap);
  /// Throws ReplacementRefused when a behaviour needs readings that no sensor produces.
  void check_needs() const;
  /// Makes the object of a sensor or an actuator, and places it.
  template <class Slot>
  void make_mounted(Slot& slot, const world::MountedUse& use, const plugin::Host& host,
                    std::vector<base::Problem>& problems) const;
  void take_membership(const world::World& world, std::size_t index, CommonData& common);
  void become_localised(const world::Robot& was, EditTransaction& transaction);
  /// Of sensors or actuators.
  template <class Slot>
  void become_mounted(std::vector<std::shared_ptr<Slot>>& all, const world::Robot& was,
                      const std::vector<world::MountedUse> world::Robot::*uses,
                      EditTransaction& transaction);
  void group_readings();
  void group_sensors();
  Example example();
  void stop_when_empty();
  void make_drive(const plugin::Host& host, std::vector<base::Problem>& problems);
  void take_body(const physics::RobotState& state, std::span<const JointSetting> joints);
  void make_localisation(const plugin::Host& host, std::vector<base::Problem>& problems);
  /// Takes over what the localisation answers. Throws PluginFault.
  void believe(const Belief& belief);
  const world::PluginUse& drive_use() const;
  void command(const Motion& asked);
  /// Commands the drive; the command is then the motion that it can make.
  void carry_out(const Motion& motion);

  // What each step needs, close together: a crowd is larger than the processor's caches. The end of
  // a step, when the robot has moved, needs what is up to state_.
  const world::Robot* description_;
  bool may_share_threads_ = true;
  bool feels_contacts_ = false;
  bool charge_asked_ = false;
  bool empty_ = false;
  std::uint32_t joint_count_ = 0;     // that can be set
  bool has_default_drive_ = true;     // which is the core's own
  Drive* driver_ = nullptr;           // the object of drive_
  std::vector<JointSetting> joints_;  // measured, then the set points of as many
  Tally tally_;
  Frame body_frame_;
  Belief truth_;
  LocalisationSlot* localiser_ = nullptr;  // null: it believes the truth
  OwnState state_;
  Motion rolled_;           // since sensors were last updated
  double period_s_ = 0.01;  // of the last decision
  Motion asked_;
  /// Sensors that are updated in one call: one sensor, or several of one plugin.
  struct Together {
    std::size_t first;
    std::size_t count;
  };
  std::vector<Together> together_;
  std::vector<Frame> segments_;              // if sensors are on some, else empty
  std::vector<SensorBatch::Entry> entries_;  // of the sensors
  std::vector<std::shared_ptr<SensorSlot>> sensors_;
  std::vector<std::shared_ptr<ActuatorSlot>> actuators_;
  TeamState team_;
  std::vector<TeamMate> mates_;
  std::size_t vehicles_ = 1;       // of its drive
  std::vector<Contact> contacts_;  // since sensors were last updated
  std::vector<HeardMessage> heard_;
  std::vector<HeldThing> held_;
  std::vector<Event> perceived_events_;
  std::vector<events::AnyEvent> raised_;  // since the last decision
  std::size_t logged_ = 0;                // number of them that the log has
  std::optional<double> mounted_cost_;    // of sensors and actuators, units per second; none: not
                                          // known
  Perception::Data perception_;
  std::optional<Controller> controller_;
  mutable Guard guard_;  // reading a plugin's numbers can fail, too

  std::shared_ptr<CommonData> common_;
  std::shared_ptr<DriveSlot> drive_;
  std::shared_ptr<LocalisationSlot> localisation_;
  std::uint64_t seed_ = 0;  // of the run
  BodyPlan driven_;
  world::DriveCheck drive_check_;  // of a world with <drive>
  mutable std::vector<TracedMember> trace_;
  Random unused_random_;               // each plugin object draws from its own
  std::vector<SensedReading> sensed_;  // in groups of one kind
  std::vector<ReadingGroup> groups_;
  std::vector<Colour> resource_colours_;
};

}  // namespace elsie::simulation
