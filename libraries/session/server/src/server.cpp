#include "elsie/server/server.h"

#include <exception>
#include <utility>

#include "elsie/base/problems.h"
#include "elsie/simulation/fault.h"

#include "described.h"
#include "hangup.h"
#include "server_impl.h"

namespace elsie::server {

void Server::Impl::serve() {
  while (!link_.closed()) {
    link_.wait(kLongestWait);
    answer_past();
    report_news();
    renew_plugins();
    while (const auto message = link_.next()) {
      handle(*message);
    }
    while (running_ && !link_.closed()) {
      run();
    }
  }
}

const std::map<std::string, Server::Impl::KnownOrder>& Server::Impl::orders() {
  static const std::map<std::string, KnownOrder> known{
      {"open", {&Impl::open, false}},   {"catalog", {&Impl::catalog, false}},
      {"watch", {&Impl::watch, false}}, {"pause", {&Impl::pause, false}},
      {"edit", {&Impl::edit}},          {"become", {&Impl::become}},
      {"text_for", {&Impl::text_for}},  {"move", {&Impl::move}},
      {"ping", {&Impl::ping, false}},   {"run", {&Impl::start}},
      {"step", {&Impl::step}},          {"speed", {&Impl::set_speed}},
      {"reset", {&Impl::reset}},        {"at", {&Impl::look_back}},
      {"record", {&Impl::record}},      {"command", {&Impl::command}},
      {"paths", {&Impl::paths}},        {"numbers", {&Impl::numbers}},
      {"picture", {&Impl::draw}},       {"plugin", {&Impl::add_plugin, false}},
  };
  return known;
}

void Server::Impl::handle(const Json& message) {
  if (!message.is_object()) {
    refuse_line();
    return;
  }
  Json answer = {{"answer", message.value("id", Json())}};
  answers_later_ = answers_with_snapshot_ = false;
  try {
    const auto name = message.value("do", std::string());
    const auto order = orders().find(name);
    if (order == orders().end()) {
      throw base::BadInput("there is no order '" + name + "'");
    }
    if (order->second.needs_world && !document_) {
      throw base::BadInput("no world is open; open one first");
    }
    (this->*order->second.perform)(message, answer);
  } catch (const base::FileError& error) {
    answer["refused"] = problems_json(error.problems());
  } catch (const simulation::PluginFault&) {
    throw;
  } catch (const Json::exception& error) {
    answer["refused"] = problem_json(
        std::string("the order lacks a member, or one has a wrong type: ") + error.what());
  } catch (const std::exception& error) {
    answer["refused"] = problem_json(error.what());
  }
  if (answers_with_snapshot_) {
    return;
  }
  if (answers_later_ || left_) {
    later_.push_back(std::move(answer));
    return;
  }
  link_.send(answer);
  report_news();
  if (is_state_due_ && !next_) {
    report_state();
  }
  if (std::exchange(is_pause_due_, false)) {
    report_pause();
  }
}

void Server::Impl::refuse_line() {
  link_.send({{"answer", nullptr},
              {"refused", problem_json("a line is no order; expected a JSON object with `id` and "
                                       "`do`, in UTF-8, on one line")}});
}

Server::Server(build::Watch& plugins, ServerOptions options)
    : impl_(std::make_unique<Impl>(plugins, std::move(options))) {}
Server::~Server() = default;

void Server::serve() {
  const Hangup hangup(kMessages);
  impl_->serve();
}

}  // namespace elsie::server
