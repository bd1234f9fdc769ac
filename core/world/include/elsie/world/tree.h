// The tree of a world file, as programs that edit the file need it: the steps from a text to a
// world, one by one.
//
//   tree_of_world()      the text as a tree: what a file says, with all ids
//   merge_templates()    with what templates say
//   apply_override()     with an edit
//   draw_layouts()       with what its layouts draw; see layouts.h
//   world_of_tree()      the world, checked, with its layouts drawn
//
// read_world() makes all these steps at once.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "elsie/world/error.h"
#include "elsie/world/markup.h"
#include "elsie/world/reader.h"

namespace elsie::world {

class Files;

/// The tree of the text of a world: its root element is checked, and its ids are complete. `spans`
/// gets the places of its elements, whose Element::object is their place in this list. Throws
/// WorldError if the text is not well-formed or has another root element.
Element tree_of_world(std::string_view text, const std::string& file,
                      std::vector<ElementSpan>* spans = nullptr);

/// Merges templates into all robots of a world.
///
/// The robot's attributes override the template's, and so do those of its body. Sensors and
/// behaviours are matched by id (default ids included): the same id overrides, a new one adds,
/// remove="true" removes. A coordinator of the same plugin overrides, another one replaces. The
/// content of a behaviour is merged likewise. Elements that a plugin declares replace the
/// template's elements of the same list. A template may have a template itself.
void merge_templates(Element& world, const plugin::Host& host, const Files& files,
                     Problems& problems);

/// Applies "PATH=VALUE", one of ReadOptions::overrides, to the tree of a world, whose ids are
/// complete. Elements that `@remove` removes are only marked, since numbers in later paths count
/// them, too.
///
/// `is_running`: the tree is that of what runs, in which defaults are not given: an attribute that
/// has its default may be taken away as well.
void apply_override(Element& world, const std::string& override, bool is_running,
                    Problems& problems);

/// Whether the path of an override leads to layouts, or to something in them.
bool is_about_layouts(const std::string& override);
/// The elements to which the path of an attribute leads, and the attribute's name. Throws
/// std::invalid_argument with a sentence that says what is there instead.
std::pair<std::vector<Element*>, std::string> elements_at(Element& world, const std::string& path);

/// What an override is about. All but `other` concern the tree before merge_templates().
enum class Concern {
  other,
  removed_robots,
  robots,     // it adds or replaces robots
  templates,  // it sets the templates of robots that are there
};
Concern concern_of(const std::string& override);

/// Removes the marked elements.
void remove_overridden(Element& world);

/// The world of a tree that templates and overrides have been applied to. Throws WorldError with
/// all problems, those that are there already included.
World world_of_tree(Element root, const std::string& file, const plugin::Host& host,
                    const Files& files, const ReadOptions& options, Problems& problems);

}  // namespace elsie::world
