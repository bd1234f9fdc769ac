#include "post_mortem.h"

#include <sys/wait.h>

#include "elsie/base/number_text.h"

namespace elsie::batch {
namespace {

using base::seconds_text;

/// " in step 50 (at 0.5 s)", or empty when the step is not known.
std::string in_step(const LastWords& words) {
  return words.step ? " in " + base::step_text(*words.step, words.time_s) : "";
}

/// "plugin 'wander' (id 'roam') of robot 'r1'", or "the process" when it is not known.
std::string culprit(const LastWords& words) {
  if (words.plugin.empty()) {
    return "the process";
  }
  return "plugin '" + words.plugin + "'" +
         (words.id.empty() || words.id == words.plugin ? "" : " (id '" + words.id + "')") +
         (words.robot.empty() ? "" : " of robot '" + words.robot + "'");
}

std::string hang_message(const WorkerEnd& end) {
  std::string message = "the run did not end within " + seconds_text(end.wall_limit_s) +
                        " on the clock and was ended";
  if (!end.words) {
    return message;
  }
  return message + (end.words->plugin.empty()
                        ? in_step(*end.words) + ", while no plugin was at work"
                        : ", while " + culprit(*end.words) + " was at work" + in_step(*end.words));
}

std::string crash_message(const LastWords& words, const std::optional<std::string>& signal) {
  if (signal && !words.plugin.empty()) {
    return culprit(words) + " crashed with " + *signal + in_step(words);
  }
  const std::string by_itself = words.plugin.empty() ? " ended by itself" : " ended the process";
  return culprit(words) +
         (signal ? " was ended by " + *signal : by_itself + " by exit() or a similar call") +
         in_step(words) +
         (signal == "SIGKILL" ? "; somebody killed it, or the system did so because memory ran out"
                              : "");
}

/// The signal that ended the worker, or the one that it reported before it ended.
std::optional<std::string> signal_of(const WorkerEnd& end, const LastWords& words) {
  return WIFSIGNALED(end.status) ? std::optional(signal_name(WTERMSIG(end.status)))
         : !words.signal.empty() ? std::optional(words.signal)
                                 : std::nullopt;
}

}  // namespace

RunRecord post_mortem(const WorkerEnd& end) {
  RunRecord record;
  const LastWords words = end.words.value_or(LastWords{});
  if (!words.plugin.empty()) {
    record.plugin = words.plugin;
  }
  if (!words.robot.empty()) {
    record.robot = words.robot;
  }
  record.step = words.step;
  const int exit_code = WIFEXITED(end.status) ? WEXITSTATUS(end.status) : -1;
  if (end.overdue) {
    record.state = RunState::hang;
    record.message = hang_message(end);
  } else if (WIFSIGNALED(end.status) || end.words) {
    record.state = RunState::crash;
    record.signal = signal_of(end, words);
    record.message = crash_message(words, record.signal);
  } else if (end.said_too_much) {
    record.message =
        "the results of the run are longer than " + std::to_string(kLongestAnswer >> 20U) + " MB";
  } else if (exit_code == 127 && end.said_nothing) {
    record.message = "the worker could not be started";
  } else {
    record.state = end.said_nothing ? RunState::crash : RunState::error;
    record.message = "the process ended with exit code " + std::to_string(exit_code) +
                     " before its run did" + (end.problem.empty() ? "" : ": " + end.problem);
  }
  return record;
}

}  // namespace elsie::batch
