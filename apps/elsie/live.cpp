#include "live.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "elsie/base/number_text.h"
#include "elsie/base/words.h"
#include "elsie/simulation/simulation.h"

#include "interrupts.h"
#include "status_line.h"
#include "streams.h"

namespace elsie::program {

using simulation::Replacement;
using simulation::Simulation;

void Pacer::started(const Simulation&) { start_ = std::chrono::steady_clock::now(); }

void Pacer::stepped(const Simulation& simulation) {
  using Seconds = std::chrono::duration<double>;
  constexpr Seconds kNap{0.05};  // short, so that an interrupt is noticed soon
  const Seconds due(simulation.time_s() / speed_);
  for (;;) {
    const Seconds left = due - (std::chrono::steady_clock::now() - start_);
    if (left <= Seconds::zero() || InterruptGuard::is_interrupted()) {
      return;
    }
    std::this_thread::sleep_for(std::min(left, kNap));
  }
}

namespace {

std::string joined(const std::vector<std::filesystem::path>& files) {
  return base::joined({files.begin(), files.end()});
}

/// "wander of r1, r2, with what it remembers" for each plugin.
std::string replaced_text(const Replacement& replacement) {
  std::string text;
  std::vector<std::string> plugins;
  for (const Replacement::Object& object : replacement.objects) {
    if (std::find(plugins.begin(), plugins.end(), object.plugin) != plugins.end()) {
      continue;
    }
    plugins.push_back(object.plugin);
    std::string robots;
    for (const Replacement::Object& other : replacement.objects) {
      if (other.plugin == object.plugin && !robots.ends_with("'" + other.robot + "'")) {
        robots += (robots.empty() ? "'" : ", '") + other.robot + "'";
      }
    }
    text += (text.empty() ? "" : "; ") + object.plugin + " of " + robots +
            (object.remembers ? ", with what it remembers" : ", from its start");
  }
  return text.empty() ? "no robot has a plugin of it" : "new: " + text;
}

}  // namespace

void replace_what_changed(build::Watch& watch, Simulation& simulation, bool quiet) {
  auto renewal = watch.take();
  if (!renewal) {
    return;
  }
  wipe_status();  // the progress bar
  const std::string at = "elsie: at " + base::fixed_text(simulation.time_s(), 2) + " s, ";
  for (const std::string& problem : renewal->problems) {
    std::cerr << problem << '\n';  // the compiler's, perhaps in colours
  }
  if (!renewal->kept.empty()) {
    err() << at << joined(renewal->kept) << ": the old version stays in use\n";
  }
  if (!renewal->restored.empty() && !quiet) {
    err() << at << joined(renewal->restored) << ": again the version in use\n";
  }
  if (!renewal->host) {
    return;
  }
  const std::string files = joined(renewal->files);
  try {
    const Replacement replacement = simulation.replace_plugins(*renewal->host);
    watch.accept(*std::move(renewal));
    for (const std::string& note : replacement.notes) {
      err() << "elsie: " << note << '\n';
    }
    if (!quiet) {
      err() << at << files << ": " << replaced_text(replacement) << '\n';
    }
  } catch (const simulation::ReplacementRefused& refused) {
    err() << at << files << " cannot be used: " << refused.what()
          << "\nthe old version stays in use\n";
  }
}

}  // namespace elsie::program
