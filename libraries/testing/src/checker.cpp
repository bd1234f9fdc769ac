#include "elsie/testing/checker.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <latch>
#include <optional>
#include <set>
#include <utility>

#include "elsie/base/thread_pool.h"
#include "elsie/base/thrown.h"
#include "elsie/plugin/call.h"
#include "elsie/plugin/kind_name.h"

#include "memory.h"
#include "random_input.h"
#include "random_settings.h"
#include "text.h"
#include "trial.h"

namespace elsie::testing {
namespace {

constexpr std::uint64_t kRunSeed = 5;

double time_of(std::size_t step) { return static_cast<double>(step) * kPeriod; }

/// "step 3 (at 0.03 s)".
std::string at(std::size_t step) { return base::step_text(step, time_of(step)); }

/// Thrown when a plugin exceeds CheckOptions::memory_limit.
class TooMuchMemory {};

class Checker {
 public:
  Checker(const Declaration& declaration, const CheckOptions& options, const Plugins& plugins)
      : declaration_(declaration),
        options_(options),
        plugins_(plugins),
        random_(options.seed),
        inputs_(declaration, options, plugins) {}

  std::vector<std::string> findings() && {
    // Crash reports name the plugin of this call.
    const plugin::Call call({.plugin = &declaration_.name, .doing = "while it was checked"});
    found_ = testing::check_declaration(declaration_);
    if (check_start() && make_inputs()) {
      for (int variant = 0; variant <= options_.variants; ++variant) {
        try_variant(variant);
      }
      check_memory();
    }
    if (!told_.contains("shared") && !told_.contains("reset") && !in_threads_.empty()) {
      find("threads", in_threads_);
    }
    return std::move(found_);
  }

 private:
  using Answers = std::vector<Answer>;

  /// After a call: finds changes to the process that are not allowed.
  void look_at_process(plugin::Call& call) {
    if (const char* const changed = call.restore_arithmetic()) {
      find("arithmetic", std::string("it changes ") + changed + " for the whole program" + where_);
    }
    if (call.has_forked()) {
      find("forks",
           "it makes a copy of the program with fork(); start other programs with "
           "posix_spawn()" +
               where_);
    }
  }

  /// reset(), with a time limit by process::Watchdog.
  void reset(Trial& trial, std::uint64_t seed) {
    plugin::Call call({.doing = doing_.c_str()});
    call.start_clock();
    trial.reset(seed);
    look_at_process(call);
  }

  /// Sets the place that further findings name.
  void be_at(const Settings& settings, const Input& input) {
    where_ = " (" + in_words(settings) + "; " + input.robot + ")";
    doing_ = "while it was tried" + where_;
  }

  /// Reports the first finding of each sort.
  void find(const char* sort, const std::string& finding) {
    if (told_.insert(sort).second) {
      found_.push_back(std::string(plugin::kind_name(declaration_.kind)) + " '" +
                       declaration_.name + "': " + finding);
    }
  }

  /// Checks that a new object can be made and has the declared defaults.
  bool check_start() {
    try {
      const auto object = plugins_.host().create<Component>(declaration_.kind, declaration_.name);
      for (const ParameterDeclaration& parameter : declaration_.parameters) {
        if (parameter.get(*object) != parameter.default_value) {
          find("default", "parameter '" + parameter.name +
                              "' of a new object is not what the declaration gives as default; "
                              "its constructor must always set the same");
        }
      }
      plugins_.completed(declaration_, options_.settings);
      return true;
    } catch (...) {
      find("start", "it cannot be made: " + base::what_was_thrown());
      return false;
    }
  }

  bool make_inputs() {
    try {
      for (int robot = 0; robot < inputs_.robots(); ++robot) {
        input_.push_back(inputs_.make(robot, random_));
        other_input_.push_back(inputs_.make(robot, random_));
      }
      return true;
    } catch (const std::exception& error) {
      find("input", error.what());
      return false;
    }
  }

  std::unique_ptr<Trial> make(const Settings& settings, const Input& input) const {
    return make_trial({plugins_, declaration_, settings, options_.elements, input});
  }

