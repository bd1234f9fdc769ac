// What a robot-step costs from one robot to a hundred thousand: whole simulations (sensors,
// behaviour, coordinator, physics) on both engines, compared with Enki and with bare loops on ODE
// and in the plane.
//
//   growth [--repeats N] [--most N] [--picture FILE]
//
// World: arena_of_robots.h, of which all get the same poses, boxes and rule. Everything is run in
// turn, all sizes too, and ratios are taken round by round, because machines drift. Prints tables
// in Markdown, and draws them.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "elsie/base/number_text.h"
#include "elsie/picture/plot.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/simulation.h"

#include "arena_of_robots.h"
#include "bare_enki.h"
#include "bare_ode.h"
#include "bare_plane.h"
#include "statistics.h"

namespace {

using elsie::bench::median;

constexpr int kWarmUp = 300;               // steps: the robots spread, and meet
constexpr int kStepsInAll = 200'000;       // robot-steps in one measurement
constexpr int kFewest = 20, kMost = 3000;  // steps in one measurement
/// Up to so many robots each measurement has a new simulation. Left running, the bare loop on ODE
/// was seen to become unstable after minutes of simulated time.
constexpr int kRenewed = 100;
constexpr int kStandard = 100;  // robots: costs are compared with those of this size

/// A simulation that is measured, of each size.
struct Side {
  const char* name;
  int most;  // robots
  /// A new simulation, as its step.
  std::function<std::function<void()>(const elsie::world::World&)> make;
};

template <class Simulated, class... Arguments>
std::function<void()> stepping(Arguments&&... arguments) {
  const auto made = std::make_shared<Simulated>(std::forward<Arguments>(arguments)...);
  return [made] { made->step(); };
}

std::vector<Side> sides_of(const elsie::plugin::Host& host) {
  namespace bench = elsie::bench;
  const auto elsie_on = [&host](const char* engine) {
    return [&host, engine](elsie::world::World arena) {
      arena.physics.engine = engine;
      return stepping<elsie::simulation::Simulation>(std::move(arena), host);
    };
  };
  std::vector<double> azimuths;
  for (const double azimuth : bench::kBeamAzimuths_deg) azimuths.push_back(elsie::radians(azimuth));
  return {{"Elsie, planar", 100'000, elsie_on("planar")},
          {"bare loop in the plane", 100'000,
           [](const auto& arena) {
             return stepping<bench::BarePlane>(bench::poses_of(arena), arena.obstacles,
                                               arena.physics, arena.arena);
           }},
          // Its cost grows with the square of the robots.
          {"Enki", 1'000,
           [](const auto& arena) {
             return stepping<bench::BareEnki>(bench::poses_of(arena), arena.obstacles,
                                              arena.physics, arena.arena, bench::steer);
           }},
          {"Elsie, ODE", 10'000, elsie_on("ode")},
          // As above: a ray of ODE's looks at all bodies.
          {"bare loop on ODE", 1'000, [azimuths](const auto& arena) {
             return stepping<bench::BareOde>(bench::poses_of(arena), arena.obstacles, azimuths,
                                             arena.physics, arena.arena, bench::steer);
           }}};
}
enum Place : std::size_t { kPlanar, kPlane, kEnki, kOde, kBareOde };

/// The robot-steps per second of one side and size, a rate for each round.
class Measured {
 public:
  Measured(const Side& side, int robots) : side_(side), robots_(robots) {}

  void measure() {
    if (!step_ || robots_ <= kRenewed) {
      step_ = side_.make(elsie::bench::arena_of_robots(robots_));
      for (int i = 0; i < kWarmUp; ++i) step_();
    }
    const int steps = std::clamp(kStepsInAll / robots_, kFewest, kMost);
    const std::clock_t start = std::clock();  // processor time: others may be at work
    for (int i = 0; i < steps; ++i) step_();
    rates.push_back(static_cast<double>(steps) * robots_ /
                    (static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC));
  }

  std::vector<double> rates;

 private:
  const Side& side_;
  int robots_;
  std::function<void()> step_;
};

struct Size {
  int robots;
  std::vector<std::optional<Measured>> sides;  // none: it has too many robots for this one
};

/// "1.52 | 1.49 to 1.60" of one rate as a multiple of another; "- | -" if one of them is missing.
std::string ratio(const std::optional<Measured>& of, const std::optional<Measured>& to) {
  if (!of || !to) return "- | -";
  std::vector<double> ratios;
  for (std::size_t i = 0; i < of->rates.size(); ++i) {
    ratios.push_back(of->rates[i] / to->rates[i]);
  }
  const auto [low, high] = std::minmax_element(ratios.begin(), ratios.end());
  char text[64];
  std::snprintf(text, sizeof(text), "%.2f | %.2f to %.2f", median(ratios), *low, *high);
  return text;
}

void print_rates(const std::vector<Side>& sides, const std::vector<Size>& sizes) {
  std::string heading = "| robots |", line = "|---|";
  for (const Side& side : sides) {
    heading += std::string(" ") + side.name + " |";
    line += "---|";
  }
  std::printf("Robot-steps per second, median:\n\n%s\n%s\n", heading.c_str(), line.c_str());
  for (const Size& size : sizes) {
    std::printf("| %d |", size.robots);
    for (const auto& side : size.sides) {
      side ? std::printf(" %.0f |", median(side->rates)) : std::printf(" - |");
    }
    std::printf("\n");
  }
}

void print_ratios(const std::vector<Size>& sizes) {
  std::printf(
      "\nIn the plane, round by round:\n\n| robots | times Enki | spread | cost in bare loops | "
      "spread | cost of a robot-step, against %d robots | spread "
      "|\n|---|---|---|---|---|---|---|\n",
      kStandard);
  const auto standard = std::find_if(sizes.begin(), sizes.end(),
                                     [](const Size& size) { return size.robots == kStandard; });
  const auto to_standard = [&](const Size& size, Place place) {
    return standard == sizes.end() ? "- | -" : ratio(standard->sides[place], size.sides[place]);
  };
  for (const Size& size : sizes) {
    std::printf("| %d | %s | %s | %s |\n", size.robots,
                ratio(size.sides[kPlanar], size.sides[kEnki]).c_str(),
                ratio(size.sides[kPlane], size.sides[kPlanar]).c_str(),
                to_standard(size, kPlanar).c_str());
  }
  std::printf(
      "\nOn ODE:\n\n| robots | times the bare loop | spread | cost of a robot-step, against %d "
      "robots | spread |\n|---|---|---|---|---|\n",
      kStandard);
  for (const Size& size : sizes) {
    if (!size.sides[kOde]) continue;
    std::printf("| %d | %s | %s |\n", size.robots,
                ratio(size.sides[kOde], size.sides[kBareOde]).c_str(),
                to_standard(size, kOde).c_str());
  }
}

void draw(const std::vector<Side>& sides, const std::vector<Size>& sizes, const std::string& file) {
  elsie::picture::LineChart chart;
  chart.x = {.label = "robots", .logarithmic = true};
  chart.y = {.label = "robot-steps per second", .logarithmic = true};
  for (std::size_t i = 0; i < sides.size(); ++i) {
    elsie::picture::Series series{.name = sides[i].name, .marked = true, .bars = true};
    for (const Size& size : sizes) {
      if (!size.sides[i]) continue;
      const std::vector<double>& rates = size.sides[i]->rates;
      const auto [low, high] = std::minmax_element(rates.begin(), rates.end());
      series.points.push_back({static_cast<double>(size.robots), median(rates)});
      series.spread.push_back({*low, *high});
    }
    chart.series.push_back(std::move(series));
  }
  elsie::picture::save_page({.rows = {{.panels = {chart}, .aspect = 0.6}}}, file, {900, 0});
}

}  // namespace

int main(int argc, char** argv) try {
  int repeats = 15, most = 100'000;
  std::string picture;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string option = argv[i];
    if (option == "--repeats") {
      repeats = std::atoi(argv[i + 1]);
    } else if (option == "--most") {
      most = std::atoi(argv[i + 1]);
    } else if (option == "--picture") {
      picture = argv[i + 1];
    } else {
      repeats = 0;
    }
  }
  if (argc % 2 == 0 || repeats < 1 || most < 1) {
    std::fprintf(stderr, "usage: growth [--repeats N] [--most N] [--picture FILE]\n");
    return 2;
  }
  const elsie::plugin::Host host(elsie::plugin::default_search_path());
  const std::vector<Side> sides = sides_of(host);
  std::vector<Size> sizes;
  for (int robots = 1; robots <= most && robots <= sides[kPlanar].most; robots *= 10) {
    Size size{robots, {}};
    for (const Side& side : sides) {
      size.sides.emplace_back();
      if (robots <= side.most) size.sides.back().emplace(side, robots);
    }
    sizes.push_back(std::move(size));
  }
  for (int round = 0; round < repeats; ++round) {
    for (Size& size : sizes) {
      for (auto& side : size.sides) {
        if (side) side->measure();
      }
    }
  }
  print_rates(sides, sizes);
  print_ratios(sizes);
  if (!picture.empty()) draw(sides, sizes, picture);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "growth: %s\n", error.what());
  return 2;
}
