// The cost of rays in a batch against single rays, in one arena of robots and obstacles, with both
// engines: a lidar's rays from one point, level and tilted, short and long, with and without what
// they hit. Prints a table in Markdown.
//
//   rays [--repeats N]
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <numbers>
#include <string>
#include <vector>

#include "elsie/base/random.h"
#include "elsie/physics/engine.h"
#include "elsie/world/parts.h"

#include "statistics.h"

namespace {

using namespace elsie;

constexpr int kScans = 300;
constexpr std::size_t kSelf = 0;

struct Lidar {
  std::size_t rays = 360;
  double pitch_rad = 0.0;
  double range_m = 4.0;
};

std::unique_ptr<physics::Engine> crowded(const std::string& name) {
  world::Arena arena;
  arena.length = arena.width = 20.0;
  world::Physics physics;
  physics.engine = name;
  auto engine = physics::make_engine(arena, physics);
  Random random(1);
  const auto place = [&] { return random.uniform(-10.0, 10.0); };
  for (int i = 0; i < 100; ++i) {
    engine->add_robot(world::plan_of(world::RobotBody(), {}),
                      {place(), place(), random.uniform(-3, 3)});
  }
  for (int i = 0; i < 100; ++i) {
    world::Obstacle box;
    box.x = place();
    box.y = place();
    box.heading_deg = random.uniform(-180, 180);
    engine->add_obstacle(box);
  }
  return engine;
}

struct Costs {
  std::vector<double> single, batch, surfaces;  // us for a ray
};

class Scanner {
 public:
  Scanner(const physics::Engine& engine, const Lidar& lidar) : engine_(engine), lidar_(lidar) {
    const double apart = 2.0 * std::numbers::pi / static_cast<double>(lidar.rays);
    for (std::size_t i = 0; i < lidar.rays; ++i) {
      from_.push_back(Frame::turned({0.03, 0.0, 0.07},
                                    std::numbers::pi - apart * static_cast<double>(i),
                                    lidar.pitch_rad));
    }
    for (const Frame& frame : from_) rays_.push_back({&frame, lidar.range_m});
    surfaces_.resize(rays_.size());
  }

  void measure(Costs& costs) {
    costs.single.push_back(cost([&](const Frame& robot) {
      for (RayQuery& ray : rays_) {
        const auto hit = engine_.cast_ray(robot.point(ray.from->origin),
                                          robot.direction(ray.from->forward), ray.max_range_m, kSelf);
        ray.distance_m = hit ? hit->distance : RayQuery::kNothing;
      }
    }));
    costs.batch.push_back(
        cost([&](const Frame& robot) { engine_.cast_rays(robot, rays_, kSelf); }));
    costs.surfaces.push_back(
        cost([&](const Frame& robot) { engine_.cast_rays(robot, rays_, surfaces_, kSelf); }));
  }

 private:
  template <class Cast>
  double cost(Cast cast) const {
    const std::clock_t start = std::clock();
    for (int i = 0; i < kScans; ++i) {
      const double there = -8.0 + 16.0 * i / kScans;
      cast(Frame::turned({there, 0.3 * there, 0.0}, 0.1 * i, 0.0));
    }
    return 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / kScans /
           static_cast<double>(rays_.size());
  }

  const physics::Engine& engine_;
  Lidar lidar_;
  std::vector<Frame> from_;
  std::vector<RayQuery> rays_;
  std::vector<Surface> surfaces_;
};

void print(const char* engine, const Lidar& lidar, const Costs& costs) {
  std::vector<double> cheaper, dearer;
  for (std::size_t i = 0; i < costs.single.size(); ++i) {
    cheaper.push_back(costs.single[i] / costs.batch[i]);
    dearer.push_back(costs.surfaces[i] / costs.batch[i]);
  }
  std::printf("| %s | %zu | %.0f | %.0f | %.3f | %.1f | %.2f |\n", engine, lidar.rays,
              degrees(lidar.pitch_rad), lidar.range_m, bench::median(costs.single),
              bench::median(cheaper), bench::median(dearer));
}

}  // namespace

int main(int argc, char** argv) {
  const int repeats = argc == 3 && std::string(argv[1]) == "--repeats" ? std::atoi(argv[2]) : 7;
  if ((argc != 1 && argc != 3) || repeats < 1) {
    std::fprintf(stderr, "usage: rays [--repeats N]\n");
    return EXIT_FAILURE;
  }
  try {
    std::printf(
        "| engine | rays | pitch, deg | range, m | us for a single ray | single / batch | batch with "
        "surfaces / without |\n|---|---|---|---|---|---|---|\n");
    for (const char* const name : {"ode", "planar"}) {
      const auto engine = crowded(name);
      for (const Lidar& lidar :
           {Lidar{8, 0, 1}, Lidar{16, 0, 4}, Lidar{24, 0, 4}, Lidar{360, 0, 1}, Lidar{360, 0, 4},
            Lidar{360, 0, 12}, Lidar{360, 0.1, 4}, Lidar{10000, 0, 12}}) {
        Scanner scanner(*engine, lidar);
        Costs costs;
        for (int i = 0; i < repeats; ++i) scanner.measure(costs);
        print(name, lidar, costs);
      }
    }
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "rays: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
