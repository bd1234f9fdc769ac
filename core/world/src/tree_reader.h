// Fills a world with what the tree of its file says.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "elsie/api/declaration.h"
#include "elsie/world/error.h"
#include "elsie/world/files.h"
#include "elsie/world/markup.h"
#include "elsie/world/object_reader.h"
#include "elsie/world/vocabulary.h"

#include "reading.h"

namespace elsie::plugin {
class Host;
}

namespace elsie::world {

/// Where the vocabulary ends, at the use of a plugin, the plugin's declaration goes on. For one
/// reading.
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
  // What the attributes of an element say of declared parameters; see PluginUse.
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

  // The uses of plugins: use_reader.cpp. Those that read something return whether it is as its
  // element says.
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
