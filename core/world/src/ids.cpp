#include "ids.h"

#include <map>
#include <set>
#include <string>

namespace elsie::world {
namespace {

// `numbered`: ids always have a number, that among all elements of the name.
void complete_ids(Element& list, bool numbered) {
  std::set<std::string> taken;
  for (const Element& child : list.children) {
    if (const Attribute* id = child.find("id")) {
      taken.insert(id->value);
    }
  }
  std::map<std::string, int> count;
  for (Element& child : list.children) {
    const bool named = child.find("id") != nullptr;
    int number = named && !numbered ? 0 : ++count[child.name];
    if (named) {
      continue;
    }
    const auto name = [&] {
      return number == 1 && !numbered ? child.name : child.name + "_" + std::to_string(number);
    };
    while (!taken.insert(name()).second) {
      ++number;
    }
    child.set("id", name(), child.where);
  }
}

}  // namespace

void complete_robot_ids(Element& robot) {
  if (Element* segments = robot.child("segments")) {
    complete_ids(*segments, true);
  }
  for (const char* list : {"sensors", "behaviors", "coordinator"}) {
    if (Element* found = robot.child(list)) {
      complete_ids(*found, false);
    }
  }
  if (Element* behaviors = robot.child("behaviors")) {
    for (Element& holder : behaviors->children) {
      complete_robot_ids(holder);
    }
  }
}

void complete_world_ids(Element& world) {
  for (const char* list : {"obstacles", "resources", "chargers"}) {
    if (Element* found = world.child(list)) {
      complete_ids(*found, true);
    }
  }
  if (Element* measures = world.child("measures")) {
    complete_ids(*measures, false);
  }
  if (Element* robots = world.child("robots")) {
    for (Element& robot : robots->children) {
      complete_robot_ids(robot);
    }
  }
}

}  // namespace elsie::world
