#include "elsie/batch/plan.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <sys/stat.h>

#include "elsie/experiment/plugin_uses.h"
#include "elsie/experiment/reader.h"
#include "elsie/plugin/abi_word.h"
#include "elsie/plugin/declared_element.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/results/hash.h"
#include "elsie/world/edited_worlds.h"
#include "elsie/world/writer.h"

#include "stages.h"

namespace elsie::batch {
namespace {

std::string absolute(const std::string& file) {
  std::error_code error;
  const auto path = std::filesystem::canonical(file, error);
  return error ? std::filesystem::absolute(file).string() : path.string();
}

/// Makes a path absolute without following links: a library is recognized by its name's suffix.
std::string absolute_name(const std::filesystem::path& library) {
  return std::filesystem::absolute(library).lexically_normal().string();
}

/// Makes a plan, cell by cell.
class Planner {
 public:
  Planner(const experiment::Experiment& experiment, const plugin::Host& host,
          const PlanOptions& options)
      : experiment_(experiment), host_(host), options_(options) {}

  Plan make() {
    begin();
    for (const experiment::Cell& cell : experiment::cells(experiment_)) {
      add(cell);
    }
    plan_.stages.push_back({plan_.cells.size(), experiment_.seeds, experiment_.repeats, 0, {}});
    number_runs(plan_);
    plan_.fingerprint = plan_.stages.back().fingerprint = fingerprint_of(plan_, 1);
    return std::move(plan_);
  }

 private:
  void begin() {
    plan_.elsie_version = options_.elsie_version;
    plan_.abi = plugin::host_abi_word();
    plan_.experiment = experiment_.name;
    plan_.description = experiment_.description;
    plan_.file = experiment_.file;
    plan_.text = options_.text;
    plan_.shard = options_.shard;
    plan_.wall_limit_s = experiment_.wall_limit;
    plan_.trajectory_period_s = experiment_.trajectory_period;
    plan_.factors = experiment::factor_names(experiment_);
    for (const auto& directory : host_.report().directories) {
      for (const auto& file : directory.files) {
        ranks_.try_emplace(absolute_name(file.path), ranks_.size() + 1);
      }
    }
  }

  void add(const experiment::Cell& cell) {
    const experiment::WorldUse& use = experiment_.worlds[cell.world];
    PlannedCell planned;
    planned.label = cell.label;
    planned.world = use.id;
    planned.world_file = absolute(use.file);
    planned.levels = cell.labels;
    planned.places = cell.levels;
    planned.places.insert(planned.places.begin(), cell.world);
    world::World world = world_of(cell, experiment_.seeds.front());
    add_program(world, planned);
    add_file(FileKind::world, planned.world_file);
    FileNames files{planned.world_file, {}};
    std::vector<std::size_t> plugins;
    const auto see = [&](PluginKind kind, world::PluginUse& plugin) {
      plugins.push_back(add_plugin(kind, plugin.plugin));
      name_files(plugin::DeclaredElement(*host_.find(kind, plugin.plugin)), plugin, files);
    };
    std::map<std::string, std::string> found;
    world::ReadOptions options;
    options.data_directories = options_.data_directories;
    options.found = &found;
    const world::World start = world;
    experiment::for_each_use(world, see);
    name_image(world.floor, files);
    world::visit_edited_worlds(start, host_, options, [&](world::World later) {
      add_program(later, planned);
      experiment::for_each_use(later, see);
      name_image(later.floor, files);
    });
    for (const auto& [name, path] : found) {
      files.add(name, path);
    }
    std::sort(plugins.begin(), plugins.end());
    plugins.erase(std::unique(plugins.begin(), plugins.end()), plugins.end());
    planned.plugins = std::move(plugins);
    for (const auto& [name, path] : files.paths) {
      planned.data.push_back({name, add_file(FileKind::data, path)});
    }
    planned.world_text = world::write_world(world);
    planned.goals = !world.goals.empty();
    planned.sha256 = results::sha256(planned.world_text);
    planned.place = cell.index;
    if (world.drawn && world.drawn->by_run) {
      add_layouts(cell, planned, files);
    } else if (world.drawn) {
      planned.layout_seed = world.drawn->seed;
    }
    planned.identity = identity(planned);
    plan_.cells.push_back(std::move(planned));
  }

  void add_program(const world::World& world, PlannedCell& planned) {
    for (const std::filesystem::path& library : deciding_libraries(world, host_)) {
      planned.program.insert(add_file(FileKind::library, absolute(library.string())));
    }
  }

  /// The data files that a world's text names.
  struct FileNames {
    std::string world;                         // its file
    std::map<std::string, std::string> paths;  // by name

