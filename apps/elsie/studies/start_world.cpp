#include "start_world.h"

#include <filesystem>
#include <system_error>
#include <vector>

#include "elsie/base/number_text.h"
#include "elsie/editing/document.h"
#include "elsie/files/write_whole.h"
#include "elsie/process/shell_word.h"
#include "elsie/world/error.h"
#include "elsie/world/markup.h"

#include "arguments.h"
#include "command.h"
#include "output_files.h"

namespace elsie::program {
namespace {

/// s
double own_time_limit(const RunToWrite& run) {
  const world::Element root = world::parse_markup(run.world_text, run.world_file);
  const world::Element* const limits = root.child("limits");
  const world::Attribute* const time = limits ? limits->find("time") : nullptr;
  return time ? parse_number(time->value).value_or(0.0) : world::Limits{}.time;
}

struct StartText {
  std::string text;
  double time_limit_s;
};

StartText text_from(const RunToWrite& run, const plugin::Host& host,
                    const world::ReadOptions& reading, const std::filesystem::path& folder) {
  try {
    const editing::Document document(run.world_text, run.world_file, host, reading);
    return {document.text_for(folder.string()), document.world().limits.time};
  } catch (const world::WorldError&) {
    return {run.world_text, own_time_limit(run)};
  }
}

}  // namespace

void require_new_world(const std::string& file) {
  require_writable(file, "--world");
  if (std::filesystem::exists(file)) {
    throw BadInput("--world: '" + file + "' is there already; expected a new file");
  }
}

StartWorld write_start_world(const RunToWrite& run, const plugin::Host& host,
                             const world::ReadOptions& reading, const PluginOptions& plugins,
                             const std::string& file) {
  const auto [text, time_limit_s] =
      text_from(run, host, reading, std::filesystem::path(file).parent_path());
  if (const int problem = files::write_whole(file, text)) {
    throw BadInput("--world: '" + file +
                   "' cannot be written: " + std::generic_category().message(problem));
  }
  std::vector<std::string> words{"elsie", "run", file, "--seed", std::to_string(run.seed)};
  StartWorld written;
  if (run.time_limit_s > 0.0 && run.time_limit_s != time_limit_s) {
    written.duration_s = run.time_limit_s;
    words.insert(words.end(), {"--duration", base::number_text(run.time_limit_s)});
  }
  const std::vector<std::string> of_plugins = plugins.words();
  words.insert(words.end(), of_plugins.begin(), of_plugins.end());
  written.command = process::shell_line(words);
  return written;
}

}  // namespace elsie::program
