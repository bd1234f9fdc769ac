// What a decision costs under each coordinator, for each behaviour that it asks, against
// arbiter_subsumption: with the set-ups of experiments/every_coordinator.xml, two beams, a camera,
// and behaviours that answer at once. Processor time on one core, in turn. Prints Markdown.
//
//   coordinators [--repeats N]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "elsie/api/coordinator.h"
#include "elsie/api/reading.h"
#include "elsie/experiment/experiment.h"
#include "elsie/experiment/reader.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/parameters.h"
#include "elsie/plugin/search_path.h"

#include "statistics.h"

namespace {

using namespace elsie;

constexpr int kDecisions = 20000;
constexpr int kFirst = 2000;  // decisions that are not measured
constexpr const char* kReference = "arbiter_subsumption";

/// What a robot with two beams and a camera perceives; the time goes on.
class Senses {
 public:
  Senses() {
    for (const auto& [azimuth_deg, distance_m] : {std::pair(15.0, 0.45), std::pair(-15.0, 0.7)}) {
      beams_.push_back({distance_m, 1.0, true});
      mountings_.push_back({{}, radians(azimuth_deg), 0.0});
    }
    mountings_.emplace_back();
    view_.found = true;
    view_.column = 60.0;
    view_.area_px = 100.0;
    view_.horizontal_fov_rad = radians(30.0);
    sensed_ = {{&beams_[0], &mountings_[0], "left"},
               {&beams_[1], &mountings_[1], "right"},
               {&view_, &mountings_[2], "eye"}};
    groups_ = {{ReadingKind::of<RangeReading>(), std::span(sensed_).first(2)},
               {ReadingKind::of<VisionReading>(), std::span(sensed_).last(1)}};
    data_.period_s = 0.1;
    data_.groups = groups_;
    data_.self = &self_;
    data_.team = &team_;
  }

  Perception now() { return {data_, random}; }
  Perception next() {
    data_.time_s += data_.period_s;
    return now();
  }

  Random random{1};

 private:
  std::vector<RangeReading> beams_;
  VisionReading view_;
  std::vector<Mounting> mountings_;
  std::vector<SensedReading> sensed_;
  std::vector<ReadingGroup> groups_;
  OwnState self_;
  TeamState team_;
  Perception::Data data_;
};

/// A behaviour whose answer is ready.
struct Ready final : Behavior {
  Response respond(const Perception&) override { return answer; }
  Response answer;
};

/// A coordinator with such behaviours.
class Robot final : private Member::Runner {
 public:
  Robot(const plugin::Host& host, const world::Robot& described)
      : behaviors_(described.behaviors.size()),
        coordinator_(
            host.create<Coordinator>(PluginKind::coordinator, described.coordinator->plugin)) {
    Member::Runner& runner = *this;
    double side = 1.0;
    for (std::size_t i = 0; i < behaviors_.size(); ++i) {
      const world::BehaviorUse& use = described.behaviors[i];
      behaviors_[i].answer = Response(WheelPair().motion({10.0 + side, 10.0 - side}));
      behaviors_[i].answer.activation = 0.6 - 0.1 * side;
      side = -side;
      names_.push_back(use.id);
    }
    for (std::size_t i = 0; i < behaviors_.size(); ++i) {
      members_.emplace_back(names_[i], described.behaviors[i].priority, runner);
    }
    const world::PluginUse& use = *described.coordinator;
    plugin::apply_parameters(*host.find(PluginKind::coordinator, use.plugin), *coordinator_,
                             use.parameters, world::values_of(use.elements));
    coordinator_->equipped(members_, now_.next());
    coordinator_->reset(now_.random);
  }

  struct Cost {
    double decision_ns = 0.0;  // processor time
    double asked = 0.0;        // behaviours
    double each_ns() const { return decision_ns / std::max(asked, 1.0 / kDecisions); }
  };

  Cost cost() {
    decide(kFirst);
    const std::clock_t start = std::clock();
    const long asked = decide(kDecisions);
    const auto ticks = static_cast<double>(std::clock() - start);
    return {1e9 * ticks / CLOCKS_PER_SEC / kDecisions, static_cast<double>(asked) / kDecisions};
  }

 private:
  /// Returns how often behaviours were asked.
  long decide(int times) {
    long asked = 0;
    for (int i = 0; i < times; ++i) {
      for (Member& member : members_) member.begin_step();
      coordinator_->coordinate(members_, now_.next());
      for (const Member& member : members_) asked += member.trace.asked ? 1 : 0;
    }
    return asked;
  }

