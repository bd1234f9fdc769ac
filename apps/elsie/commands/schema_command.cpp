// elsie schema: the XML schemas of world and experiment files, for editors.
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "elsie/experiment/vocabulary.h"
#include "elsie/reference/schema.h"

#include "command.h"
#include "environment.h"
#include "streams.h"

namespace elsie::program {

void add_schema_command(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand(
      "schema", "Print the XML schema (XSD) of world or experiment files, with all plugins found");
  command->footer(
      "\nExamples:\n  elsie schema > world.xsd\n"
      "  xmllint --noout --schema world.xsd worlds/clutter.xml\n"
      "  elsie schema experiment > experiment.xsd\n");
  auto plugins = std::make_shared<PluginOptions>();
  auto kind = std::make_shared<std::string>("world");
  command->add_option("KIND", *kind, "world or experiment; default: world")
      ->check(CLI::IsMember({"world", "experiment"}));
  plugins->add_to(*command);
  command->callback([&job, plugins, kind] {
    job = [plugins, kind] {
      const plugin::Host host = load_plugins(*plugins);
      data_out() << (*kind == "world" ? reference::world_schema(host)
                                      : experiment::experiment_schema(host));
      return kSuccess;
    };
  });
}

}  // namespace elsie::program