  /// The trial; none if the plugin refuses it, which is allowed.
  std::unique_ptr<Trial> try_to_make(const Settings& settings, const Input& input, bool as_given) {
    try {
      return make(settings, input);
    } catch (const Refused& refusal) {
      refusal_ = refusal.what();
    } catch (const plugin::PluginError& error) {
      if (as_given) {
        find("refusal", "it refuses " + in_words(settings) + ": " + error.what());
        refusal_ = error.what();
      }
    } catch (...) {
      find("equipped", "equipped() throws " + base::what_was_thrown() +
                           "; throw std::invalid_argument with a sentence for what does not fit");
    }
    return nullptr;
  }

  void try_variant(int variant) {
    const bool as_given = variant == 0;
    const Settings settings =
        as_given ? options_.settings : random_settings(declaration_, options_.settings, random_);
    bool tried = false;
    for (std::size_t robot = 0; robot < input_.size(); ++robot) {
      if (!as_given && (tried || robot > 2)) {
        break;  // one robot for each set of parameters is enough
      }
      const Input& input = input_[(robot + static_cast<std::size_t>(variant)) % input_.size()];
      auto trial = try_to_make(settings, input, as_given);
      if (!trial) {
        continue;
      }
      tried = true;
      if (as_given && !typical_) {
        typical_ = &input;
      }
      be_at(settings, input);
      compare_runs(settings, input, *trial,
                   other_input_[(robot + static_cast<std::size_t>(variant)) % input_.size()]);
    }
    if (as_given && !tried && told_.empty()) {
      const bool watches = plugin::is_of_world(declaration_.kind);
      find("nothing", std::string("it refused every ") + (watches ? "world" : "robot") +
                          " that it was offered, so it could not be tested: " + refusal_ +
                          "; give the checker " +
                          (watches ? "scenes and settings" : "robots and members") +
                          " that it accepts");
    }
  }

  /// The answers of a run from the start; none when it failed, which is reported.
  std::optional<Answers> run(Trial& trial, Trial* beside = nullptr) {
    Answers answers(trial.run_length());
    Answer ignored;
    std::size_t step = 0;
    try {
      reset(trial, kRunSeed);
      if (beside) {
        reset(*beside, kRunSeed + 1);
      }
      for (; step < answers.size(); ++step) {
        if (beside) {
          beside->step(step, ignored);
        }
        plugin::Call call({.step = step, .time_s = time_of(step), .doing = doing_.c_str()});
        call.start_clock();  // for process::Watchdog, if it is in use
        trial.step(step, answers[step]);
        Sketch sketch(Frame{});
        trial.object().sketch(sketch);
        look_at_process(call);
      }
      return answers;
    } catch (const Wrong& wrong) {
      find("answer", "in " + at(step) + " " + wrong.what() + where_);
    } catch (...) {
      find("throws", "in " + at(step) + " it throws: " + thrown_text() + where_);
    }
    return std::nullopt;
  }

  /// Whether two runs are equal; else reports the first difference after `finding`.
  bool same(const char* sort, const std::string& finding, const Answers& first,
            const std::optional<Answers>& second) {
    if (!second) {
      return false;  // reported already
    }
    if (const auto differs = first_difference(first, *second)) {
      find(sort, finding + *differs);
      return false;
    }
    return true;
  }

  std::optional<std::string> first_difference(const Answers& first, const Answers& second) const {
    for (std::size_t step = 0; step < first.size(); ++step) {
      if (const auto differs = difference(first[step], second[step])) {
        return ": in " + at(step) + " " + *differs + where_;
      }
    }
    return std::nullopt;
  }

  void compare_runs(const Settings& settings, const Input& input, Trial& one,
                    const Input& other_input) {
    const auto first = run(one);
    if (!first) {
      return;
    }
    // The first one still lives, so that their addresses differ.
    const auto two = try_to_make(settings, input, true);
    if (!two) {
      find("again",
           "a second object with the same parameters, on the same robot, is refused: " + refusal_);
      return;
    }
    if (!same("objects",
              "two objects answer the same input differently: it has state that all objects share "
              "(a static or a global), or uses a clock, an address or random numbers other than "
              "now.random()",
              *first, run(*two))) {
      return;
    }
    if (!resets(one, *first)) {
      return;
    }
    const Input mates_input = as_a_mate(other_input);
    for (const Input* of_another : {&other_input, &mates_input}) {
      const auto beside = try_to_make(settings, *of_another, false);
      if (!beside) {
        continue;
      }
      if (!same("shared",
                "it answers differently while another object of it works on something else: "
                "objects must not share state (a static or a global)",
                *first, run(one, beside.get()))) {
        return;
      }
    }
    if (&input == typical_ && !compare_neighbours(one, *first)) {
      return;
    }
    if (!compare_threads(settings, one, other_input, *first)) {
      return;
    }
    try {
      one.configure_again();
    } catch (...) {
      find("configured",
           "configured() fails when it is called once more: " + base::what_was_thrown() + where_);
      return;
    }
    if (same("configured", "after configured() was called once more it answers differently", *first,
             run(one))) {
      compare_successor(one, *two, *first);
    }
  }