    /// Names a file; if another one has its name, also after its content: paths do not count.
    void add(world::FileName& file) {
      if (paths.try_emplace(file.name, file.path).first->second != file.path) {
        file.name += '#' + results::file_sha256(file.path);
        paths.try_emplace(file.name, file.path);
      }
    }
    /// Adds a file that an edit names, whose text stays. Throws world::WorldError if another file
    /// has this name.
    void add(const std::string& name, const std::string& path) {
      if (const std::string& known = paths.try_emplace(name, path).first->second; known != path) {
        throw world::WorldError({{world, 0,
                                  "the files '" + known + "' and '" + path + "' are both called '" +
                                      name + "', one of them by an edit; expected two names"}});
      }
    }
  };

  /// The worlds of the seeds, which differ in what their layouts have drawn.
  void add_layouts(const experiment::Cell& cell, PlannedCell& planned, FileNames& files) {
    for (const std::uint64_t seed : experiment_.seeds) {
      world::World world = world_of(cell, seed);
      experiment::for_each_use(world, [&](PluginKind kind, world::PluginUse& plugin) {
        name_files(plugin::DeclaredElement(*host_.find(kind, plugin.plugin)), plugin, files);
      });
      name_image(world.floor, files);
      const std::string text = world::write_world(world);
      planned.layouts[seed] = {text, results::sha256(text)};
    }
  }

  world::World world_of(const experiment::Cell& cell, std::uint64_t seed) const {
    experiment::ReadOptions options;
    options.data_directories = options_.data_directories;
    world::World world = experiment::read_cell(experiment_, cell, host_, options, seed);
    world.limits.wall_time.reset();
    return world;
  }

  std::size_t add_plugin(PluginKind kind, const std::string& name) {
    const auto [known, is_new] = plugin_places_.try_emplace({kind, name}, plan_.plugins.size());
    if (is_new) {
      PlannedPlugin planned{std::string(plugin::kind_name(kind)), name,
                            host_.find(kind, name)->version, std::nullopt};
      const std::filesystem::path file = host_.file_of(kind, name);
      if (!file.empty()) {
        planned.file = add_file(FileKind::library, absolute_name(file));
      }
      plan_.plugins.push_back(std::move(planned));
    }
    return known->second;
  }

  std::size_t add_file(FileKind kind, const std::string& path) {
    const auto [known, is_new] = file_places_.try_emplace(path, plan_.files.size());
    if (is_new) {
      // Of data files the database has the bytes.
      std::string content = kind == FileKind::data ? results::file_content(path) : "";
      std::string hash =
          kind == FileKind::data ? results::sha256(content) : results::file_sha256(path);
      const auto rank = ranks_.find(path);
      plan_.files.push_back({kind, path, std::move(hash), std::move(content),
                             rank == ranks_.end() ? 0 : rank->second});
    } else if (PlannedFile& file = plan_.files[known->second];
               kind == FileKind::data && file.kind != kind) {
      file.kind = kind;  // a world may also serve as a data file
      file.content = results::file_content(path);
    }
    return known->second;
  }

  /// Makes the world's text name every file, with different names for different files.
  static void name_files(const std::vector<ParameterDeclaration>& declared,
                         const std::map<std::string, ParameterValue>& parameters,
                         std::map<std::string, world::FileName>& file_names, FileNames& files) {
    for (auto& [parameter, file] : file_names) {
      const auto value = parameters.find(parameter);
      if (value == parameters.end() || value->second != ParameterValue(file.path)) {
        continue;
      }
      if (file.name.empty()) {
        const auto declaration =
            std::find_if(declared.begin(), declared.end(),
                         [&name = parameter](const auto& other) { return other.name == name; });
        file.name = std::get<std::string>(declaration->default_value);
      }
      files.add(file);
    }
  }

  template <class Use>
  static void name_files(const plugin::DeclaredElement& declared, Use& use, FileNames& files) {
    name_files(declared.parameters(), use.parameters, use.file_names, files);
    for (world::ElementUse& element : use.elements) {
      name_files(*declared.inside(element.element), element, files);
    }
  }

  static void name_image(world::Floor& floor, FileNames& files) {
    if (!floor.pixels) return;
    world::FileName image{floor.image_file, floor.image};
    files.add(image);
    floor.image = image.name;
  }

  /// Everything about a cell that affects its results.
  std::string identity(const PlannedCell& cell) const {
    std::string all;
    const auto add = [&](const std::string& text) {
      all += std::to_string(text.size()) + ':' + text + '\n';  // different for different lists
    };
    add(cell.layouts.empty() ? cell.sha256 : "");  // of layouts, it depends on the first seed
    for (const std::string& level : cell.levels) {
      add(level);
    }
    std::set<std::vector<std::string>> plugins;  // in an order that other cells do not change
    for (const std::size_t place : cell.plugins) {
      const PlannedPlugin& plugin = plan_.plugins[place];
      plugins.insert({plugin.kind, plugin.name, plugin.version,
                      plugin.file ? plan_.files[*plugin.file].sha256 : ""});
    }
    for (const std::vector<std::string>& plugin : plugins) {
      for (const std::string& part : plugin) {
        add(part);
      }
    }
    all += ";\n";
    std::set<std::string> program;
    for (const std::size_t place : cell.program) {
      program.insert(plan_.files[place].sha256);
    }
    for (const std::string& hash : program) {
      add(hash);
    }
    all += ";\n";
    for (const PlannedCell::Data& data : cell.data) {  // sorted by name
      add(data.name);
      add(plan_.files[data.file].sha256);
    }
    return results::sha256(all);
  }

