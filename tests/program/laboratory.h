// A folder with experiments for the program.
#pragma once

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "../batch/tables.h"
#include "places.h"
#include "program.h"

namespace elsie::test {

inline std::string world_with(const std::string& behavior, const std::string& more = "") {
  return "<world format=\"1\"><limits time=\"2\"/><obstacles><static_box x=\"0.5\" "
         "y=\"0\"/></obstacles>"
         "<robots><robot id=\"r1\" team=\"red\"><sensors><beam_range/></sensors><behaviors><" +
         behavior + "/>" + more +
         "</behaviors><coordinator><fusion_vector_summation/></coordinator></robot></robots>"
         "</world>\n";
}

/// A folder with experiments of runs of two simulated seconds.
class Laboratory : public Workplace {
 public:
  Laboratory() {
    write("small.xml", world_with("wander", "<avoid_obstacle/>"));
    write("small_experiment.xml", experiment("<world file=\"small.xml\"/>", kSpeeds, 8));
  }

  static constexpr const char* kSpeeds =
      "<vary name=\"speed\" path=\"robot[r1]/@max_speed\" values=\"0.05; 0.1; 0.4\"/>";

  /// The plugin `dawdling` takes a second for each step after half a simulated second; see also
  /// kDawdlesOnRequest.
  static constexpr const char* kTwoDawdledSteps = "<limits time=\"0.52\"/>";

  static std::string experiment(const std::string& worlds, const std::string& factors, int seeds,
                                const std::string& limits = "", int repeats = 1) {
    return "<experiment format=\"1\"><worlds>" + worlds + "</worlds>" + factors +
           "<seeds from=\"1\" to=\"" + std::to_string(seeds) + "\" repeats=\"" +
           std::to_string(repeats) + "\"/>" + limits + "</experiment>\n";
  }

  /// Writes an experiment with one world for each of these plugins of plugins/faulty.cpp.
  void write_faulty(const std::vector<std::string>& plugins, const std::string& limits,
                    int seeds = 1) const {
    std::string worlds;
    for (const std::string& plugin : plugins) {
      write(plugin + ".xml", world_with(plugin));
      worlds += "<world file=\"" + plugin + ".xml\"/>";
    }
    write("faulty.xml", experiment(worlds, "", seeds, limits));
  }

  /// Functions of the shell: the processes that the batch with this number has started, and those
  /// of them that do runs.
  static inline const std::string kWorkersOf =
      "processes_of() { for p in $(cat /proc/$1/task/$1/children 2>/dev/null); do\n"
      "  echo $p; processes_of $p; done; }\n"
      "workers_of() { for p in $(processes_of $1); do\n"
      "  if [ \"$(cat /proc/$p/comm 2>/dev/null)\" = elsie-run ]; then echo $p; fi; done; }\n";

  /// For the shell: dawdled steps wait until `pass_one` lets one go on, or `pass_all` all. On a
  /// cluster both take the number of a shard.
  static inline const std::string kDawdlesOnRequest =
      "export FAULTY_DAWDLES_UNTIL=\"$PWD/go\"\n"
      "pass_one() { touch go$1; while [ -e go$1 ]; do sleep 0.02; done; }\n"
      "pass_all() { mkdir go$1; }\n";

  ProgramRun batch(const std::string& arguments) const {
    return elsie("batch " + arguments + " --plugin-path " + plugins());
  }
  /// Without the time of dawdled steps.
  ProgramRun elsie_at_once(const std::string& arguments) const {
    return sh("FAULTY_DAWDLES_UNTIL=. elsie " + arguments);
  }
  ProgramRun batch_at_once(const std::string& arguments) const {
    return elsie_at_once("batch " + arguments + " --plugin-path " + plugins());
  }
  static std::string plugins() { return elsie::test::build_path("tests/program/plugins"); }
  std::string table(const std::string& name) const { return all_tables(file(name).string()); }
  std::string query(const std::string& name, const std::string& sql) const {
    return rows(file(name).string(), sql);
  }
  void check_sound(const std::string& name) const {
    CHECK(query(name, "PRAGMA integrity_check") == "ok\n");
    CHECK(query(name, "PRAGMA foreign_key_check").empty());
  }
};

}  // namespace elsie::test
