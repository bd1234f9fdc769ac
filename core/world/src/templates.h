// Robot templates: files whose content a robot element takes over and overrides.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "elsie/api/declaration.h"
#include "elsie/world/error.h"
#include "elsie/world/files.h"
#include "elsie/world/markup.h"

namespace elsie::plugin {
class Host;
}

namespace elsie::world {

class Templates {
 public:
  Templates(const plugin::Host& host, const Files& files, Problems& problems)
      : host_(host), files_(files), problems_(problems) {}

  /// Merges templates into all robots of the world.
  ///
  /// The robot's attributes override the template's, and so do those of its body. Sensors and
  /// behaviours are matched by id (default ids included): the same id overrides, a new one adds,
  /// remove="true" removes. A coordinator of the same plugin overrides, another one replaces. The
  /// content of a behaviour is merged likewise. Elements that a plugin declares replace the
  /// template's elements of the same list. A template may have a template itself.
  void merge_all(Element& world);
  /// The same of robots that have been given a template since.
  void merge_given(Element& world);

 private:
  void merge(Element& robot);
  const Element* load(const std::string& file, const Location& from);
  void overlay(Element& robot, const Element& base);
  void overlay_group(Element& holder, const Element& base);
  void overlay_only(Element& group, const Element& base);
  void overlay_use(PluginKind kind, Element& use, const Element& base);
  void overlay_list(Element& list, const Element& base);
  void drop_removals(Element& list);

  const plugin::Host& host_;
  const Files& files_;
  Problems& problems_;
  std::map<std::string, std::optional<Element>> loaded_;  // by absolute path; none: has problems
  std::vector<std::string> open_;                         // being loaded, outermost first
};

}  // namespace elsie::world
