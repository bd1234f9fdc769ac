// Edits at given times, once or again and again.
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <elsie/api/rule.h>

namespace {

struct Entry {
  double time = 0.0;
  double every = 0.0;
  std::string path;
  std::string value;
};

class Timetable final : public elsie::Rule {
 public:
  std::vector<Entry> entries;

  void configured() override {
    if (entries.empty()) throw std::invalid_argument("it is empty; expected <edit> inside it");
    made_.resize(entries.size());
  }
  void reset(elsie::Random&) override { made_.assign(entries.size(), 0); }

  void apply(const elsie::Observation& now, elsie::WorldChanges& world) override {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const Entry& entry = entries[i];
      const double since_s = now.time_s - entry.time + 1e-6 * now.step_s;
      if (since_s < 0.0) continue;
      const double due = entry.every > 0.0 ? 1.0 + std::floor(since_s / entry.every) : 1.0;
      if (due > made_[i]) world.set(entry.path, entry.value);  // once in a step
      made_[i] = due;
    }
  }

 private:
  std::vector<double> made_;  // how often each was due
};

}  // namespace

ELSIE_RULE(
    Timetable, "timetable", "Edits the world at given times",
    elsie::elements(
        &Timetable::entries,
        elsie::element<Entry>(
            "edit", "an edit; those of one time are made together",
            elsie::parameter("time", &Entry::time,
                             {.unit = "s", .min = 0, .meaning = "when it is made first"}),
            elsie::parameter("every", &Entry::every,
                             {.unit = "s", .min = 0, .meaning = "and then so often; 0: only once"}),
            elsie::parameter("path", &Entry::path,
                             {.meaning = "what is edited, as in `elsie run --set`",
                              .required = true}),
            elsie::parameter(
                "value", &Entry::value,
                {.meaning = "of the attribute at the end of the path, or the markup of "
                            "an element",
                 .required = true}))));
