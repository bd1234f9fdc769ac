// elsie schema: the XML schema of world files, for editors.
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "elsie/world/schema.h"

#include "command.h"
#include "environment.h"

void add_schema_command(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand(
      "schema", "Print the XML schema (XSD) of world files, with all plugins found");
  command->footer(
      "\nExample:\n  elsie schema > world.xsd\n"
      "  xmllint --noout --schema world.xsd worlds/clutter.xml\n");
  auto plugins = std::make_shared<PluginOptions>();
  plugins->add_to(*command);
  command->callback([&job, plugins] {
    job = [plugins] {
      std::cout << elsie::world::world_schema(load_plugins(*plugins));
      return kSuccess;
    };
  });
}
