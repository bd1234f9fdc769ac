// Sessions with the program itself, for tests.
#pragma once

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <poll.h>

#include "elsie/client/connection.h"

#include "places.h"
#include "program.h"

namespace elsie::test {

using client::Connection;
using client::Json;

inline std::string text_of(const std::string& file) {
  std::ifstream stream(source_path(file));
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

inline constexpr const char* kRoom = R"(<world format="1">
  <!-- a room -->
  <arena length="4" width="4"/>
  <robots>
    <robot id="r1" x="-1">
      <behaviors><turn_left/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
  </robots>
  <limits time="2"/>
</world>
)";

inline constexpr const char* kSecond =
    "robot[+]=<robot id=\"r2\" x=\"1\"><behaviors><turn_right/></behaviors>"
    "<coordinator><arbiter_suppression/></coordinator></robot>";

/// Whether it comes true within two minutes.
inline bool comes_true(const std::function<bool()>& is_true) {
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(120);
  while (!is_true()) {
    if (std::chrono::steady_clock::now() > patience) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

class Session {
 public:
  explicit Session(const std::vector<std::string>& arguments = {})
      : connection_(build_path("bin/elsie"), arguments) {}

  Connection& connection() { return connection_; }

  /// Sends an order and waits for its answer; what comes meanwhile is kept for event().
  Json ask(Json order) {
    order["id"] = ++last_id_;
    connection_.send(order);
    return answer(last_id_);
  }
  Json answer(int id) {
    return wait([&](const Json& message) {
      const auto of = message.find("answer");
      return of != message.end() && *of == id;
    });
  }
  /// To a line that has no id.
  Json answer_to_no_order() {
    return wait([](const Json& message) {
      const auto id = message.find("answer");
      return id != message.end() && id->is_null();
    });
  }
  Json open(const std::string& text, const std::string& file = "") {
    return ask({{"do", "open"}, {"text", text}, {"file", file}});
  }
  void step(int count = 1) {
    for (int i = 0; i < count; ++i) ask({{"do", "step"}});
  }
  Json edit(const std::vector<std::string>& edits) {
    return ask({{"do", "edit"}, {"edits", edits}});
  }
  /// Waits for the next event of this kind that nobody has asked for yet.
  Json event(const std::string& kind) { return event_of({kind}); }
  Json event_of(const std::vector<std::string>& kinds) {
    return wait([&](const Json& message) {
      return std::find(kinds.begin(), kinds.end(), message.value("event", "")) != kinds.end();
    });
  }
  /// Whether one has come by now.
  bool has_event(const std::string& kind) {
    receive();
    return std::any_of(kept_.begin(), kept_.end(),
                       [&](const Json& message) { return message.value("event", "") == kind; });
  }
  Json end_of_run() { return event("ended"); }
  /// The last event of this kind; earlier ones are forgotten.
  Json latest(const std::string& kind) {
    Json last = event(kind);
    for (auto it = kept_.begin(); it != kept_.end();) {
      if (it->value("event", "") == kind) {
        last = *it;
        it = kept_.erase(it);
      } else {
        ++it;
      }
    }
    return last;
  }
  client::SessionEnd end() {
    wait([](const Json&) { return false; });
    REQUIRE(end_);
    return *end_;
  }

 private:
  void receive() {
    for (Json& message : connection_.receive()) {
      kept_.push_back(std::move(message));
    }
  }
  Json wait(const std::function<bool(const Json&)>& is_it) {
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(120);
    while (std::chrono::steady_clock::now() < patience) {
      receive();
      for (auto it = kept_.begin(); it != kept_.end(); ++it) {
        if (is_it(*it)) {
          const Json found = *it;
          kept_.erase(it);
          return found;
        }
      }
      if (const auto end = connection_.ended()) {
        end_ = *end;
        return {};
      }
      pollfd waiting{connection_.descriptor(), POLLIN, 0};
      poll(&waiting, 1, 100);
    }
    FAIL("no answer within two minutes");
    return {};
  }

  Connection connection_;
  std::vector<Json> kept_;
  std::optional<client::SessionEnd> end_;
  int last_id_ = 0;
};

inline std::string hash_of_run(const Workplace& place, const std::string& arguments) {
  return Json::parse(place.elsie("run --json " + arguments).out).at("state_hash");
}

}  // namespace elsie::test
