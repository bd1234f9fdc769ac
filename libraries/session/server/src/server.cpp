#include "elsie/server/server.h"

#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "elsie/base/problems.h"
#include "elsie/render/world_cameras.h"
#include "elsie/simulation/fault.h"
#include "elsie/simulation/simulation.h"
#include "elsie/snapshots/snapshots.h"
#include "elsie/world/document.h"
#include "elsie/world/error.h"

#include "link.h"
#include "scene.h"

namespace elsie::server {
namespace {

using Clock = std::chrono::steady_clock;
using simulation::Simulation;

constexpr std::chrono::microseconds kBetweenMessages{2'000};
constexpr std::chrono::microseconds kBetweenSnapshots{16'000};
constexpr std::chrono::microseconds kLongestNap{5'000};

/// Ends a run that is not to go on.
struct Left {};

double seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

Json json(std::span<const base::Problem> problems) {
  Json all = Json::array();
  for (const base::Problem& each : problems) {
    all.push_back({{"file", each.file}, {"line", each.line}, {"message", each.message}});
  }
  return all;
}

/// What an element of the world holds; `inherited`: it stands in the template of a robot.
Json json(const world::Element& element, const world::Document& document) {
  Json attributes = Json::object(), children = Json::array();
  for (const world::Attribute& each : element.attributes) {
    attributes[each.name] = each.value;
  }
  for (const world::Element& child : element.children) {
    children.push_back(json(child, document));
  }
  Json all = {{"name", element.name}, {"line", element.where.line}};
  all["attributes"] = std::move(attributes);
  if (!element.text.empty()) all["text"] = element.text;
  if (!document.holds(element)) all["inherited"] = true;
  if (!children.empty()) all["children"] = std::move(children);
  return all;
}

std::vector<simulation::Change> changes_of(const std::vector<std::string>& edits) {
  std::vector<simulation::Change> changes;
  for (const std::string& edit : edits) {
    const std::size_t equals = edit.find('=');
    changes.push_back({edit.substr(0, equals),
                       equals == std::string::npos ? std::string() : edit.substr(equals + 1)});
  }
  return changes;
}

}  // namespace

class Server::Impl {
 public:
  Impl(const plugin::Host& host, std::vector<std::string> data_directories)
      : host_(host),
        data_directories_(std::move(data_directories)),
        memory_(snapshots::SharedMemory::open(kMemory)),
        writer_(memory_),
        link_(kMessages) {}

  void serve() {
    while (!link_.closed()) {
      link_.wait();
      while (const auto message = link_.next()) {
        handle(*message);
      }
      while (running_ && !link_.closed()) {
        run();
      }
    }
  }

 private:
  enum class Phase { ready, under_way, ended };

  /// Its answer has the message's id, and either what was asked for or `refused`: sentences.
  void handle(const Json& message) {
    const Json id = message.value("id", Json());
    Json answer = {{"answer", id}};
    try {
      if (perform(message, answer)) {
        later_ = answer;
        return;
      }
    } catch (const base::FileError& error) {
      answer["refused"] = json(error.problems());
    } catch (const simulation::PluginFault&) {
      throw;
    } catch (const std::exception& error) {
      answer["refused"] = json(std::vector<base::Problem>{{"", 0, error.what()}});
    }
    link_.send(answer);
  }

  /// Whether the answer comes later: at the next pause.
  bool perform(const Json& message, Json& answer) {
    const auto order = message.value("do", std::string());
    if (order == "open") {
      open(message, answer);
    } else if (order == "pause") {
      running_ = false;
      show();
    } else if (!document_) {
      throw base::BadInput("no world is open; open one first");
    } else if (order == "edit") {
      edit(world::Edits(message.at("edits").get<std::vector<std::string>>()), answer);
    } else if (order == "undo") {
      const auto kept = inverses_.find(message.at("edit").get<std::uint64_t>());
      if (kept == inverses_.end()) {
        throw base::BadInput("there is no such edit");
      }
      edit(kept->second, answer);
    } else if (order == "run") {
      start_clock();
      running_ = phase_ != Phase::ended;
      pause_at_.reset();
    } else if (order == "step") {
      running_ = phase_ != Phase::ended;
      pause_at_ = simulation_->steps() + 1;
      return running_;
    } else if (order == "speed") {
      speed_ = message.value("factor", 0.0);
      start_clock();
    } else if (order == "reset") {
      seed_ = message.value("seed", seed_);
      running_ = false;
      make_simulation();
      describe(answer);
    } else {
      throw base::BadInput("there is no order '" + order + "'");
    }
    return false;
  }

  void open(const Json& message, Json& answer) {
    world::ReadOptions options;
    options.data_directories = data_directories_;
    options.check_plugins = true;
    world::Document document(message.at("text").get<std::string>(),
                             message.value("file", std::string()), host_, options);
    seed_ = message.value("seed", seed_);
    document_ = std::move(document);
    inverses_.clear();
    running_ = false;
    make_simulation();
    describe(answer);
  }

  /// In a run that is under way, the run becomes what the document is now.
  void edit(const world::Edits& edits, Json& answer) {
    world::Edits inverse = document_->apply(edits);
    try {
      if (phase_ == Phase::under_way) {
        simulation_->change(changes_of(edits.texts()));
        ++epoch_;
      } else {
        make_simulation();
      }
    } catch (...) {
      document_->apply(inverse);
      throw;
    }
    answer["undo"] = ++last_inverse_;
    inverses_.emplace(last_inverse_, std::move(inverse));
    describe(answer);
  }

  /// A run from the beginning.
  void make_simulation() {
    const bool leave = phase_ == Phase::under_way;
    next_ = std::make_unique<Simulation>(document_->world(), host_,
                                         simulation::Options{.seed = seed_,
                                                             .data_directories = data_directories_,
                                                             .cameras = render::world_cameras});
    phase_ = Phase::ready;
    ++epoch_;
    if (!leave) {
      take_next();
    }
    left_ = leave;
  }

  void take_next() {
    simulation_ = std::move(next_);
    show();
  }

  void describe(Json& answer) {
    answer["epoch"] = epoch_;
    answer["text"] = document_->text();
    answer["tree"] = json(document_->tree(), *document_);
    answer["scene"] = scene_json(next_ ? next_->world() : simulation_->world());
  }

  void run() {
    phase_ = Phase::under_way;
    Json end = {{"event", "ended"}};
    try {
      const simulation::RunResult result =
          simulation_->run({}, {}, [this](Simulation&) { between_decisions(); });
      end["outcome"] = to_string(result.outcome);
      end["reason"] = result.reason;
      end["seed"] = result.seed;
      end["time_s"] = result.simulated_s;
      end["steps"] = result.steps;
      end["state_hash"] = simulation::hash_text(result.state_hash);
    } catch (const Left&) {
      left_ = false;
      take_next();
      answer_later();
      return;
    } catch (const simulation::PluginFault&) {
      throw;
    } catch (const std::exception& error) {
      end["outcome"] = "stopped";
      end["reason"] = error.what();
    }
    phase_ = Phase::ended;
    running_ = false;
    show();
    answer_later();
    link_.send(end);
  }

  /// Messages are heard here; while the run is paused, it stays here.
  void between_decisions() {
    if (pause_at_ && simulation_->steps() >= *pause_at_) {
      pause_at_.reset();
      running_ = false;
      show();
      answer_later();
    }
    const Clock::time_point now = Clock::now();
    if (now - shown_ >= kBetweenSnapshots && writer_.taken()) {
      show();
    }
    if (now - heard_ >= kBetweenMessages) {
      hear();
    }
    while (running_ && speed_ > 0.0 && !link_.closed()) {
      const double early =
          (simulation_->time_s() - paced_from_s_) / speed_ - seconds(Clock::now() - paced_from_);
      if (early <= 0.0) {
        break;
      }
      link_.wait(std::min(kLongestNap, std::chrono::microseconds(std::llround(early * 1e6))));
      hear();
    }
    while (!running_) {
      if (link_.closed()) {
        throw Left{};
      }
      link_.wait();
      hear();
    }
  }

  void answer_later() {
    if (later_) {
      link_.send(*later_);
      later_.reset();
    }
  }

  void hear() {
    heard_ = Clock::now();
    while (const auto message = link_.next()) {
      handle(*message);
      if (left_) {
        throw Left{};
      }
    }
    if (link_.closed()) {
      throw Left{};
    }
  }

  void start_clock() {
    paced_from_ = Clock::now();
    paced_from_s_ = simulation_ ? simulation_->time_s() : 0.0;
  }

  void show() {
    if (!simulation_) {
      return;
    }
    const Clock::time_point now = Clock::now();
    place_bodies(*simulation_, bodies_);
    list_beams(*simulation_, beams_);
    const double clock_s = seconds(now - shown_);
    const double time_s = simulation_->time_s();
    const double pace = running_ && clock_s > 0.0 ? (time_s - shown_s_) / clock_s : 0.0;
    writer_.write({epoch_, simulation_->steps(), time_s, pace}, bodies_, beams_);
    shown_ = now;
    shown_s_ = time_s;
  }

  const plugin::Host& host_;
  std::vector<std::string> data_directories_;
  snapshots::SharedMemory memory_;
  snapshots::Writer writer_;
  Link link_;

  std::optional<world::Document> document_;
  std::map<std::uint64_t, world::Edits> inverses_;
  std::uint64_t last_inverse_ = 0;

  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<Simulation>
      next_;  // takes its place once the run that is under way has been left
  Phase phase_ = Phase::ready;
  bool left_ = false;
  bool running_ = false;
  std::optional<std::uint64_t> pause_at_;  // steps
  std::optional<Json> later_;              // the answer to an order to step
  std::uint64_t seed_ = 1;
  std::uint64_t epoch_ = 0;

  double speed_ = 0.0;  // 0: as fast as it goes
  Clock::time_point paced_from_;
  double paced_from_s_ = 0.0;
  Clock::time_point heard_, shown_;
  double shown_s_ = 0.0;
  std::vector<snapshots::BodyState> bodies_;
  std::vector<snapshots::BeamState> beams_;
};

Server::Server(const plugin::Host& host, std::vector<std::string> data_directories)
    : impl_(std::make_unique<Impl>(host, std::move(data_directories))) {}
Server::~Server() = default;

void Server::serve() { impl_->serve(); }

}  // namespace elsie::server