  /// Checks that other plugins of the library, on the robots that this one perceives, make no
  /// difference: what they leave in a static would.
  bool compare_neighbours(Trial& one, const Answers& first) {
    const std::string near = declaration_.kind == PluginKind::sensor ? kFirstRobot : kFirstMate;
    for (const Declaration* const other : neighbours_of(declaration_, plugins_)) {
      const auto beside = make_neighbour_trial(*other, near, plugins_, options_.seed);
      if (beside && !same("shared",
                          "it answers differently while the " +
                              std::string(plugin::kind_name(other->kind)) + " '" + other->name +
                              "' of its library works on another robot: plugins must not share "
                              "state (a static or a global)",
                          first, run(one, beside.get()))) {
        return false;
      }
    }
    return true;
  }

  /// Whether an object that had these answers has them again.
  bool resets(Trial& one, const Answers& first) {
    return same("reset",
                "after reset() it answers the same input differently: reset() must forget what the "
                "last run left",
                first, run(one));
  }

  /// Checks that objects of two robots, each in its own thread, answer as they do alone. Measures
  /// and rules belong to no robot.
  bool compare_threads(const Settings& settings, Trial& one, const Input& other_input,
                       const Answers& first) {
    const bool is_asked_in_several = declaration_.may_share_threads &&
                                     !plugin::is_of_world(declaration_.kind) && in_threads_.empty();
    const auto other = is_asked_in_several ? try_to_make(settings, other_input, false) : nullptr;
    const auto second = other ? run(*other) : std::nullopt;
    if (!second) {
      return true;
    }
    if (!resets(*other, *second)) {
      return false;
    }
    const std::string finding =
        "it answers differently while another object of it works in another thread: objects must "
        "not share what they change, or it declares elsie::one_thread()";
    Answers ones(first.size()), others(second->size());
    std::latch begun(2);
    base::ThreadPool pool(2);
    try {
      pool.divide(2, 1, [&](const base::ThreadPool::Share& share) {
        begun.arrive_and_wait();  // neither thread does both
        run_quietly(share.first == 0 ? one : *other, share.first == 0 ? ones : others);
      });
    } catch (...) {
      in_threads_ = finding + ": it fails: " + base::what_was_thrown() + where_;
      return false;
    }
    for (const auto& [alone, beside] : {std::pair(&first, &ones), std::pair(&*second, &others)}) {
      if (const auto differs = first_difference(*alone, *beside)) {
        in_threads_ = finding + *differs;
        return false;
      }
    }
    return true;
  }

  /// A run without findings. Throws what the plugin throws.
  void run_quietly(Trial& trial, Answers& answers) const {
    plugin::Call all({.plugin = &declaration_.name, .doing = doing_.c_str()});
    trial.reset(kRunSeed);
    for (std::size_t step = 0; step < answers.size(); ++step) {
      plugin::Call call({.step = step, .time_s = time_of(step), .doing = doing_.c_str()});
      call.start_clock();
      trial.step(step, answers[step]);
    }
  }

  /// Checks that an object that replaces another in the middle of a run continues as that would
  /// have.
  void compare_successor(Trial& one, Trial& successor, const Answers& first) {
    const std::size_t middle = first.size() / 2;
    Answer answer;
    try {
      reset(one, kRunSeed);
      for (std::size_t step = 0; step < middle; ++step) {
        one.step(step, answer);
      }
      if (!successor.take_over(one)) {
        return;  // the class does not offer it
      }
      for (std::size_t step = middle; step < first.size(); ++step) {
        successor.step(step, answer);
        if (const auto differs = difference(first[step], answer)) {
          find("remembers",
               "an object that takes over in " + at(middle) +
                   " what remember() names continues differently: remember() must name everything "
                   "that outlives a step: in " +
                   at(step) + " " + *differs + where_);
          return;
        }
      }
    } catch (...) {
      find("remembers",
           "remember() fails, or what follows it: " + base::what_was_thrown() + where_);
    }
  }

