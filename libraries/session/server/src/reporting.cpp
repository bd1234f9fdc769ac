#include <exception>
#include <utility>

#include "elsie/base/error.h"
#include "elsie/recording/run_picture.h"

#include "described.h"
#include "failing.h"
#include "scene.h"
#include "server_impl.h"

namespace elsie::server {
namespace {

constexpr std::size_t kMostWaiting = std::size_t{1} << 20;  // bytes; beyond it, news must wait

}  // namespace

void Server::Impl::show() {
  if (!simulation_) {
    return;
  }
  answer_past();
  const Clock::time_point now = Clock::now();
  place_bodies(*simulation_, bodies_);
  marks_.list(*simulation_);
  const double clock_s = seconds(now - shown_);
  const double time_s = simulation_->time_s();
  const double pace = running_ && clock_s > 0.0 ? (time_s - shown_s_) / clock_s : 0.0;
  writer_.write({epoch_, simulation_->steps(), time_s, pace, marks_.left_out()}, bodies_,
                marks_.listed());
  shown_ = now;
  shown_s_ = time_s;
  is_state_due_ = !running_;
}

void Server::Impl::watch(const Json& message, Json&) {
  watching_.choose(message);
  if (!watching_.watches("stuck")) standstills_.begin();
  is_state_due_ = watching_.is_on() && simulation_;
}

void Server::Impl::look_back(const Json& message, Json& answer) {
  if (running_) {
    throw base::BadInput("the run goes on; pause it to look back");
  }
  double time_s = simulation_->time_s();
  answer["from_s"] = past_.poses().from_s();
  answer["to_s"] = time_s;
  if (message.contains("time_s") && message["time_s"].get<double>() < time_s) {
    const History::Sample sample = past_.poses().at(message["time_s"].get<double>());
    time_s = sample.time_s;
    writer_.write({epoch_, sample.steps, time_s}, sample.bodies, {});
    past_.tell_instant(time_s, message.value("robots", std::vector<std::string>()), answer);
  } else {
    show();
  }
  answer["time_s"] = time_s;
}

void Server::Impl::paths(const Json& message, Json& answer) {
  tell_past(Past::request_of(message, false), answer);
}

void Server::Impl::numbers(const Json& message, Json& answer) {
  tell_past(Past::request_of(message, true), answer);
}

void Server::Impl::draw(const Json& message, Json& answer) {
  const auto file = message.at("file").get<std::string>();
  Json warnings = Json::array();
  picture::TopView view = recording::view_of(
      *simulation_, nullptr, [&](const std::string& sentence) { warnings.push_back(sentence); });
  past_.add_paths(view);
  picture::save_top_view(view, file, {message.value("width", 1000), 0});
  answer["warnings"] = std::move(warnings);
}

void Server::Impl::tell_past(Past::Request request, Json& answer) {
  with_next_snapshot_.emplace_back(std::move(request), answer);
  answers_with_snapshot_ = true;
  if (!running_) {
    answer_past();
  }
}

void Server::Impl::answer_past() {
  std::size_t answered = 0;
  for (; answered < with_next_snapshot_.size() && link_.waiting_bytes() < kMostWaiting;
       ++answered) {
    auto& [request, answer] = with_next_snapshot_[answered];
    Json full = answer;
    try {
      full["epoch"] = epoch_;
      past_.tell(request, full);
    } catch (const std::exception& error) {
      full = answer;
      full["refused"] = problem_json(error.what());
    }
    link_.send(full);
  }
  with_next_snapshot_.erase(with_next_snapshot_.begin(),
                            with_next_snapshot_.begin() + static_cast<std::ptrdiff_t>(answered));
}

void Server::Impl::report_pause() {
  link_.send({{"event", "paused"},
              {"time_s", simulation_->time_s()},
              {"steps", simulation_->steps()},
              {"state_hash", simulation::hash_text(simulation_->state_hash())}});
}

void Server::Impl::report_state() {
  is_state_due_ = false;
  if (watching_.is_on()) {
    stated_ = Clock::now();
    link_.send(watching_.state(*simulation_, epoch_));
  }
}

void Server::Impl::report_news() {
  if (!simulation_ || next_) {
    return;
  }
  const auto events = simulation_->events();
  for (; told_events_ < events.size() && link_.waiting_bytes() < kMostWaiting; ++told_events_) {
    const simulation::EventRecord& event = events[told_events_];
    link_.send({{"event", "raised"},
                {"time_s", event.time_s},
                {"robot", event.robot},
                {"name", event.name()},
                {"detail", event.detail()}});
  }
  for (const simulation::Note& note : past_.take_notes()) {
    report_note(note);
  }
  for (const simulation::Note& note : marks_.take_notes()) {
    report_note(note);
  }
  const auto notes = simulation_->notes();
  for (; told_notes_ < notes.size() && link_.waiting_bytes() < kMostWaiting; ++told_notes_) {
    report_note(notes[told_notes_]);
  }
}

void Server::Impl::report_stuck() {
  if (!watching_.watches("stuck")) {
    return;
  }
  standstills_.look(*simulation_);
  if (standstills_.found() != told_standstills_ && link_.waiting_bytes() < kMostWaiting) {
    told_standstills_ = standstills_.found();
    Json event = {{"event", "stuck"}, {"epoch", epoch_}, {"time_s", simulation_->time_s()}};
    event.update(standstills_json(*simulation_, told_standstills_));
    link_.send(event);
  }
}

void Server::Impl::report_note(const simulation::Note& note) {
  link_.send(
      {{"event", "note"}, {"robot", note.robot}, {"plugin", note.plugin}, {"text", text_of(note)}});
}

}  // namespace elsie::server
