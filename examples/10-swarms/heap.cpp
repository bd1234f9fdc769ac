// Counts the pucks of the largest cluster, and ends the run when it is large enough.
#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <elsie/api/rule.h>

class Heap final : public elsie::Rule {
 public:
  double gap = 0.12;  // m
  int enough = 7;

  void apply(const elsie::Observation& now, elsie::WorldChanges& world) override {
    if (!now.decided) return;
    std::vector<elsie::Pose> left;
    for (const elsie::ObservedObstacle& each : now.obstacles) {
      if (each.kind == elsie::ObservedObstacle::Kind::resource) left.push_back(each.pose);
    }
    largest_ = 0;
    while (!left.empty()) {
      std::vector<elsie::Pose> cluster{left.back()};
      left.pop_back();
      for (std::size_t i = 0; i < cluster.size(); ++i) {
        const auto is_near = [&](const elsie::Pose& each) {
          return elsie::distance(each, cluster[i]) < gap;
        };
        const auto near = std::stable_partition(left.begin(), left.end(), std::not_fn(is_near));
        cluster.insert(cluster.end(), near, left.end());
        left.erase(near, left.end());
      }
      largest_ = std::max(largest_, static_cast<int>(cluster.size()));
    }
    if (largest_ >= enough) {
      world.succeed(std::to_string(largest_) + " pucks are in one cluster");
    }
  }

  int largest_ = 0;
};

ELSIE_RULE(Heap, "heap", "Ends the run when enough pucks are in one cluster",
           elsie::parameter("gap", &Heap::gap,
                            {.unit = "m", .above = 0, .meaning = "the largest from puck to puck"}),
           elsie::parameter("enough", &Heap::enough, {.min = 1, .meaning = "pucks"}),
           elsie::publishes("largest", &Heap::largest_, {.meaning = "pucks of a cluster"}));
