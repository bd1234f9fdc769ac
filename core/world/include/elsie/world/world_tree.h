// A world in memory as the tree of a file, so that paths have the same meaning in both.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "elsie/world/description.h"
#include "elsie/world/markup.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// The tree of a world: every element, with the attributes that differ from their defaults.
class WorldTree {
 public:
  /// The meaning of an element.
  struct Meaning {
    const ElementSpec* spec = nullptr;  // null for an element that a plugin declares
    std::string path;                   // without a "/" at its end
    const Robot* robot = nullptr;
    const PluginUse* use = nullptr;
    std::optional<PluginKind> kind;  // of that plugin
    std::optional<std::size_t> nested;
    bool is_listed = false;  // true: it has a meaning even without attributes
  };

  /// `as_text`: robots and the like are text in their group, which takes a tenth of the memory.
  explicit WorldTree(const World& world, bool as_text = false)
      : as_text_(as_text), root_(make(vocabulary(), &world, {})) {}

  Element& root() { return root_; }
  /// `element` must have an Element::object.
  const Meaning& meaning(const Element& element) const { return meanings_[*element.object]; }

 private:
  Element make(const ElementSpec& spec, const void* object, Meaning meaning);
  void add_children(Element& element, const ElementSpec& spec, const void* object,
                    const Meaning& meaning);
  void add_declared(Element& element, const Meaning& meaning);

  bool as_text_;
  std::vector<Meaning> meanings_;  // Element::object is an index into it
  Element root_;
};

}  // namespace elsie::world
