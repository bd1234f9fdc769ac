// elsie session: the other process of a window, which elsie::client starts.
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fcntl.h>

#include "elsie/server/server.h"

#include "command.h"
#include "environment.h"

namespace elsie::program {

void add_session_command(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand(
      "session", "Edit and run a world for a window, which starts this by itself");
  command->group("");  // not listed for users
  auto options = std::make_shared<PluginOptions>();
  options->add_to(*command);
  auto drafts = std::make_shared<std::vector<std::string>>();
  command
      ->add_option("--draft", *drafts,
                   "Source of a plugin, or script, that somebody is writing: it may be wrong; may "
                   "be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
  command->callback([&job, options, drafts] {
    job = [options, drafts] {
      // Programs that a plugin starts must not keep them open: the window would wait for those.
      for (const int each : {server::kMessages, server::kMemory}) {
        fcntl(each, F_SETFD, FD_CLOEXEC);
      }
      if (fcntl(server::kMessages, F_GETFD) < 0) {
        throw BadInput(
            "`elsie session` is for windows, which start it and talk to it\nstart `elsie-desktop`; "
            "a window of your own starts it by elsie::client (docs/internals/session.md)");
      }
      const auto plugins = watch_plugins(
          *options, std::vector<std::filesystem::path>(drafts->begin(), drafts->end()));
      std::vector<std::string> words = options->words();
      for (const std::string& draft : *drafts) words.insert(words.end(), {"--plugin", draft});
      server::Server(*plugins, {data_directories(), std::move(words)}).serve();
      return kSuccess;
    };
  });
}

}  // namespace elsie::program
