#include "client.h"

#include <stdexcept>
#include <utility>

namespace remote {
namespace {

std::string line_of(const Json& object) {
  return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

void Client::require_program() const {
  const bool starts = !command.empty() || !file.path.empty();
  if (!starts && socket.empty()) {
    throw std::invalid_argument(
        "it names no program; give it a 'command', such as \"python3\", a 'file', such as "
        "\"drive.py\", or both, or the 'socket' of one that runs already");
  }
  if (starts && !socket.empty()) {
    throw std::invalid_argument("it has both a '" +
                                std::string(command.empty() ? "file" : "command") +
                                "' and a 'socket'; expected a program that is started, or one "
                                "that runs already");
  }
}

void Client::begin_run(elsie::Random& random) {
  seed_ = static_cast<std::int64_t>(random.bits() >> 33);  // any language has such integers
  run_is_told_ = false;
}

void Client::ask(const std::function<Json()>& facts, const Json& now,
                 const std::function<void(Answer&)>& read) {
  try {
    if (!connection_) {
      connection_.emplace(Program{command, file.path, socket}, timeout);
      facts_are_told_ = run_is_told_ = false;
      facts_.clear();
    }
    if (!facts_are_told_) {
      if (std::string text = line_of({{"hello", facts()}}); text != facts_) {
        exchange(text, [](Answer& answer) {
          const auto protocol = answer.number("protocol");
          if (protocol && *protocol != kProtocol) {
            throw Unexpected("it speaks another protocol; expected " + std::to_string(kProtocol));
          }
        });
        facts_ = std::move(text);
      }
      facts_are_told_ = true;
    }
    if (!run_is_told_) {
      exchange(line_of({{"reset", seed_}}), [](Answer&) {});
      run_is_told_ = true;
    }
    exchange(line_of(now), read);
  } catch (...) {
    connection_.reset();
    throw;
  }
}

void Client::exchange(const std::string& line, const std::function<void(Answer&)>& read) {
  const std::string said = connection_->ask(line);
  const Json object = Json::parse(said, nullptr, false);
  if (!object.is_object()) {
    connection_->refuse(said, "expected a JSON object in one line, with finite numbers");
  }
  try {
    Answer answer(object);
    read(answer);
    answer.finish();
  } catch (const Unexpected& problem) {
    connection_->refuse(said, problem.what());
  }
}

}  // namespace remote