  void check_memory() {
    if (!typical_ || !told_.empty()) {
      return;  // with wrong answers, further checks say little
    }
    be_at(options_.settings, *typical_);
    try {
      check_growth();
      check_leaks();
    } catch (const Wrong& wrong) {
      find("answer", "in a long run " + std::string(wrong.what()) + where_);
    } catch (...) {
      find("throws", "in a long run it throws: " + thrown_text() + where_);
    }
  }

  void check_growth() {
    const auto trial = make(options_.settings, *typical_);
    Answer answer;
    std::size_t step = 0;
    // Pictures take a long time.
    const bool sees = declaration_.kind == PluginKind::sensor &&
                      std::ranges::any_of(declaration_.produces.front().fields,
                                          [](const FieldDeclaration& field) {
                                            return field.type == FieldType::picture;
                                          });
    const std::size_t steps = static_cast<std::size_t>(options_.steps) / (sees ? 50 : 1) / 4;
    const std::size_t begun = memory_in_use();
    const auto walk = [&] {
      constexpr std::size_t kStepsBetweenLooks = 64;
      for (std::size_t i = 0; i < steps; ++i) {
        plugin::Call call({.step = step, .time_s = time_of(step), .doing = doing_.c_str()});
        call.start_clock();
        trial->step(step++, answer);
        if (step % kStepsBetweenLooks == 0 && memory_in_use() > begun + options_.memory_limit) {
          throw TooMuchMemory();
        }
      }
    };
    try {
      reset(*trial, kRunSeed);
      walk();  // fills what is filled once
      const double least = 512.0 + 0.5 * static_cast<double>(steps);
      // Vectors grow in leaps: doubling the number of steps is sure to see one.
      std::size_t before_growth = step;
      const double grown = steady_growth(least, [&] {
        before_growth = step;
        while (step < 2 * before_growth) {
          walk();
        }
      });
      if (grown > least) {
        find("grows", "its memory grows with the number of steps, by " + in_bytes(grown) + " in " +
                          std::to_string(step - before_growth) + " steps" + where_);
      }
    } catch (const TooMuchMemory&) {
      find("grows", "its memory grows with the number of steps: more than " +
                        in_bytes(static_cast<double>(options_.memory_limit)) + " in " +
                        std::to_string(step) + " steps" + where_);
    }
  }

  void check_leaks() {
    constexpr int kObjects = 40;
    const auto come_and_go = [&] {
      Answer answer;
      for (int i = 0; i < kObjects; ++i) {
        const auto trial = make(options_.settings, *typical_);
        reset(*trial, kRunSeed);
        for (std::size_t step = 0; step < 3; ++step) {
          trial->step(step, answer);
        }
      }
    };
    come_and_go();
    const double least = 8.0 * kObjects;
    const double left = steady_growth(least, come_and_go);
    if (left > least) {
      find("leaks", "its objects leave memory behind when they are destroyed: " +
                        in_bytes(left / kObjects) + " each" + where_);
    }
  }

  const Declaration& declaration_;
  const CheckOptions& options_;
  const Plugins& plugins_;
  Random random_;
  InputMaker inputs_;
  std::vector<Input> input_, other_input_;  // for each robot
  const Input* typical_ = nullptr;          // the first that the plugin accepts
  std::string refusal_;
  std::string where_;
  std::string doing_ = "while it was tried";  // for crash reports
  std::set<std::string> told_;
  std::vector<std::string> found_;
  std::string in_threads_;  // what was found in two threads: objects that share state do so anyway
};

}  // namespace

std::vector<std::string> check_plugin(PluginKind kind, const std::string& name,
                                      const CheckOptions& options, const Plugins& plugins) {
  return Checker(plugins.declaration(kind, name), options, plugins).findings();
}

}  // namespace elsie::testing
