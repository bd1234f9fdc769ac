// A world in memory as the tree of a file, so that paths mean here what they mean there.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "elsie/world/description.h"
#include "elsie/world/markup.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// It has every element, with the attributes that differ from their defaults.
class WorldTree {
 public:
  /// What an element stands for.
  struct Meaning {
    const ElementSpec* spec = nullptr;  // none for an element that a plugin declares
    std::string path;                   // without a "/" at its end
    const Robot* robot = nullptr;
    const PluginUse* use = nullptr;
    std::optional<PluginKind> kind;  // of that plugin
    std::optional<std::size_t> nested;
    bool is_listed = false;  // then it says something even without attributes
  };

  explicit WorldTree(const World& world) : root_(make(vocabulary(), &world, {})) {}

  Element& root() { return root_; }
  /// `element` must have an Element::object.
  const Meaning& meaning(const Element& element) const { return meanings_[*element.object]; }

 private:
  Element make(const ElementSpec& spec, const void* object, Meaning meaning);
  void add_children(Element& element, const ElementSpec& spec, const void* object,
                    const Meaning& meaning);
  void add_declared(Element& element, const Meaning& meaning);

  std::vector<Meaning> meanings_;  // Element::object is the place in it
  Element root_;
};

}  // namespace elsie::world