  Ready& behind(const Member& member) {
    return behaviors_[static_cast<std::size_t>(&member - members_.data())];
  }
  const Response& run(Member& member) override { return behind(member).answer; }
  void rate(Member& member, std::span<const Motion> candidates,
            std::span<double> desirability) override {
    const Ready& ready = behind(member);
    ready.rate(now_.now(), ready.answer, candidates, desirability);
  }
  CommandSets command_sets(Member& member) override {
    const Ready& ready = behind(member);
    return ready.command_sets(now_.now(), ready.answer);
  }
  std::span<const PublishedNumber> published(const Member&) const override { return {}; }
  double published(const Member&, std::size_t) const override { return 0.0; }

  Senses now_;
  std::vector<Ready> behaviors_;
  std::vector<std::string> names_;
  std::vector<Member> members_;
  plugin::Object<Coordinator> coordinator_;
};

/// Those that evaluate a network, a fuzzy model or conditions, whatever they ask.
bool infers(const std::string& name) {
  return name.ends_with("neural_network") || name.ends_with("tree") || name.ends_with("states") ||
         name.ends_with("context_blending") || name.ends_with("spreading_activation") ||
         name.ends_with("learning");
}

/// The robots of the experiment's first world by their coordinators' names, at the first level of
/// all other factors.
std::vector<std::pair<std::string, world::Robot>> set_ups(const plugin::Host& host) {
  const std::string file = ELSIE_SOURCE_DIR "/experiments/every_coordinator.xml";
  experiment::ReadOptions options;
  options.data_directories = {ELSIE_SOURCE_DIR};
  const experiment::Experiment study = experiment::read_experiment(file, host, options);
  std::vector<std::pair<std::string, world::Robot>> found;
  for (const experiment::Cell& cell : experiment::cells(study)) {
    const auto others = std::count_if(cell.levels.begin() + 1, cell.levels.end(),
                                      [](std::size_t level) { return level != 0; });
    if (cell.world != 0 || others != 0) continue;
    const world::Robot robot = experiment::read_cell(study, cell, host, options).robots.at(0);
    found.emplace_back(robot.coordinator.value().plugin, robot);
  }
  return found;
}

void table(const char* head, const plugin::Host& host,
           const std::vector<std::pair<std::string, world::Robot>>& all, Robot& reference,
           int repeats) {
  std::printf(
      "%s\n\n| coordinator | ns a decision | behaviours asked | ns for each | of `%s`'s | spread "
      "|\n"
      "|---|---|---|---|---|---|\n",
      head, kReference);
  for (const auto& [name, described] : all) {
    Robot robot(host, described);
    std::vector<double> decisions, times, ratios;
    double asked = 0.0;
    for (int i = 0; i < repeats; ++i) {  // in turn, because machines drift
      const double of_reference = reference.cost().each_ns();
      const Robot::Cost cost = robot.cost();
      asked = cost.asked;
      decisions.push_back(cost.decision_ns);
      times.push_back(cost.each_ns());
      ratios.push_back(times.back() / of_reference);
    }
    const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
    std::printf("| `%s` | %.0f | %.3g | %.0f | %.2f | %.2f to %.2f |\n", name.c_str(),
                bench::median(decisions), asked, bench::median(times), bench::median(ratios),
                *least, *most);
    std::fflush(stdout);
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) try {
  int repeats = 15;
  if (argc == 3 && std::string(argv[1]) == "--repeats") {
    repeats = std::atoi(argv[2]);
  } else if (argc != 1) {
    repeats = 0;
  }
  if (repeats < 1) {
    std::fprintf(stderr, "usage: coordinators [--repeats N]\n");
    return EXIT_FAILURE;
  }
  std::vector<std::pair<std::string, world::Robot>> plain, inferring;
  const world::Robot* described = nullptr;
  const plugin::Host host(plugin::default_search_path());
  const auto all = set_ups(host);
  for (const auto& one : all) {
    (infers(one.first) ? inferring : plain).push_back(one);
    if (one.first == kReference) described = &one.second;
  }
  if (!described) throw std::runtime_error(std::string("no level has ") + kReference);
  Robot reference(host, *described);
  table("From the behaviours' answers alone:", host, plain, reference, repeats);
  table("With conditions, models or networks of their own:", host, inferring, reference, repeats);
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::fprintf(stderr, "coordinators: %s\n", error.what());
  return EXIT_FAILURE;
}
