// Reference pages made from vocabularies and declarations.
#pragma once

#include <set>
#include <string>

#include "elsie/api/declaration.h"
#include "elsie/plugin/host.h"
#include "elsie/world/vocabulary.h"

namespace elsie::reference {

/// The vocabulary of world files, in Markdown: every element with its attributes.
std::string world_reference();

/// The elements and attributes of another kind of file, in Markdown, without a title.
std::string vocabulary_reference(const world::ElementSpec& root);

/// The elements of a vocabulary that have this name, in Markdown, each with the path to it and with
/// what it holds; "" if there are none.
std::string element_reference(const world::ElementSpec& root, const std::string& name);
/// Adds the names for element_reference().
void list_elements(const world::ElementSpec& root, std::set<std::string>& names);

/// A plugin's declaration in Markdown: what it does, its parameters, the elements inside of its own
/// with their defaults, whether it holds behaviours, its readings and events. Without headings, so
/// that it fits anywhere in a page.
std::string plugin_declaration(const Declaration& declaration);

/// The same as a page with the plugin's name as its title.
std::string plugin_reference(const Declaration& declaration);

/// All events, in Markdown, without headings: those of the simulator, then those that the plugins
/// of `host` declare.
std::string events_reference(const plugin::Host& host);

}  // namespace elsie::reference
