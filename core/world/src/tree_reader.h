// Reads the tree of a world file into a World.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "elsie/api/declaration.h"
#include "elsie/world/description.h"
#include "elsie/world/error.h"
#include "elsie/world/files.h"
#include "elsie/world/markup.h"
#include "elsie/world/object_reader.h"
#include "elsie/world/vocabulary.h"

namespace elsie::plugin {
class Host;
}

namespace elsie::world {

/// An attribute that names a thing that must exist.
struct Mention {
  Reference kind = Reference::none;
  std::string id;
  Location where;
  std::string in_words;  // `team="red" of <robot>`
};

struct Reading {
  World world;
  std::vector<Mention> mentions;
  /// Elements with mistakes: their objects have defaults instead of the wrong values, which later
  /// checks must not judge.
  std::set<std::pair<std::string, int>> unsound;
  /// Robots, by their places in World::robots, with a template or a plugin that could not be found.
  std::set<std::size_t> incomplete_robots;

  bool sound(const Location& where) const { return !unsound.contains({where.file, where.line}); }
  bool sound_with_segments(const Robot& robot) const {
    return sound(robot.location) &&
           std::all_of(robot.segments.begin(), robot.segments.end(),
                       [&](const Segment& segment) { return sound(segment.location); });
  }
};

/// Elements of plugins are read by the plugins' declarations. For one reading.
class TreeReader : private ObjectReader {
 public:
  /// `check_plugins`: ReadOptions::check_plugins.
  TreeReader(const plugin::Host& host, const Files& files, bool check_plugins, Problems& problems)
      : ObjectReader(problems),
        host_(host),
        files_(files),
        check_plugins_(check_plugins),
        problems_(problems) {}

  Reading read(const Element& root);

 private:
  // The declared parameters of an element; see PluginUse.
  struct Values {
    std::map<std::string, ParameterValue>& parameters;
    std::map<std::string, FileName>& file_names;
  };

  bool read_use(const ElementSpec& spec, const Element& element, void* object) override;
  void begin(const Element& element) override;
  void end(const ElementSpec& spec, const Element& element, bool sound) override;
  void mention(const AttributeSpec& field, const Attribute& attribute,
               const Element& element) override;
  void mark_robot_incomplete();

  // Those that read something return whether the element had no mistakes.
  bool read_inside(const ElementSpec& spec, const Declaration& declaration, const Element& element,
                   void* object);
  bool read_element(const ElementDeclaration& declared, const Element& element, ElementUse& use);
  bool read_parameter(const ParameterDeclaration& parameter, const Element& element,
                      const Attribute& attribute, Values values);
  bool read_file(const ParameterDeclaration& parameter, const Element& element,
                 const Attribute& attribute, Values values);
  bool complete(const std::vector<ParameterDeclaration>& parameters, const Element& element,
                Values values);
  bool find_default(const ParameterDeclaration& parameter, const Element& element, Values values);
  bool try_out(const Declaration& declaration, const Element& element, const PluginUse& use);
  std::string explain_missing(PluginKind kind, const std::string& name) const;
  std::vector<std::string> holders_of(const std::string& element) const;
  std::string explain_child(const Declaration& declaration, const Element& child) const;

  const plugin::Host& host_;
  const Files& files_;
  const bool check_plugins_;
  Problems& problems_;
  Reading reading_;
};

}  // namespace elsie::world
