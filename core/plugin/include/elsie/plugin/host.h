// The plugin host: it finds plugin libraries, checks them, loads them, and makes their objects.
//
//   elsie::plugin::Host host(elsie::plugin::default_search_path());
//   auto behavior = host.create<elsie::Behavior>(elsie::PluginKind::behavior, "wander");
//
// A file passes through four gates, and is refused with a sentence at the first that it fails:
// its ELF note is read from the file (nothing is loaded); its ABI word is compared with the host's;
// the system loads it (all symbols bound at once, none visible to other libraries); its plugins'
// declarations are read and checked. No bad file keeps the others from being used. What no program
// can guard against is a well-formed plugin library whose static constructors do harm.
#pragma once

#include <filesystem>
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

/// Destroys a plugin's object, and lets go of its library afterwards.
struct Release {
  std::shared_ptr<const Library> library;  // none for plugins that are linked into the program

  void operator()(Component* object);
};

/// A plugin's object. It may outlive the host: its library stays until the last object is gone.
template <class T>
using Object = std::unique_ptr<T, Release>;

/// How libraries are loaded.
enum class Loading {
  in_place,  // from their files, which must stay as they are for as long as they are in use
  copies     // from private copies: the files may be replaced or overwritten
};

/// Hosts know nothing of each other, but for what renewed() says. Loading and adding are for one
/// thread; the const members may be called from several.
class Host {
 public:
  /// A host without plugins, for those that are added.
  Host();
  /// Loads every plugin library in the directories. The first of several plugins of one kind and
  /// name wins: in the order of the directories, and of file names within one; the report warns of
  /// the others. Never throws because of a file; read report() for what happened.
  explicit Host(std::vector<SearchDirectory> directories, Loading loading = Loading::in_place);
  Host(Host&&) noexcept;
  Host& operator=(Host&&) noexcept;
  ~Host();

  /// Another host, of what is in these directories now. A library that has not changed since this
  /// host loaded it is not loaded again: both hosts have the same one, and find() gives the same
  /// declarations. A library that has changed is loaded beside the old one, which stays for as long
  /// as this host or an object of it is there. Where the new file is refused or gone, the new host
  /// has the old library; the report says so. So it is when the n-th place is one library here and
  /// was another one there, as with the builds of a source. Plugins that were added are shared,
  /// too. For hosts with Loading::copies: a file of the same path would otherwise be the old one.
  Host renewed(std::vector<SearchDirectory> directories) const;

  /// The declaration of a plugin, or null. Valid as long as the host, and as all that were renewed
  /// from it and have the same library.
  const Declaration* find(PluginKind kind, std::string_view name) const;
  /// All declarations of a kind, sorted by name.
  std::vector<const Declaration*> all(PluginKind kind) const;
  /// The library that a plugin comes from, or "" when it is linked into the program. For a plugin
  /// that is not there: "" too.
  std::filesystem::path file_of(PluginKind kind, std::string_view name) const;
  /// A sentence for the user on why there is no such plugin: the nearest right name, where was
  /// searched, and which libraries there were refused.
  std::string explain_missing(PluginKind kind, std::string_view name) const;

  /// Makes an object of a plugin, with all parameters at their defaults; configured() was not yet
  /// called (apply_parameters() does). T is Component or the kind's class (Sensor, Behavior,
  /// Coordinator). Throws PluginError when there is no such plugin or its class is no T,
  /// CreateError when its constructor throws.
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

  /// Adds a plugin that is linked into the program. Throws PluginError when its declaration is
  /// faulty or its name is taken. See also linked.h.
  void add(Declaration declaration);

  const Report& report() const;

 private:
  struct State;

  Object<Component> create_component(PluginKind kind, std::string_view name) const;
  [[noreturn]] void refuse_class(PluginKind kind, std::string_view name) const;

  std::unique_ptr<State> state_;
};

}  // namespace elsie::plugin
