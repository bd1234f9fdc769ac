// Binds elsie.Simulation.
#include <algorithm>
#include <utility>

#include <pybind11/stl.h>

#include "elsie/api/geometry.h"
#include "elsie/base/error.h"
#include "elsie/recording/formats.h"
#include "elsie/render/world_cameras.h"
#include "elsie/world/data_directories.h"

#include "account.h"
#include "results.h"
#include "simulation.h"
#include "turn.h"
#include "values.h"

namespace elsie::python {
namespace {

simulation::Options options_of(const SimulationOptions& options) {
  return {.seed = options.seed,
          .data_directories = world::default_data_directories(),
          .threads = options.threads,
          .time_limit_s = options.time_limit_s,
          .cameras = render::world_cameras};
}

}  // namespace

/// Notices that robots, sensors or plugins have become others.
class Simulation::Watcher final : public simulation::Observer {
 public:
  void started(const simulation::Simulation&) override { is_new = true; }
  void replaced(const simulation::Simulation&) override { is_new = true; }
  bool is_new = false;
};

Simulation::Simulation(const World& world, const SimulationOptions& options)
    : host_(world.shared_host()), options_(options), watcher_(std::make_unique<Watcher>()) {
  world::World described = world.description(options.seed, options.time_limit_s, options.edits);
  if (described.drawn && described.drawn->by_run) {
    drawn_ = made<World>(world.text(), world.file(), host_);
  }
  const py::gil_scoped_release released;  // networks may learn now
  simulation_ =
      std::make_unique<simulation::Simulation>(std::move(described), *host_, options_of(options));
}

Simulation::~Simulation() = default;

void Simulation::require_idle() const {
  if (is_stepping_) {
    throw base::Error(
        "this simulation is in the middle of a step, in another thread or around this call of a "
        "plugin; wait for the step to end, or make a simulation for each thread");
  }
}

void Simulation::begin() {
  if (run_) return;
  if (failure_) std::rethrow_exception(failure_);
  std::vector<simulation::Observer*> observers{watcher_.get()};
  if (options_.trace) {
    account_ = std::make_shared<traces::AccountRecorder>();
    observers.push_back(account_.get());
  }
  if (options_.paths) {
    tracks_ = std::make_unique<traces::TrackRecorder>();
    observers.push_back(tracks_.get());
  }
  for (const auto& recorder : recorders_) observers.push_back(recorder.get());
  run_ = std::make_unique<simulation::Run>(*simulation_, observers);
}

std::uint64_t Simulation::advance(std::uint64_t steps, double until_s) {
  require_idle();
  if (is_closed_ && !failure_ && simulation_->outcome() == simulation::Outcome::running) {
    throw base::Error("this run was closed before its end; reset() starts it again");
  }
  std::uint64_t made = 0;
  while (made < steps) {
    std::uint64_t more = 0;
    try {
      struct Stepping {
        explicit Stepping(bool& is_stepping) : is_stepping_(is_stepping) { is_stepping = true; }
        ~Stepping() { is_stepping_ = false; }
        bool& is_stepping_;
      };
      const Stepping stepping(is_stepping_);
      const py::gil_scoped_release released;
      try {
        begin();
        more = steps_until(steps - made, until_s);
      } catch (...) {
        failure_ = std::current_exception();
        throw;
      }
    } catch (...) {
      try {
        refresh();                       // arrays show the instant of the fault
      } catch (const std::exception&) {  // the plugin that failed, again
      }
      throw;
    }
    made += more;
    if (more == 0) break;
    if (PyErr_CheckSignals() != 0) {
      const py::error_already_set interrupted;  // takes it: what follows may call scripts
      refresh();
      throw interrupted;
    }
  }
  refresh();
  return made;
}

/// Returns early, at the end of a turn.
std::uint64_t Simulation::steps_until(std::uint64_t steps, double until_s) {
  constexpr double kRounding = 1e-6;  // steps
  Turn turn;
  std::uint64_t made = 0;
  while (made < steps) {
    if (simulation_->time_s() >= until_s - kRounding * simulation_->world().physics.step) break;
    if (!run_->step()) break;
    ++made;
    if (turn.is_over()) break;
  }
  return made;
}

simulation::RunResult Simulation::end() {
  require_idle();
  begin();
  is_closed_ = true;
  return run_->end();
}

void Simulation::reset(std::optional<std::uint64_t> seed) {
  require_idle();
  run_.reset();
  is_closed_ = false;
  failure_ = nullptr;
  warnings_.clear();
  account_.reset();
  tracks_.reset();
  recorders_.clear();
  const bool is_other = seed && *seed != options_.seed;
  if (seed) options_.seed = *seed;
  if (is_other && drawn_) {
    simulation_ = std::make_unique<simulation::Simulation>(
        drawn_->description(seed, options_.time_limit_s, options_.edits), *host_,
        options_of(options_));
    watcher_->is_new = true;
  } else {
    watcher_->is_new = watcher_->is_new || simulation_->has_edits();
    simulation_->reset(seed);
  }
  refresh();
}

void Simulation::edit(const std::vector<std::pair<std::string, std::string>>& edits) {
  require_idle();
  std::vector<simulation::Edit> all;
  for (const auto& [path, value] : edits) all.push_back({path, value});
  simulation_->edit(all);
  watcher_->is_new = true;  // before the first step no observer is asked
  refresh();
}

void Simulation::record(const std::string& file, double rate_hz, bool images,
                        const std::vector<std::string>& robots) {
  require_idle();
  if (run_) {
    throw base::BadInput("a recording begins with its run, and this run has begun at " + file +
                         "; call record() before the first step, or reset() first");
  }
  recording::require_recording(file, "record");
  recording::RecorderOptions options;
  options.rate_hz = rate_hz;
  options.images = images;
  options.robots = robots;
  options.warn = [this](const std::string& sentence) { warnings_.push_back(sentence); };
  recorders_.push_back(recording::format_of(file)->recorder(file, options));
}

py::array Simulation::table(MakeTable make, const std::string& name) {
  require_idle();
  auto found = tables_.find({make, name});
  if (found == tables_.end()) {
    found = tables_.emplace(std::pair(make, name), make(*simulation_, name)).first;
    found->second.refresh(*simulation_);
  }
  return found->second.view();
}

void Simulation::refresh() {
  if (watcher_->is_new) {
    for (auto table = tables_.begin(); table != tables_.end();) {
      const auto& [make, name] = table->first;
      try {
        table->second.become(make(*simulation_, name));
        ++table;
      } catch (const base::BadInput&) {  // there are none of this name any more
        table = tables_.erase(table);
      }
    }
    watcher_->is_new = false;
  }
  std::exception_ptr fault;
  for (auto& [key, table] : tables_) {
    try {
      table.refresh(*simulation_);
    } catch (...) {
      if (!fault) fault = std::current_exception();
    }
  }
  if (fault) std::rethrow_exception(fault);
}

namespace {

py::list robot_ids(const simulation::Simulation& now) {
  py::list ids;
  for (const world::Robot& robot : now.world().robots) ids.append(robot.id);
  return ids;
}

py::list events_from(const simulation::Simulation& now, std::size_t first) {
  py::list events;
  const auto all = now.events();
  for (std::size_t i = first; i < all.size(); ++i) {
    events.append(py::make_tuple(all[i].time_s, all[i].robot, all[i].name(), all[i].detail()));
  }
  return events;
}

py::list notes_of(std::span<const simulation::Note> all) {
  py::list notes;
  for (const simulation::Note& note : all) {
    notes.append(py::make_tuple(note.robot, note.plugin, note.text));
  }
  return notes;
}

}  // namespace

void bind_simulations(py::module_& module) {
  py::class_<Account>(module, "Account")
      .def("coordinators", &Account::coordinators)
      .def("episodes", &Account::episodes)
      .def("behaviors", &Account::behaviors);
  py::class_<Simulation>(module, "Simulation", "The base of elsie.Simulation.")
      .def(py::init([](const World& world, std::uint64_t seed, std::size_t threads,
                       std::optional<double> time_limit_s, const py::list& edits, bool trace,
                       bool paths) {
             return made<Simulation>(world, SimulationOptions{seed, threads, time_limit_s,
                                                              texts_of(edits), trace, paths});
           }),
           py::arg("world"), py::arg("seed"), py::arg("threads"), py::arg("time_limit"),
           py::arg("edits"), py::arg("trace"), py::arg("paths"))
      .def("_advance", &Simulation::advance)
      .def("_finish", [](Simulation& self) { return dict_of(self.end()); })
      .def("_result_fields", [](Simulation& self) { return dict_of(self.now().result()); })
      .def("_reset_to", &Simulation::reset)
      .def("_edit_all", [](Simulation& self, const py::list& edits) { self.edit(edits_of(edits)); })
      .def("_value",
           [](Simulation& self, const std::string& path) {
             return value_at(self.now().world(), *self.shared_host(), path);
           })
      .def("_account",
           [](Simulation& self) -> std::unique_ptr<Account> {
             auto recorder = self.account();
             return recorder ? made<Account>(std::move(recorder)) : nullptr;
           })
      .def("_record_to", &Simulation::record)
      .def("_recorders_said", &Simulation::warnings)
      .def("_of_robots", [](Simulation& self,
                            const std::string& name) { return self.table(&table_of_robots, name); })
      .def("_of_obstacles", [](Simulation& self) { return self.table(&table_of_obstacles, ""); })
      .def("_of_field", [](Simulation& self,
                           const std::string& name) { return self.table(&table_of_field, name); })
      .def("_readings_of",
           [](Simulation& self, const std::string& name) {
             return self.table(&table_of_readings, name);
           })
      .def("_published_as",
           [](Simulation& self, const std::string& name) {
             return self.table(&table_of_published, name);
           })
      .def("_events_from",
           [](Simulation& self, std::size_t first) { return events_from(self.now(), first); })
      .def("_all_notes", [](Simulation& self) { return notes_of(self.now().notes()); })
      .def_property_readonly(
          "robots", [](Simulation& self) { return robot_ids(self.now()); },
          "Ids, in the order of all arrays with a row for each robot.")
      .def_property_readonly(
          "obstacle_ids",
          [](Simulation& self) {
            py::list ids;
            for (const world::Obstacle& obstacle : self.now().world().obstacles) {
              ids.append(obstacle.id);
            }
            return ids;
          },
          "Ids, in the order of `obstacles`.")
      .def_property_readonly(
          "time", [](Simulation& self) { return self.now().time_s(); }, "Simulated time, s.")
      .def_property_readonly(
          "time_limit", [](Simulation& self) { return self.now().time_limit_s(); },
          "Simulated time after which the run ends, s.")
      .def_property_readonly(
          "step_s", [](Simulation& self) { return self.now().world().physics.step; },
          "A step of the physics, s.")
      .def_property_readonly(
          "steps", [](Simulation& self) { return self.now().steps(); }, "Steps so far.")
      .def_property_readonly(
          "seed", [](Simulation& self) { return self.now().seed(); }, "Of the run.")
      .def_property_readonly(
          "outcome", [](Simulation& self) { return to_string(self.now().outcome()); },
          "running, success, failure or time_limit.")
      .def_property_readonly(
          "state_hash",
          [](Simulation& self) { return simulation::hash_text(self.now().state_hash()); },
          "16 hexadecimal digits over the state of all bodies and batteries: the same in equal "
          "runs.");
}

}  // namespace elsie::python
