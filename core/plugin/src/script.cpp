#include "elsie/plugin/script.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "elsie/base/read_whole.h"
#include "elsie/base/thrown.h"
#include "elsie/plugin/call.h"
#include "elsie/plugin/engine_libraries.h"

#include "library.h"

namespace elsie::plugin {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMostBytes = 4'000'000;
/// The classes of the package `elsie` that plugins derive from.
constexpr std::string_view kBases[] = {"Behavior", "Coordinator", "Sensor",
                                       "Measure",  "Rule",        "Actuator"};

}  // namespace

bool is_script(const fs::path& file) { return file.extension() == ".py"; }

bool may_hold_plugins(const fs::path& file) { return file.extension() == ".so" || is_script(file); }

bool declares_plugins(const fs::path& script) {
  const std::string text = '\n' + base::read_whole(script, kMostBytes);
  if (text.find("elsie") == text.npos) return false;
  constexpr std::string_view kClass = "\nclass ";
  for (std::size_t at = text.find(kClass); at != text.npos; at = text.find(kClass, at + 1)) {
    // "class Orbit(elsie.Behavior)", perhaps in several lines
    const std::string_view head = std::string_view(text).substr(at, text.find(':', at) - at);
    const std::size_t bases = std::min(head.find('('), head.size());
    if (std::any_of(std::begin(kBases), std::end(kBases),
                    [&](std::string_view base) { return head.find(base, bases) != head.npos; })) {
      return true;
    }
  }
  return false;
}

LoadedLibrary load_script(const fs::path& file, const MakeCopy& make_copy) {
  LoadedLibrary loaded;
  const std::string name = file.string();
  Call call({.library = name.c_str(), .doing = "while it was loaded"});
  call.start_clock();
  const fs::path part = part_file("python");
  Script script;
  if (std::error_code error; !fs::exists(part, error)) {
    loaded.missing = "this Elsie was built without Python";
    return loaded;
  }
  try {
    if (make_copy) make_copy(file);
    reinterpret_cast<LoadScript>(part_symbol("plugins in Python", part, ELSIE_LOAD_SCRIPT))(file,
                                                                                            script);
    loaded.library = std::make_shared<const Library>(name, std::move(script.kept));
    loaded.declarations = std::move(script.declarations);
    loaded.missing = std::move(script.missing);
  } catch (...) {
    loaded.problem = base::what_was_thrown();
  }
  if (const char* const changed = call.restore_arithmetic()) {
    loaded.warning = std::string("changed ") + changed +
                     " for the whole program when it was loaded; this was undone";
  }
  return loaded;
}

}  // namespace elsie::plugin
