// elsie.World: the text of a world file, which is edited, with the plugins that it needs.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "elsie/editing/document.h"
#include "elsie/plugin/host.h"
#include "elsie/world/description.h"

#include "bindings.h"
#include "made.h"

namespace elsie::python {

/// Used with the GIL held.
class World : public Made {
 public:
  /// `file`: the name of the text in messages; other files are searched in its folder first. Throws
  /// world::WorldError.
  World(std::string text, std::string file, std::shared_ptr<const plugin::Host> host);
  /// The file, or the shipped world, of this name.
  static std::unique_ptr<World> open(const std::string& file,
                                     std::shared_ptr<const plugin::Host> host);

  const std::shared_ptr<const plugin::Host>& shared_host() const { return host_; }
  const std::string& text() const { return document_.text(); }
  const std::string& file() const { return document_.file(); }
  /// The world for seed 1.
  const world::World& description() const { return document_.world(); }
  /// The world for a run with this seed, time limit and edits ("PATH=VALUE", as of --set), as the
  /// program reads it. Its robots are shared with other descriptions until one changes them.
  /// Throws world::WorldError.
  world::World description(std::optional<std::uint64_t> seed,
                           std::optional<double> time_limit_s = {},
                           const std::vector<std::string>& edits = {}) const;

  /// Edits by paths, "PATH=VALUE": all of them or none. Throws world::WorldError.
  void edit(const std::vector<std::string>& edits) { document_.apply(edits); }
  std::string text_for(const std::string& folder) const { return document_.text_for(folder); }

 private:
  std::shared_ptr<const plugin::Host> host_;
  editing::Document document_;
};

/// The options with which all worlds are read.
world::ReadOptions reading_for(std::uint64_t seed);

}  // namespace elsie::python
