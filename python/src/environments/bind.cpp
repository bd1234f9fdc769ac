// Binds the worlds of elsie.Env, elsie.VectorEnv and elsie.ParallelEnv.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "elsie/base/error.h"
#include "elsie/base/words.h"
#include "elsie/plugin/script.h"
#include "elsie/simulation/run_result.h"
#include "elsie/world/reader.h"

#include "bindings.h"
#include "environments/worlds.h"
#include "image_array.h"
#include "made.h"
#include "world.h"

namespace elsie::python {
namespace {

using Names = std::vector<std::tuple<std::string, std::optional<double>, std::optional<double>>>;
using Terms = std::optional<std::vector<std::pair<std::string, double>>>;

py::object of_plugins(const char* name) { return py::module_::import("elsie.plugins").attr(name); }

/// What numpy does about errors (errors_of_numpy) where a call comes from, in a thread that helps:
/// a thread of C++ would have numpy's own choice, and plugins in Python would do one thing here and
/// another there. Plugins share one state of Python while it lives.
class Helping {
 public:
  explicit Helping(const py::object& errors) : lock_(PyGILState_Ensure()) {
    try {
      of_plugins("take_errors")(*errors);
    } catch (const py::error_already_set&) {  // it goes by numpy's own choice
    }
    state_ = PyEval_SaveThread();
  }
  ~Helping() {
    PyEval_RestoreThread(state_);
    PyGILState_Release(lock_);
  }
  Helping(const Helping&) = delete;
  Helping& operator=(const Helping&) = delete;

