#include "library.h"

#include <stdexcept>
#include <system_error>
#include <utility>

#include <dlfcn.h>
#include <link.h>

#define BOOST_DLL_USE_STD_FS
#include <boost/dll/shared_library.hpp>

#include "elsie/api/registration.h"
#include "elsie/base/thrown.h"
#include "elsie/plugin/call.h"
#include "elsie/plugin/watch_libraries.h"

#include "text.h"

namespace elsie::plugin {
namespace {

void (*tell_loaded)(const void*, const char*) = [](const void*, const char*) {};

}  // namespace

void watch_libraries(void (*loaded)(const void*, const char*)) noexcept { tell_loaded = loaded; }

struct Library::System {
  boost::dll::shared_library library;
};

Library::Library(std::unique_ptr<System> system, std::string file, std::shared_ptr<const void> kept)
    : kept_(std::move(kept)), system_(std::move(system)), file_(std::move(file)) {
  tell_loaded(dlsym(system_->library.native(), ELSIE_PLUGIN_ENTRY), file_.c_str());
}
Library::Library(std::string file, std::shared_ptr<const void> kept)
    : kept_(std::move(kept)), file_(std::move(file)) {}
Library::~Library() {
  Call call({.library = file_.c_str(), .doing = "while it was unloaded"});
  call.start_clock();
  system_.reset();
}

namespace {

/// The loader's message about its last failure, without the path at its beginning.
std::string loader_message(const std::filesystem::path& file) {
  const char* const message = dlerror();
  std::string text = message ? demangled(message) : "the loader gives no reason";
  const std::string prefix = file.string() + ": ";
  if (text.starts_with(prefix)) {
    text.erase(0, prefix.size());
  }
  return text;
}

/// The entry point, if it belongs to this library. A look-up by handle would also find the entry
/// point of a library that this one depends on.
PluginEntry own_entry(void* handle) {
  void* const symbol = dlsym(handle, ELSIE_PLUGIN_ENTRY);
  Dl_info info{};
  void* owner = nullptr;
  link_map* library = nullptr;
  if (!symbol || dladdr1(symbol, &info, &owner, RTLD_DL_LINKMAP) == 0 ||
      dlinfo(handle, RTLD_DI_LINKMAP, &library) != 0 || owner != library) {
    return nullptr;
  }
  return reinterpret_cast<PluginEntry>(symbol);
}

/// Fills in the declarations; returns a sentence on failure.
std::string read_declarations(void* handle, std::string_view abi_word,
                              std::vector<Declaration>& declarations) {
  const PluginEntry entry = own_entry(handle);
  if (!entry) {
    return "carries Elsie's ABI word, but has no entry point '" ELSIE_PLUGIN_ENTRY
           "' of its own; build it with elsie_add_plugin()";
  }
  try {
    const PluginLibrary* const found = entry();
    if (!found || !found->abi_word || abi_word != found->abi_word) {
      return "says one ABI word in its file and another when loaded (" +
             std::string(found && found->abi_word ? found->abi_word : "none") +
             "); rebuild it from scratch";
    }
    if (!found->declare) {
      return "has no function that declares its plugins; build it with elsie_add_plugin()";
    }
    found->declare(declarations);
  } catch (...) {
    return "failed while it declared its plugins: " + base::what_was_thrown();
  }
  return "";
}

}  // namespace

LoadedLibrary load_library(const std::filesystem::path& file, const std::string& known_as,
                           std::string_view abi_word, const MakeCopy& make_copy) {
  namespace dll = boost::dll;
  LoadedLibrary loaded;
  Call call({.library = known_as.c_str(), .doing = "while it was loaded"});
  call.start_clock();  // most libraries load fast: a Watchdog reports a slow one
  std::shared_ptr<const std::filesystem::path> copy;
  try {
    copy = make_copy ? make_copy(file) : nullptr;
  } catch (const std::runtime_error& error) {
    loaded.problem = error.what();
    return loaded;
  }
  const std::filesystem::path path = copy ? *copy : file;
  auto system = std::make_unique<Library::System>();
  std::error_code error;
  // All symbols are bound at once, so that a missing one is found here and not during a run; no
  // symbol is visible to libraries that are loaded later.
  system->library.load(path, dll::load_mode::rtld_now | dll::load_mode::rtld_local, error);
  if (error) {
    loaded.problem = "cannot be loaded: " + loader_message(path) +
                     "; link it with all that it uses, and build it against this version of Elsie";
    return loaded;
  }
  void* const handle = system->library.native();
  loaded.library = std::make_shared<const Library>(std::move(system), known_as, std::move(copy));
  loaded.problem = read_declarations(handle, abi_word, loaded.declarations);
  if (const char* const changed = call.restore_arithmetic()) {
    loaded.warning = std::string("changed ") + changed +
                     " for the whole program when it was loaded; this was undone";
  }
  if (!loaded.problem.empty()) {
    loaded.declarations.clear();
    loaded.library.reset();
  }
  return loaded;
}

}  // namespace elsie::plugin
