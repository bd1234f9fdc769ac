// elsie session: the other process of a window, which elsie::client starts.
#include <memory>

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
  command->callback([&job, options] {
    job = [options] {
      // Programs that a plugin starts must not keep them open: the window would wait for those.
      for (const int each : {server::kMessages, server::kMemory}) {
        fcntl(each, F_SETFD, FD_CLOEXEC);
      }
      if (fcntl(server::kMessages, F_GETFD) < 0) {
        throw BadInput(
            "`elsie session` is for windows, which start it and talk to it\nstart `elsie-desktop`; "
            "a window of your own starts it by elsie::client (docs/internals/session.md)");
      }
      const auto plugins = watch_plugins(*options);
      server::Server(*plugins, {data_directories(), options->words()}).serve();
      return kSuccess;
    };
  });
}

}  // namespace elsie::program
