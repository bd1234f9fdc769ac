#include "restored_run.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "elsie/batch/plan.h"
#include "elsie/files/write_whole.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/results/hash.h"
#include "elsie/world/reader.h"

#include "command.h"

namespace elsie::program {

namespace fs = std::filesystem;
using batch::StoredRun;
using plugin::Host;

namespace {

/// None when the file cannot be read.
std::optional<std::string> hash_of(const fs::path& file) {
  try {
    return results::file_sha256(file.string());
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

Host host_of(const StoredRun& run, const PluginOptions& plugins) {
  std::vector<plugin::SearchDirectory> places = search_path(plugins);
  // Before all directories except those that the user named.
  const auto own = std::find_if(places.begin(), places.end(), [](const auto& place) {
    return place.origin != "--plugin" && place.origin != "given";
  });
  std::vector<plugin::SearchDirectory> stored;
  for (const StoredRun::Library& library : run.libraries) {
    if (hash_of(library.path)) {
      stored.push_back({library.path, "the database"});
    }
  }
  places.insert(own, stored.begin(), stored.end());
  return Host(std::move(places));
}

/// The library of "behavior wander 1.0".
fs::path file_of(const Host& host, const std::string& plugin) {
  const std::string kind = plugin.substr(0, plugin.find(' '));
  const std::string rest = plugin.substr(kind.size() + 1);
  const std::string name = rest.substr(0, rest.find(' '));
  for (const auto one : plugin::kPluginKinds) {
    if (plugin::kind_name(one) == kind) {
      return host.file_of(one, name);
    }
  }
  return {};
}

}  // namespace

RestoredRun::RestoredRun(const StoredRun& run, const PluginOptions& plugins,
                         std::optional<fs::path> kept)
    : kept_(std::move(kept)), host_(host_of(run, plugins)) {
  if (run.elsie_version != ELSIE_VERSION) {
    differences_.push_back("the run was done with Elsie " + run.elsie_version +
                           ", and this is " ELSIE_VERSION "; its result may differ");
  }
  compare_libraries(run);
  world::ReadOptions options = read_options();
  restore_data(run);
  options.files = files_;
  world_ = world::parse_world(run.job.world_text, run.job.world_file, host_, options);
  if (run.elsie_version == ELSIE_VERSION) compare_program(run);
}

RestoredRun::~RestoredRun() {
  if (!folder_.empty() && !kept_) {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
}

void RestoredRun::compare_program(const StoredRun& run) {
  const auto stem = [](const fs::path& file) {
    const std::string name = file.filename().string();
    return name.substr(0, name.find(".so"));
  };
  for (const fs::path& file : batch::deciding_libraries(world_, host_)) {
    for (const StoredRun::Library& before : run.program) {
      const auto now = stem(before.path) == stem(file) ? hash_of(file) : std::nullopt;
      if (now && *now != before.sha256) {
        differences_.push_back("the run was done with another build of " + stem(file) +
                               "; its result may differ");
      }
    }
  }
}

void RestoredRun::compare_libraries(const StoredRun& run) {
  for (const StoredRun::Library& library : run.libraries) {
    for (const std::string& plugin : library.plugins) {
      const fs::path file = file_of(host_, plugin);
      if (file.empty()) {
        continue;  // reading the world reports it in more detail
      }
      if (hash_of(file) != library.sha256) {
        differences_.push_back("the plugin '" + plugin + "' comes from another library, '" +
                               file.string() + "', than the run was done with" +
                               (file == library.path ? " (it has changed since)" : "") +
                               "; its result may differ");
      }
    }
  }
}

void RestoredRun::restore_data(const StoredRun& run) {
  std::size_t place = 0;
  for (const StoredRun::Data& data : run.data) {
    const auto now = hash_of(data.path);
    if (now == data.sha256) {
      files_[data.name] = data.path;
      continue;
    }
    if (folder_.empty() && kept_) {
      folder_ = *kept_;
      fs::create_directories(folder_);
    } else if (folder_.empty()) {
      std::string name = (fs::temp_directory_path() / "elsie-replay-XXXXXX").string();
      if (!mkdtemp(name.data())) {
        throw std::runtime_error("cannot make a folder in '" + fs::temp_directory_path().string() +
                                 "' for the data files of the run");
      }
      folder_ = name;
    }
    // With its own name, which plugins may mention, in a separate folder.
    const fs::path folder = folder_ / std::to_string(place++);
    const fs::path file = folder / fs::path(data.path).filename();
    fs::create_directory(folder);
    files::write_whole_or_throw(file, data.content);
    files_[data.name] = file.string();
    differences_.push_back("'" + data.path + "' " + (now ? "has changed since" : "is gone") +
                           "; the run uses its stored content from the database" +
                           (kept_ ? ", now in '" + file.string() + "'" : std::string()));
  }
}

}  // namespace elsie::program
