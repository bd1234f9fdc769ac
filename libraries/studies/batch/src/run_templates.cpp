#include "run_templates.h"

#include <fstream>
#include <string>
#include <utility>

#include "elsie/base/words.h"

namespace elsie::batch {
namespace {

constexpr std::size_t kMostTemplates = 64;  // of each kind

/// Whether half of the machine's memory is available: a world of many robots takes much of it.
bool has_memory_to_spare() {
  std::ifstream facts("/proc/meminfo");
  double total = 0.0, available = 0.0, number = 0.0;
  for (std::string name, line; facts >> name >> number; std::getline(facts, line)) {
    if (name == "MemTotal:") total = number;
    if (name == "MemAvailable:") available = number;
  }
  return available >= 0.5 * total;
}

}  // namespace

/// The template with this key, made again if it is gone. Null: there are too many.
template <class Key, class Make>
RunTemplates::Original RunTemplates::kept(std::map<Key, Original>& originals, const Key& key,
                                          const Make& make) {
  auto place = originals.find(key);
  if (place == originals.end()) {
    if (originals.size() >= kMostTemplates) {
      return nullptr;
    }
    place = originals.emplace(key, make()).first;
  } else if (place->second->is_gone()) {
    place->second = make();
  }
  place->second->hear();
  return place->second;
}

RunTemplates::Original RunTemplates::original_for(const Job& job) {
  if (options_.template_command.empty()) {
    return nullptr;
  }
  const Original loaded = kept(by_libraries_, {job.libraries, job.repetition}, [&] {
    return std::make_shared<RunTemplate>(options_.template_command, job);
  });
  if (!loaded) {
    return nullptr;
  }
  note_refusal(*loaded, "each run that needs these libraries starts a program of its own",
               base::joined(job.libraries, ", "));
  if (!loaded->is_ready()) {
    return loaded->is_loading() ? loaded : nullptr;
  }
  if (!job.cell || job.threads > 1) {  // threads are not copied
    return loaded;
  }
  const std::pair cell(*job.cell, job.repetition);
  if (!by_cell_.contains(cell) && !has_memory_to_spare()) {
    return loaded;
  }
  const Original with_world =
      kept(by_cell_, cell, [&] { return std::make_shared<RunTemplate>(loaded, job); });
  if (!with_world) {
    return loaded;
  }
  note_refusal(*with_world, "each run of this world reads it and makes its plugins anew",
               job.world_file);
  return with_world->is_ready() || with_world->is_loading() ? with_world : loaded;
}

void RunTemplates::note_refusal(RunTemplate& original, const std::string& consequence,
                                const std::string& what) {
  const std::string why = original.take_refusal();
  if (!why.empty() && options_.note) {
    options_.note(consequence + ", because " + why + ": " + what);
  }
}

}  // namespace elsie::batch
