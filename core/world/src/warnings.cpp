#include "elsie/world/warnings.h"

#include <filesystem>

#include "elsie/plugin/engine_libraries.h"

namespace elsie::world {

std::string Warning::text() const {
  const std::string sentence = "warning: " + message;
  return location.file.empty() ? sentence
                               : base::Problem{location.file, location.line, sentence}.text();
}

std::vector<Warning> warnings(const World& world) {
  std::vector<Warning> found;
  for (const base::Problem& remark : world.remarks) {
    found.push_back({Warning::About::no_effect, 0, {remark.file, remark.line}, remark.message});
  }
  const std::string& engine = world.physics.engine;
  if (std::filesystem::exists(plugin::engine_file(engine))) {
    reinterpret_cast<EngineWarnings>(plugin::engine_symbol(engine, "elsie_warn"))(world, found);
  }
  for (Warning& warning : found) {
    if (warning.location.file.empty()) warning.location.file = world.file;
  }
  return found;
}

}  // namespace elsie::world