 private:
  PyGILState_STATE lock_;
  PyThreadState* state_;
};

bool has_scripts(const plugin::Host& host) {
  for (const auto& directory : host.report().directories) {
    for (const plugin::FileReport& file : directory.files) {
      if (file.status == plugin::FileStatus::loaded && plugin::is_script(file.path)) return true;
    }
  }
  return false;
}

/// Raises KeyboardInterrupt after Ctrl-C, or what a handler of the user raises.
void look_for_signals() {
  const py::gil_scoped_acquire held;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

/// What Python holds: the worlds, and the shapes of arrays that it gives and gets.
class Held : public Made {
 public:
  Held(Declared declared, MakeWorld maker, const std::shared_ptr<const plugin::Host>& host,
       std::size_t count, std::size_t threads)
      : worlds(std::move(declared), std::move(maker), host, count, threads,
               {[this] { note_errors(); }, look_for_signals,
                [this] { return errors ? std::make_shared<Helping>(errors) : nullptr; }}),
        has_helped_scripts(threads > 1 && count > 1 && has_scripts(*host)),
        shape{static_cast<py::ssize_t>(count * worlds.actions_size())},
        observed_shape{static_cast<py::ssize_t>(worlds.observations().size())} {}

  /// Is called while no thread helps.
  void note_errors() {
    if (!has_helped_scripts) return;
    const py::gil_scoped_acquire held;
    errors = of_plugins("errors_of_numpy")();
  }

  py::object errors;  // of numpy, where the last call came from
  Worlds worlds;
  bool has_helped_scripts;
  std::vector<py::ssize_t> shape, observed_shape;
};

std::vector<Named> named(const Names& names) {
  std::vector<Named> all;
  for (const auto& [name, low, high] : names) all.push_back({name, low, high});
  return all;
}

/// The world does not change with the Python object that it came from.
MakeWorld maker_of(const World& world, std::optional<double> time_limit_s) {
  const auto host = world.shared_host();
  const auto first = std::make_shared<const world::World>(world.description(1, time_limit_s));
  const bool is_drawn = first->drawn && first->drawn->by_run;
  return [=, text = world.text(), file = world.file()](std::uint64_t seed) {
    if (!is_drawn) return *first;
    world::ReadOptions reading = reading_for(seed);
    reading.time_limit_s = time_limit_s;
    return world::parse_world(text, file, *host, reading);
  };
}

std::unique_ptr<Held> make(const World& world, std::size_t count, std::size_t threads,
                           std::vector<std::string> robots, const Names& observe, const Names& act,
                           const Terms& rewards, std::size_t steps,
                           std::optional<double> time_limit_s) {
  Declared declared{std::move(robots), named(observe), named(act), {}, steps, time_limit_s};
  if (rewards) {
    declared.rewards.emplace();
    for (const auto& [name, weight] : *rewards) declared.rewards->push_back({name, weight});
  }
  MakeWorld maker = maker_of(world, time_limit_s);
  const auto host = world.shared_host();
  const py::gil_scoped_release released;
  return made<Held>(std::move(declared), std::move(maker), host, count, threads);
}

std::string text_of(const py::ssize_t* shape, std::size_t size) {
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < size; ++i) numbers.push_back(std::to_string(shape[i]));
  return "(" + base::joined(numbers) + (size == 1 ? ",)" : ")");
}

using Actions = py::array_t<float, py::array::c_style | py::array::forcecast>;

bool has_numbers(const py::array& array) {
  const char kind = array.dtype().kind();
  return kind == 'f' || kind == 'i' || kind == 'u' || kind == 'b';
}

/// Rounded here: numpy would raise or warn, as the user has set (numpy.seterr), when a number is
/// too small or too large for a float. Large ones are clipped later, as all beyond [-1, 1].
Actions rounded(const py::array& given) {
  const auto wide = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(given);
  if (!wide) throw base::BadInput("An action has a number that is too large; expected [-1, 1]");
  Actions actions(std::vector<py::ssize_t>(given.shape(), given.shape() + given.ndim()));
  static constexpr double kMost = std::numeric_limits<float>::max();
  std::transform(wide.data(), wide.data() + wide.size(), actions.mutable_data(), [](double each) {
    return static_cast<float>(std::isfinite(each) ? std::clamp(each, -kMost, kMost) : each);
  });
  return actions;
}

Actions actions_of(const Held& held, const py::object& given) {
  const bool is_ready = py::isinstance<Actions>(given);
  const py::array any = py::array::ensure(given);
  if (!is_ready && (!any || !has_numbers(any))) {
    PyErr_Clear();
    throw base::BadInput("An action is no array of numbers: " + std::string(py::repr(given)));
  }
  const auto size = static_cast<std::size_t>(any.ndim());
  if (size != held.shape.size() || !std::equal(held.shape.begin(), held.shape.end(), any.shape())) {
    throw base::BadInput("The actions have the shape " + text_of(any.shape(), size) +
                         "; expected " + text_of(held.shape.data(), held.shape.size()));
  }
  return is_ready ? py::reinterpret_borrow<Actions>(any) : rounded(any);
}

std::span<const float> span_of(const Actions& actions) {
  return {actions.data(), static_cast<std::size_t>(actions.size())};
}

/// A view of a row of numbers for each world.
template <class Number, class As = Number>
py::array view(const py::object& self, const std::vector<Number>& numbers, std::size_t rows,
               bool is_table) {
  const auto* const at = reinterpret_cast<const As*>(numbers.data());
  const auto count = static_cast<py::ssize_t>(rows);
  py::array all =
      is_table ? py::array(py::dtype::of<As>(),
                           {count, static_cast<py::ssize_t>(numbers.size() / rows)}, at, self)
               : py::array(py::dtype::of<As>(), {count}, at, self);
  py::detail::array_proxy(all.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return all;
}

template <class Member>
auto table(Member member) {
  return [member](const py::object& self) {
    const Worlds& worlds = self.cast<const Held&>().worlds;
    return view(self, (worlds.*member)(), worlds.size(), true);
  };
}

/// "char" in C++, bool in Python.
template <class Member>
auto flags(Member member, bool is_table) {
  return [member, is_table](const py::object& self) {
    const Worlds& worlds = self.cast<const Held&>().worlds;
    return view<char, bool>(self, (worlds.*member)(), worlds.size(), is_table);
  };
}

py::dict listed(const std::vector<Bounded>& numbers) {
  std::vector<std::string> names;
  py::array_t<double> low(static_cast<py::ssize_t>(numbers.size()));
  py::array_t<double> high(static_cast<py::ssize_t>(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    names.push_back(numbers[i].name);
    low.mutable_at(i) = numbers[i].low;
    high.mutable_at(i) = numbers[i].high;
  }
  py::dict all;
  all["names"] = names;
  all["low"] = low;
  all["high"] = high;
  return all;
}

std::size_t checked(const Held& held, std::size_t world) {
  if (world >= held.worlds.size()) {
    throw base::BadInput("There is no world " + std::to_string(world) + "; there are " +
                         std::to_string(held.worlds.size()) + ", counted from 0");
  }
  return world;
}

const std::vector<Bounded>& of_robot(const std::vector<std::vector<Bounded>>& all,
                                     std::size_t robot) {
  if (robot < all.size()) return all[robot];
  throw base::BadInput("There is no robot " + std::to_string(robot) + " in this environment");
}

/// A shape that holds so many numbers.
std::vector<py::ssize_t> shape_of(const std::vector<py::ssize_t>& shape, std::size_t size) {
  const auto product =
      std::accumulate(shape.begin(), shape.end(), py::ssize_t{1}, std::multiplies<>());
  if (product == static_cast<py::ssize_t>(size) &&
      std::all_of(shape.begin(), shape.end(), [](py::ssize_t each) { return each > 0; })) {
    return shape;
  }
  throw base::BadInput("An array of the shape " + text_of(shape.data(), shape.size()) +
                       " does not hold " + base::counted(size, "number"));
}

/// Looks at the simulation of a world between two steps.
template <class Look>
auto look_at(const Held& held, std::size_t world, const Look& look) {
  return held.worlds.look_at(checked(held, world),
                             [&](const Episode& episode) { return look(episode.simulation()); });
}

/// A step of the only world: what elsie.Env returns but for its info.
py::tuple step_alone(Held& held, const py::object& given) {
  Worlds& worlds = held.worlds;
  const Actions actions = actions_of(held, given);
  {
    const py::gil_scoped_release released;
    worlds.step(span_of(actions), Renewal::on_reset);
  }
  const std::vector<float>& observed = worlds.observations();
  py::array_t<float> observation(held.observed_shape);
  std::copy(observed.begin(), observed.end(), observation.mutable_data());
  const std::vector<double>& rewards = worlds.rewards();
  return py::make_tuple(
      std::move(observation),
      std::accumulate(rewards.begin(), rewards.end(), 0.0) / static_cast<double>(rewards.size()),
      worlds.terminated()[0] != 0, worlds.truncated()[0] != 0);
}

}  // namespace

void bind_environments(py::module_& module) {
  py::class_<Held>(module, "Worlds", "The worlds of an environment; see elsie.Env.")
      .def(py::init(&make), py::arg("world"), py::arg("count"), py::arg("threads"),
           py::arg("robots"), py::arg("observe"), py::arg("act"), py::arg("rewards"),
           py::arg("steps"), py::arg("duration"))
      .def("set_shapes",
           [](Held& held, const std::vector<py::ssize_t>& actions,
              const std::vector<py::ssize_t>& observations) {
             held.observed_shape = shape_of(observations, held.worlds.observations().size());
             held.shape = shape_of(actions, held.worlds.size() * held.worlds.actions_size());
           })
      .def("observed",
           [](const Held& held, std::size_t robot) {
             return listed(of_robot(held.worlds.declared().observed, robot));
           })
      .def("acted",
           [](const Held& held, std::size_t robot) {
             return listed(of_robot(held.worlds.declared().acted, robot));
           })
      .def("begin",
           [](Held& held, const std::vector<std::size_t>& chosen,
              const std::vector<std::uint64_t>& seeds) {
             const py::gil_scoped_release released;
             held.worlds.begin(chosen, seeds);
           })
      .def("step",
           [](Held& held, const py::object& given, int renewal) {
             if (renewal < 0 || renewal > static_cast<int>(Renewal::on_reset)) {
               throw base::BadInput("expected 0, 1 or 2 as renewal");
             }
             const Actions actions = actions_of(held, given);
             const py::gil_scoped_release released;
             held.worlds.step(span_of(actions), static_cast<Renewal>(renewal));
           })
      .def("step_alone", &step_alone)
      .def_property_readonly("observations", table(&Worlds::observations))
      .def_property_readonly("last_observations", table(&Worlds::last_observations))
      .def_property_readonly("rewards", table(&Worlds::rewards))
      .def_property_readonly("ended", flags(&Worlds::ended, true))
      .def_property_readonly("terminated", flags(&Worlds::terminated, false))
      .def_property_readonly("truncated", flags(&Worlds::truncated, false))
      .def_property_readonly("begun", flags(&Worlds::begun, false))
      .def("outcome", [](const Held& held,
                         std::size_t world) { return held.worlds.outcome(checked(held, world)); })
      .def("seed",
           [](const Held& held, std::size_t world) {
             return held.worlds.look_at(checked(held, world),
                                        [](const Episode& episode) { return episode.seed(); });
           })
      .def("time_s",
           [](const Held& held, std::size_t world) {
             return look_at(held, world, [](const auto& now) { return now.time_s(); });
           })
      .def("state_hash",
           [](const Held& held, std::size_t world) {
             return look_at(held, world, [](const auto& now) {
               return simulation::hash_text(now.state_hash());
             });
           })
      .def("save",
           [](Held& held, std::size_t world, const std::string& file) {
             checked(held, world);
             const py::gil_scoped_release released;
             return held.worlds.save(world, file);
           })
      .def("picture", [](const Held& held, std::size_t world, int width) {
        checked(held, world);
        Image image;
        {
          const py::gil_scoped_release released;
          image = held.worlds.picture(world, width);
        }
        return array_of(image);
      });
}

}  // namespace elsie::python
