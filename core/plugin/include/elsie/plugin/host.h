// The plugin host finds plugin libraries, checks them, loads them, and makes their objects.
//
//   elsie::plugin::Host host(elsie::plugin::default_search_path());
//   auto behavior = host.create<elsie::Behavior>(elsie::PluginKind::behavior, "wander");
//
// Four checks refuse a file with a sentence: its ELF note is read from the file (nothing is
// loaded); its ABI word is compared with the host's; the system loads it (all symbols bound at
// once, none visible to other libraries); its plugins' declarations are read and checked. A bad
// file does not affect the others. The host cannot protect itself from harmful static constructors
// in a library that passes the first two checks.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "elsie/api/declaration.h"
#include "elsie/plugin/report.h"
#include "elsie/plugin/search_path.h"

namespace elsie::plugin {

class Library;

/// Destroys a plugin's object, then releases its library.
struct Release {
  std::shared_ptr<const Library> library;  // none for plugins that are linked into the program

  void operator()(Component* object);
};

/// A plugin's object. It may outlive the host: its library stays loaded until the last object is
/// destroyed.
template <class T>
using Object = std::unique_ptr<T, Release>;

/// Copies a library, for a host whose files may be replaced or overwritten while they are in use:
/// the copy is loaded, and released once it is unloaded. Throws std::runtime_error with a sentence.
using MakeCopy = std::function<std::shared_ptr<const std::filesystem::path>(
    const std::filesystem::path& library)>;

/// Hosts are independent of each other except after renewed(). One thread loads and adds plugins;
/// several may call the const members.
class Host {
 public:
  /// A host with the plugins that are built into the core, and no others; see add().
  Host();
  /// Loads every plugin library in the directories. Of several plugins of one kind and name the
  /// first is used, in the order of directories and of the file names in each; the report warns of
  /// the others. Never throws because of a file; see report(). Without `copy`, files must not
  /// change while they are in use.
  explicit Host(std::vector<SearchDirectory> directories, MakeCopy copy = {});
  Host(Host&&) noexcept;
  Host& operator=(Host&&) noexcept;
  ~Host();

  /// A new host for what is in these directories now. It shares the libraries that have not changed
  /// since this host loaded them: find() gives the same declarations. A changed library is loaded
  /// again, and the old one stays loaded while this host or an object of it exists. If the new file
  /// is refused or missing, the new host uses the old library, and its report says so; a recompiled
  /// source counts as the same library. Added plugins are shared, too. Needs copies
  /// (build::private_copy()): without them, the system takes a file of the same path for the old
  /// one.
  Host renewed(std::vector<SearchDirectory> directories) const;

  /// The declaration of a plugin, or null. Valid as long as this host, or one renewed from it that
  /// shares the library.
  const Declaration* find(PluginKind kind, std::string_view name) const;
  /// All declarations of a kind, sorted by name.
  std::vector<const Declaration*> all(PluginKind kind) const;
  /// The library of a plugin; "" for a plugin that is linked into the program or does not exist.
  std::filesystem::path file_of(PluginKind kind, std::string_view name) const;
  /// A sentence that says why there is no such plugin: the nearest name, the directories searched,
  /// and the libraries refused there.
  std::string explain_missing(PluginKind kind, std::string_view name) const;

  /// Makes an object of a plugin with default parameters; apply_parameters() calls configured().
  /// T is Component or the kind's class (Sensor, Behavior, Coordinator, Measure, Drive). Throws
  /// PluginError when there is no such plugin or its class is not T, CreateError when its
  /// constructor throws.
  template <class T>
  Object<T> create(PluginKind kind, std::string_view name) const {
    Object<Component> object = create_component(kind, name);
    T* const wanted = dynamic_cast<T*>(object.get());
    if (!wanted) {
      refuse_class(kind, name);
    }
    object.release();
    return Object<T>(wanted, std::move(object.get_deleter()));
  }

  /// Adds a plugin that is linked into the program; see also elsie/testing/linked.h. Throws
  /// PluginError when its declaration has faults or its name is taken.
  void add(Declaration declaration);

  const Report& report() const;

 private:
  struct State;

  Object<Component> create_component(PluginKind kind, std::string_view name) const;
  [[noreturn]] void refuse_class(PluginKind kind, std::string_view name) const;

  std::unique_ptr<State> state_;
};

}  // namespace elsie::plugin
