// What a world's own text must say, so that with the templates of its robots it says what an edited
// tree says.
#pragma once

#include <string>

#include "elsie/editing/document.h"
#include "elsie/plugin/host.h"
#include "elsie/world/files.h"
#include "elsie/world/markup.h"

#include "meaning.h"

namespace elsie::editing {

/// The trees that were read from one text. Element::object is the same number for an element of
/// both; larger numbers are elements of templates.
struct Trees {
  Element raw;     // the text alone, with all ids
  Element merged;  // with the content of templates
};

/// Sorts elements that may occur only once in the order of the vocabulary; files may have any
/// order.
void put_in_order(Element& element, const ElementSpec& spec = world::vocabulary());

/// Finds the tree of a text from an edited tree with the content of templates.
///
/// In a robot with a template, an element is written only as far as it differs from the template's:
/// with its id and what it overrides, or with remove="true". What the text has already stays.
class OwnText {
 public:
  /// `edit`: the place of mistakes, and of attributes that are written for their defaults.
  OwnText(const plugin::Host& host, const world::Files& files, std::string edit)
      : host_(host), files_(files), edit_(std::move(edit)) {}

  /// The raw tree for `wanted`, which is `trees.merged` after an edit. Sets an attribute that
  /// `wanted` lacks and the template has to its default; throws WorldError if it has none.
  Element of(const Trees& trees, Element& wanted) const {
    return of(wanted, &trees.merged, &trees.raw, nullptr, Meaning::of_world());
  }

 private:
  /// `wanted` is `before` after the edit; `raw`: its element in the text; `base`: in the template.
  /// Each of these is null if there is none.
  Element of(Element& wanted, const Element* before, const Element* raw, const Element* base,
             const Meaning& meaning) const;
  void take_attributes(Element& wanted, const Element* raw, const Element* base,
                       const Meaning& meaning, Element& own) const;
  void override_children(Element& wanted, const Element* before, const Element* raw,
                         const Element& base, const Meaning& meaning, Element& own) const;
  /// Whether elements that a plugin declares differ from the template's, which they replace.
  bool replaces_declared(const Element& wanted, const Element& base, const Meaning& meaning) const;
  /// The content of the template of a robot.
  Element template_of(const Element& robot) const;

  const plugin::Host& host_;
  const world::Files& files_;
  std::string edit_;
};

/// Marks those default ids in a raw tree that its text must contain: those of `Names`, and those in
/// robots with templates, where an id decides whether an element overrides one of the template.
void give_ids(Element& raw, Names names);

}  // namespace elsie::editing
