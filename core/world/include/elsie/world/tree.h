// The tree of a world file, for programs that edit the file: the single steps from a text to a
// world.
//
//   tree_of_world()      the text as a tree: the content of the file, with all ids
//   merge_templates()    adds the content of templates
//   apply_edit()     applies an edit
//   draw_layouts()       replaces layouts by what they draw; see layouts.h
//   world_of_tree()      the checked world, with its layouts drawn
//
// read_world() performs all these steps.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "elsie/world/error.h"
#include "elsie/world/markup.h"
#include "elsie/world/reader.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

class Files;

/// The tree of the text of a world, with a checked root element and complete ids. `spans` receives
/// the places of the elements; Element::object is an element's index in this list. Throws
/// WorldError if the text is not well-formed or has another root element.
Element tree_of_world(std::string_view text, const std::string& file,
                      std::vector<ElementSpan>* spans = nullptr);

/// Gives default ids to the members of lists that may have an id but have none, to any depth.
/// `spec` describes `element`. A plugin's element gets the plugin's name, the next one of that name
/// gets the name with _2, and so on. Other elements always get a number. Ids in use are skipped.
void complete_ids(Element& element, const ElementSpec& spec = vocabulary());

/// Merges templates into all robots of a world.
///
/// The attributes of the robot and of its body override those of the template. Sensors and
/// behaviours are matched by id (default ids included): the same id overrides, a new id adds,
/// remove="true" removes. A coordinator of the same plugin overrides the template's; a coordinator
/// of another plugin replaces it. The content of a behaviour is merged in the same way. Elements
/// that a plugin declares replace the template's elements of the same list. Templates may nest.
void merge_templates(Element& world, const plugin::Host& host, const Files& files,
                     Problems& problems);

/// Applies "PATH=VALUE", one of ReadOptions::edits, to the tree of a world with complete ids.
/// `@remove` only marks elements as removed, because numbers in later paths still count them.
///
/// `is_running`: the tree is that of a running world, which does not contain default values; so an
/// attribute that has its default may be removed, too.
void apply_edit(Element& world, const std::string& edit, bool is_running, Problems& problems);

/// Where the "=" between the path and the value of an edit stands: the first one outside brackets.
/// npos: there is none.
std::size_t end_of_path(std::string_view edit);
/// Whether the path of an edit leads to layouts, or to something in them.
bool is_about_layouts(const std::string& edit);
/// The elements to which the path of an attribute leads, and the attribute's name. Throws
/// std::invalid_argument with a sentence that says what is there instead.
std::pair<std::vector<Element*>, std::string> elements_at(Element& world, const std::string& path);

/// The subject of an edit. All but `other` concern the tree before merge_templates().
enum class Concern {
  other,
  removed_robots,
  robots,     // it adds or replaces robots
  templates,  // it sets the templates of existing robots
};
Concern concern_of(const std::string& edit);

/// Removes the marked elements.
void remove_overridden(Element& world);

/// The world of a tree to which templates and edits have been applied. Throws WorldError with
/// all problems, including those found earlier. `before`: the running world that becomes this one.
World world_of_tree(Element root, const std::string& file, const plugin::Host& host,
                    const Files& files, const ReadOptions& options, Problems& problems,
                    const World* before = nullptr);

}  // namespace elsie::world
