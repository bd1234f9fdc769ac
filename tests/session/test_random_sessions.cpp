// Random orders to sessions: each is answered, and the command line repeats what came of them.
// ELSIE_TEST_SESSIONS=1000 makes so many.
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "elsie/editing/document.h"

#include "../editing/random_edits.h"
#include "session.h"
#include "shipped.h"

using namespace elsie;
using namespace elsie::test;

namespace {

world::ReadOptions reading() {
  world::ReadOptions options;
  options.data_directories = {source_path("")};
  return options;
}

std::vector<std::string> small_worlds() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(source_path("worlds"))) {
    if (entry.path().extension() == ".xml" &&
        text_of("worlds/" + entry.path().filename().string()).find("neural") == std::string::npos) {
      files.push_back("worlds/" + entry.path().filename().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Sends random orders to a session with this file, and knows what its document should be.
class Visitor {
 public:
  Visitor(unsigned seed, const std::string& file, const std::string& text)
      : random_(seed, shipped()), file_(file) {
    const Json opened =
        session.ask({{"do", "open"}, {"text", text}, {"file", file}, {"seed", seed % 7 + 1}});
    INFO(opened.dump());
    REQUIRE_FALSE(opened.contains("refused"));
    text_ = opened["text"];
  }

  void act() {
    switch (random_.below(10)) {
      case 0:
      case 1:
        run_until(0.01 * static_cast<double>(random_.below(300)));
        break;
      case 2:
      case 3:
        for (std::size_t i = 0; i <= random_.below(20); ++i) {
          session.ask({{"do", "step"}});
        }
        break;
      case 4:
        session.ask({{"do", "at"}, {"time_s", 0.1 * static_cast<double>(random_.below(30))}});
        session.ask({{"do", "paths"}, {"after_s", 0.1 * static_cast<double>(random_.below(30))}});
        session.ask({{"do", "numbers"}, {"names", {"r1/speed"}}});
        break;
      case 5:
        session.ask({{"do", "watch"}, {"what", {"decisions", "sensors", "fuzzy", "measures"}}});
        break;
      case 6:
        if (!before_.empty()) {
          const std::string text = before_.back();
          before_.pop_back();
          take({{"do", "become"}, {"text", text}});
        }
        break;
      case 7: {
        editing::Document typed(text_, file_, shipped(), reading());
        try {
          typed.apply({random_.next(typed.world())});
        } catch (const world::WorldError&) {
          break;
        }
        const Json answer = take({{"do", "become"}, {"text", typed.text()}});
        CHECK((answer.contains("refused") || answer["text"] == typed.text()));
        break;
      }
      default: {
        const editing::Document now(text_, file_, shipped(), reading());
        take({{"do", "edit"}, {"edits", {random_.next(now.world())}}});
      }
    }
  }

  /// Forgets the ends of runs up to now; returns the last one, if there was any.
  Json last_end() {
    session.ask({{"do", "ping"}});  // what was sent before is there
    while (session.has_event("ended")) {
      end_ = session.event("ended");
    }
    return end_;
  }

  Session session;

 private:
  /// To this time, which the clock does not affect, or to the end of the run.
  void run_until(double time_s) {
    last_end();
    if (session.ask({{"do", "run"}, {"until_s", time_s}}).contains("refused")) {
      return;
    }
    const Json event = session.event_of({"paused", "ended"});
    if (event["event"] == "ended") {
      end_ = event;
    }
  }
  Json take(const Json& order) {
    CAPTURE(order.dump());
    const Json answer = session.ask(order);
    REQUIRE(answer.contains("answer"));
    if (!answer.contains("refused")) {
      before_.push_back(text_);
      text_ = answer["text"];
    }
    return answer;
  }

  RandomEdits random_;
  std::string file_, text_;
  std::vector<std::string> before_;  // earlier texts
  Json end_;
};

}  // namespace

TEST_CASE("Whatever is ordered is answered, and the command line repeats the run") {
  const char* const wish = std::getenv("ELSIE_TEST_SESSIONS");
  const unsigned sessions = wish ? static_cast<unsigned>(std::strtoul(wish, nullptr, 10)) : 20;
  const std::vector<std::string> worlds = small_worlds();
  std::size_t repeated = 0;
  for (unsigned seed = 0; seed < sessions; ++seed) {
    const std::string& world = worlds[seed % worlds.size()];
    CAPTURE(seed, world);
    const Workplace place;
    editing::Document document(text_of(world), source_path(world), shipped(), reading());
    if (!document.world().goals.empty()) {
      document.apply({"goal[*]/@remove=true"});
    }
    document.apply({"limits/@time=4"});
    place.write("world.xml", document.text_for(place.file("").string()));
    Visitor visitor(seed, place.file("world.xml").string(), place.read("world.xml"));
    for (int i = 0; i < 25; ++i) {
      visitor.act();
    }
    Session& session = visitor.session;
    session.ask({{"do", "watch"}, {"what", Json::array()}});
    Json end = visitor.last_end();  // runs may have ended before
    if (!session.ask({{"do", "step"}}).contains("refused")) {
      end = visitor.last_end();
      const Json sooner = session.edit({"limits/@time=20"});
      if (sooner.contains("refused") ||
          sooner["text"].get<std::string>().find("wall_time") != std::string::npos ||
          session.ask({{"do", "run"}}).contains("refused")) {
        continue;  // it would take too long, or depend on the clock
      }
      end = session.end_of_run();
    }
    const Json command = session.ask({{"do", "command"}});
    CAPTURE(command.dump());
    if (command["saved"] == false) {
      continue;  // it was edited before the run began
    }
    CAPTURE(end.dump());
    const ProgramRun again = place.sh(command["text"].get<std::string>() + " --json");
    CAPTURE(again.err);
    if (again.err.find("and ends after") != std::string::npos) {
      continue;  // an edit gave it a limit that had passed, and another took it away in time
    }
    const std::string reason = end["reason"];
    if (reason.starts_with("the physics failed")) {
      CHECK(again.err == "elsie: " + reason + "\n");
      ++repeated;
      continue;
    }
    REQUIRE_FALSE(again.out.empty());
    CHECK(Json::parse(again.out)["state_hash"] == end["state_hash"]);
    ++repeated;
  }
  CHECK(repeated > 0);
}
