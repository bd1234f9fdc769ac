#include "tree_reader.h"

#include <utility>

namespace elsie::world {

Reading TreeReader::read(const Element& root) {
  read_object(vocabulary(), root, &reading_.world);
  return std::move(reading_);
}

void TreeReader::begin(const Element& element) {
  if (element.incomplete) {
    mark_robot_incomplete();
  }
}

void TreeReader::end(const ElementSpec& spec, const Element& element, bool sound) {
  if (!sound && !spec.plugins) {
    reading_.unsound.emplace(element.where.file, element.where.line);
  }
}

void TreeReader::mention(const AttributeSpec& field, const Attribute& attribute,
                         const Element& element) {
  reading_.mentions.push_back(
      {field.refers_to, attribute.value, attribute.where, in_words(attribute, element)});
}

// The one that is being read.
void TreeReader::mark_robot_incomplete() {
  reading_.incomplete_robots.insert(reading_.world.robots.size() - 1);
}

}  // namespace elsie::world
