// A coordinator that learns from rewards, and returns values that cannot be used.
#include <string>
#include <vector>

#include <elsie/api/coordinator.h>
#include <elsie/learning/reward_learner.h>

namespace {

using elsie::learning::Ending;
using elsie::learning::Values;
using elsie::learning::ValueTable;

class OddLearner final : public elsie::Coordinator, public elsie::learning::RewardLearner {
 public:
  std::string what = "nothing";
  elsie::FilePath values;
  bool untrained = false;

  elsie::Motion coordinate(std::span<elsie::Member>, const elsie::Perception&) override {
    return {};
  }
  void begin(const std::vector<std::string>&, Values, double, const elsie::Random&) override {}
  void learned(std::span<const double>) override {}
  Values finish(Ending) override {
    if (what == "uneven") return {{{"a", ValueTable(2, 1)}, {"b", ValueTable(3, 1)}}, {}};
    if (what == "remark") return {{{"a", ValueTable(2, 1)}}, {{"odd", "two\nlines"}}};
    return {};
  }
};

}  // namespace

ELSIE_COORDINATOR(OddLearner, "odd_learner", "Returns values that cannot be used",
                  elsie::parameter("what", &OddLearner::what, {.meaning = "is wrong with them"}),
                  elsie::parameter("values", &OddLearner::values, {.meaning = "never read"}),
                  elsie::parameter("untrained", &OddLearner::untrained,
                                   {.meaning = "makes no difference"}));