  const experiment::Experiment& experiment_;
  const plugin::Host& host_;
  const PlanOptions& options_;
  Plan plan_;
  std::map<std::pair<PluginKind, std::string>, std::size_t> plugin_places_;
  std::map<std::string, std::size_t> file_places_;
  std::map<std::string, std::size_t> ranks_;  // of the host's files
};

}  // namespace

const char* to_string(FileKind kind) {
  switch (kind) {
    case FileKind::data:
      return "data";
    case FileKind::library:
      return "library";
    case FileKind::world:
      break;
  }
  return "world";
}

std::string Shard::text() const { return std::to_string(index) + '/' + std::to_string(of); }

std::optional<Shard> parse_shard(std::string_view text) {
  const char* const end = text.data() + text.size();
  Shard shard;
  const auto index = std::from_chars(text.data(), end, shard.index);
  if (index.ec != std::errc() || index.ptr == end || *index.ptr != '/') {
    return std::nullopt;
  }
  const auto of = std::from_chars(index.ptr + 1, end, shard.of);
  if (of.ec != std::errc() || of.ptr != end || shard.index < 1 || shard.index > shard.of) {
    return std::nullopt;
  }
  return shard;
}

std::set<std::size_t> Plan::program() const {
  std::set<std::size_t> all;
  for (const PlannedCell& cell : cells) {
    all.insert(cell.program.begin(), cell.program.end());
  }
  return all;
}

std::vector<std::string> Plan::libraries(const PlannedCell& cell) const {
  std::set<std::pair<std::size_t, std::string>> ranked;
  for (const std::size_t place : cell.plugins) {
    if (const auto& from = plugins[place].file) {
      ranked.emplace(files[*from].rank, files[*from].path);
    }
  }
  std::vector<std::string> libraries;
  for (const auto& [rank, path] : ranked) {
    libraries.push_back(path);
  }
  return libraries;
}

Plan make_plan(const experiment::Experiment& experiment, const plugin::Host& host,
               const PlanOptions& options) {
  return Planner(experiment, host, options).make();
}

std::vector<PlannedRun> in_order(const Plan& plan, const std::vector<std::int64_t>& runs) {
  std::map<std::uint64_t, std::size_t> ranks;  // of seeds
  for (const Stage& stage : plan.stages) {
    for (const std::uint64_t seed : stage.seeds) {
      ranks.try_emplace(seed, ranks.size());
    }
  }
  std::vector<PlannedRun> ordered;
  for (const std::int64_t id : runs) {
    const auto run = std::lower_bound(
        plan.runs.begin(), plan.runs.end(), id,
        [](const PlannedRun& other, std::int64_t number) { return other.id < number; });
    if (run == plan.runs.end() || run->id != id) {
      throw std::out_of_range("run " + std::to_string(id));
    }
    ordered.push_back(*run);
  }
  const auto key = [&](const PlannedRun& run) {
    return std::tuple(run.repetition, ranks.at(run.seed), plan.cells[run.cell].place);
  };
  std::sort(ordered.begin(), ordered.end(),
            [&](const PlannedRun& a, const PlannedRun& b) { return key(a) < key(b); });
  return ordered;
}

FileCheck::FileCheck(const Plan& plan) : plan_(plan), stamps_(plan.files.size()) {}

FileCheck::Stamp FileCheck::stamp_of(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) {
    return {};
  }
  return {status.st_size, status.st_mtim.tv_sec * 1'000'000'000 + status.st_mtim.tv_nsec,
          status.st_ino};
}

bool FileCheck::is_changed(std::size_t place) {
  const PlannedFile& file = plan_.files[place];
  const Stamp now = stamp_of(file.path);
  if (now.size >= 0 && now == stamps_[place]) {
    return false;
  }
  try {
    if (results::file_sha256(file.path) != file.sha256) {
      return true;
    }
  } catch (const std::runtime_error& why) {
    std::error_code ignored;
    if (std::filesystem::exists(file.path, ignored)) {
      throw;  // such as too many open files: nothing says that it has changed
    }
    return true;
  }
  stamps_[place] = now;
  return false;
}

std::optional<std::string> FileCheck::changed(std::size_t cell) {
  const PlannedCell& planned = plan_.cells[cell];
  for (const std::size_t place : planned.program) {
    if (is_changed(place)) {
      return plan_.files[place].path;
    }
  }
  for (const std::size_t place : planned.plugins) {
    const auto& file = plan_.plugins[place].file;
    if (file && is_changed(*file)) {
      return plan_.files[*file].path;
    }
  }
  for (const PlannedCell::Data& data : planned.data) {
    if (is_changed(data.file)) {
      return plan_.files[data.file].path;
    }
  }
  return std::nullopt;
}

}  // namespace elsie::batch
