#include "repetition.h"

#include "elsie/base/number_text.h"
#include "elsie/process/shell_word.h"
#include "elsie/world/error.h"
#include "elsie/world/markup.h"

namespace elsie::server {

void Repetition::begin(std::string file, std::string text, std::uint64_t seed) {
  file_ = std::move(file);
  text_ = std::move(text);
  seed_ = seed;
  edits_.clear();
}

void Repetition::move(std::string file, std::string text) {
  file_ = std::move(file);
  text_ = std::move(text);
}

void Repetition::add(double time_s, double step_s, std::vector<std::string> edits) {
  edits_.push_back({time_s, step_s, std::move(edits)});
}

Json Repetition::command(const std::vector<std::string>& options) const {
  std::vector<std::string> words{"elsie", "run", file_.empty() ? "world.xml" : file_, "--seed",
                                 std::to_string(seed_)};
  for (std::size_t i = 0; i < edits_.size(); ++i) {
    const Together& now = edits_[i];
    std::size_t later = 0;  // the number of later edits before the same step
    while (i + later + 1 < edits_.size() && edits_[i + later + 1].time_s == now.time_s) {
      ++later;
    }
    // Edits with one time are made together; a slightly earlier time keeps earlier edits separate.
    const double earlier_s = 1e-3 * now.step_s * static_cast<double>(later);
    const std::string time = base::number_text(std::max(0.0, now.time_s - earlier_s)) + ":";
    for (const std::string& edit : now.edits) {
      words.insert(words.end(), {"--at", time + edit});
    }
  }
  words.insert(words.end(), options.begin(), options.end());
  bool is_saved = false;
  try {
    is_saved = !file_.empty() && world::read_text(file_) == text_;
  } catch (const world::WorldError&) {  // there is no such file
  }
  return {{"text", process::shell_line(words)},
          {"words", Json(std::vector<std::string>(words.begin() + 1, words.end()))},
          {"world", text_},
          {"saved", is_saved}};
}

}  // namespace elsie::server
