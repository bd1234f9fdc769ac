#include "run_templates.h"

#include <cstddef>
#include <utility>

#include "elsie/base/words.h"

namespace elsie::batch {
namespace {

constexpr std::size_t kMostTemplates = 64;

}  // namespace

std::shared_ptr<RunTemplate> RunTemplates::original_for(const Job& job) {
  if (options_.template_command.empty()) {
    return nullptr;
  }
  const std::pair key(job.libraries, job.repetition);
  auto place = originals_.find(key);
  if (place == originals_.end() && originals_.size() >= kMostTemplates) {
    return nullptr;
  }
  if (place == originals_.end() || place->second->is_gone()) {
    place =
        originals_
            .insert_or_assign(key, std::make_shared<RunTemplate>(options_.template_command, job))
            .first;
  }
  RunTemplate& original = *place->second;
  original.hear();
  if (const std::string why = original.take_refusal(); !why.empty() && options_.note) {
    options_.note("each run that needs these libraries starts a program of its own, because " +
                  why + ": " + base::joined(job.libraries, ", "));
  }
  return original.is_ready() || original.is_loading() ? place->second : nullptr;
}

}  // namespace elsie::batch
