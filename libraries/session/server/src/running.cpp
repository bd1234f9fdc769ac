#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "elsie/base/error.h"
#include "elsie/render/world_cameras.h"
#include "elsie/simulation/fault.h"
#include "elsie/world/error.h"

#include "failing.h"
#include "scene.h"
#include "server_impl.h"

namespace elsie::server {
namespace {

constexpr std::chrono::microseconds kBetweenMessages{2'000};
constexpr std::chrono::microseconds kBetweenSnapshots{16'000};
constexpr std::chrono::microseconds kBetweenStates{33'000};
constexpr std::chrono::microseconds kLongestNap{5'000};

/// Thrown to end a run early.
struct Left {};

}  // namespace

std::unique_ptr<Simulation> Server::Impl::simulation_of(const world::World& world,
                                                        std::uint64_t seed,
                                                        const plugin::Host& host) const {
  return std::make_unique<Simulation>(
      world, host,
      simulation::Options{.seed = seed,
                          .data_directories = options_.data_directories,
                          .cameras = render::world_cameras});
}

void Server::Impl::restart(std::uint64_t seed) {
  std::optional<editing::Document> other;  // with the layouts that this seed draws, now or later
  if (seed != seed_) {
    other.emplace(document_->text(), document_->file(), host(), reading(seed));
  }
  auto simulation = simulation_of((other ? other : document_)->world(), seed, host());
  if (other) {
    document_ = std::move(other);
  }
  seed_ = seed;
  begin(std::move(simulation));
}

void Server::Impl::begin(std::unique_ptr<Simulation> simulation) {
  left_ = phase_ == Phase::under_way;
  phase_ = Phase::ready;
  running_ = false;
  pause_at_.reset();
  is_pause_told_ = false;
  answer_later();
  ++epoch_;
  next_ = std::move(simulation);
  if (!left_) {
    take_next();
  }
}

void Server::Impl::take_next() {
  simulation_ = std::move(next_);
  run_file_ = document_->file();
  recording_.close();
  repetition_.begin(document_->file(), document_->text(), seed_);
  told_events_ = told_notes_ = 0;
  standstills_.begin();
  told_standstills_.clear();
  past_.begin(*simulation_);
  marks_.forget_failures();
  show();
}

void Server::Impl::start(const Json& message, Json&) {
  const bool is_paced = message.value("paced", false);
  std::optional<std::uint64_t> pause_at;
  if (const auto until_s = message.find("until_s"); until_s != message.end()) {
    const double steps =
        std::ceil(until_s->get<double>() / simulation_->world().physics.step - 1e-6);
    pause_at = static_cast<std::uint64_t>(std::clamp(steps, 0.0, 1e15));
  }
  require_unended();
  if (pause_at && *pause_at <= simulation_->steps()) {  // it is there already
    hold();
    is_pause_due_ = true;
    return;
  }
  get_ready();
  start_clock();
  hold();
  pause_at_ = pause_at;
  is_pause_told_ = pause_at.has_value();
  is_pause_paced_ = is_paced;
  running_ = true;
}

void Server::Impl::require_unended() const {
  if (phase_ == Phase::ended) {
    throw base::BadInput("the run has ended; reset it to start it again");
  }
}

void Server::Impl::get_ready() {
  require_unended();
  if (phase_ == Phase::ready && recording_.is_due()) {
    recording_.start(inputs());
  }
}

void Server::Impl::pause(const Json&, Json&) { hold(); }

void Server::Impl::step(const Json&, Json&) {
  get_ready();
  // Steps that have not been carried out yet add up.
  const auto period = static_cast<std::uint64_t>(simulation_->world().physics.control_steps);
  pause_at_ = pause_at_ ? *pause_at_ + period : simulation_->steps() + 1;
  is_pause_paced_ = false;
  running_ = answers_later_ = true;
}

void Server::Impl::set_speed(const Json& message, Json&) {
  const double factor = message.value("factor", 0.0);
  if (factor < 0.0) {
    throw base::BadInput(
        "a run cannot go backwards; expected a `factor` above 0, or 0: as fast as "
        "possible");
  }
  speed_ = factor;
  start_clock();
}

void Server::Impl::reset(const Json& message, Json& answer) {
  restart(whole_number(message, "seed", seed_));
  describe(answer);
}

void Server::Impl::record(const Json& message, Json& answer) {
  if (phase_ == Phase::under_way) {
    throw base::BadInput("the run is under way, and a recording begins with it; reset it first");
  }
  recording_.choose(message, inputs());
  answer["rate"] = recording::rate_in(recording_.rate_hz(), simulation_->world().physics.step);
}

std::vector<std::filesystem::path> Server::Impl::inputs() const {
  std::map<std::string, std::string> found;
  world::ReadOptions options = reading(seed_);
  options.check_plugins = false;
  options.found = &found;
  try {
    world::parse_world(document_->text(), document_->file(), host(), options);
  } catch (const world::WorldError&) {  // a file has changed since; it counts nevertheless
  }
  std::vector<std::filesystem::path> files;
  if (!document_->file().empty()) {
    files.emplace_back(document_->file());
  }
  for (const auto& [name, file] : found) {
    files.emplace_back(file);
  }
  return files;
}

void Server::Impl::command(const Json&, Json& answer) {
  answer.update(repetition_.command(options_.plugin_options));
}

void Server::Impl::run() {
  phase_ = Phase::under_way;
  Json end = {{"event", "ended"}};
  std::vector<simulation::Observer*> observers = recording_.observers();
  observers.push_back(&past_);
  try {
    const simulation::RunResult result =
        simulation_->run(observers, {}, [this](Simulation&) { between_decisions(); });
    end["outcome"] = to_string(result.outcome);
    end["reason"] = result.reason;
    end["seed"] = result.seed;
    end["time_s"] = result.simulated_s;
    end["steps"] = result.steps;
    end["state_hash"] = simulation::hash_text(result.state_hash);
    end["measures"] = measures_json(result.measures);
    if (watching_.watches("stuck") && result.outcome != simulation::Outcome::success) {
      end["open_goals"] = open_goals_json(*simulation_);
      if (result.outcome == simulation::Outcome::failure) {
        end["broken_by"] = broken_by_json(*simulation_);
      }
      end.update(standstills_json(*simulation_, standstills_.found()));
    }
    end["notes"] = Json::array();
    for (const simulation::Note& note : result.notes) {
      end["notes"].push_back(text_of(note));
    }
  } catch (const Left&) {
    left_ = false;
    if (next_) {
      take_next();
      answer_later();
      report_news();
      report_state();
    }
    return;
  } catch (const simulation::PluginFault&) {
    throw;
  } catch (const std::exception& error) {
    end["outcome"] = "stopped";
    end["reason"] = error.what();
  }
  phase_ = Phase::ended;
  recording_.close();
  past_.keep(*simulation_);
  hold();
  report_news();
  report_state();
  link_.send(end);
}

void Server::Impl::between_decisions() {
  if (pause_at_ && simulation_->steps() >= *pause_at_) {
    const bool is_told = is_pause_told_;
    hold();
    report_news();
    report_state();
    if (is_told) {
      report_pause();
    }
  }
  report_state_if_due();
  const Clock::time_point now = Clock::now();
  if (now - shown_ >= kBetweenSnapshots && (writer_.taken() || !with_next_snapshot_.empty())) {
    show();
  }
  report_stuck();
  if (now - heard_ >= kBetweenMessages) {
    hear();
  }
  while (running_ && speed_ > 0.0 && (!pause_at_ || is_pause_paced_) && !link_.closed()) {
    const double early =
        (simulation_->time_s() - paced_from_s_) / speed_ - seconds(Clock::now() - paced_from_);
    if (early <= 0.0) {
      break;
    }
    link_.wait(std::min(kLongestNap, std::chrono::microseconds(std::llround(early * 1e6))));
    hear();
    report_state_if_due();
    answer_past();
  }
  while (!running_) {
    link_.wait(kLongestWait);
    hear();
  }
}

// Before the answers about the past, for which the window asks as soon as it has read all others:
// it is hardly ever without an unread one.
void Server::Impl::report_state_if_due() {
  if (watching_.is_on() && Clock::now() - stated_ >= kBetweenStates && link_.is_idle()) {
    report_state();
  }
}

void Server::Impl::hold() {
  running_ = false;
  pause_at_.reset();
  is_pause_told_ = false;
  show();
  answer_later();
}

void Server::Impl::answer_later() {
  for (const Json& answer : std::exchange(later_, {})) {
    link_.send(answer);
  }
}

void Server::Impl::hear() {
  heard_ = Clock::now();
  report_news();
  renew_plugins();
  while (const auto message = link_.next()) {
    handle(*message);
    if (left_) {
      throw Left{};
    }
  }
  if (!running_) {
    answer_past();
  }
  if (link_.closed()) {
    throw Left{};
  }
}

void Server::Impl::start_clock() {
  paced_from_ = Clock::now();
  paced_from_s_ = simulation_ ? simulation_->time_s() : 0.0;
}

}  // namespace elsie::server
