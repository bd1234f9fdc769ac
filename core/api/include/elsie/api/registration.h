// How a plugin library registers its plugins.
//
// A translation unit that uses one of the ELSIE_... macros gets:
// - a node in a list of the library's plugins. The list consists of plain pointers, and its static
//   initialisers call nothing, so that loading a library runs no code that depends on the host's
//   ABI;
// - through this header, the library's one C entry point, elsie_plugin_library(), and the ELF note
//   with its ABI word.
// Parts of the program itself define ELSIE_BUILDING_CORE and have no entry point.
#pragma once

#include <vector>

#include "elsie/api/abi.h"
#include "elsie/api/declaration_items.h"

namespace elsie {

/// The result of a plugin library's entry point. Compare `abi_word` before you read any other
/// member.
struct PluginLibrary {
  const char* abi_word;
  /// Appends the library's declarations, in the order of registration. May throw.
  void (*declare)(std::vector<Declaration>& declarations);
};

/// Name and type of the entry point.
#define ELSIE_PLUGIN_ENTRY "elsie_plugin_library"
using PluginEntry = const PluginLibrary* (*)();

namespace detail {

/// A plugin's node in the list of its library.
struct PluginNode {
  Declaration (*declare)();
  PluginNode* next;
};

// Hidden: each library has a list of its own.
__attribute__((visibility("hidden"))) inline constinit PluginNode* plugin_list_head = nullptr;
__attribute__((visibility("hidden"))) inline constinit PluginNode* plugin_list_tail = nullptr;

/// Appends the node; used by the macros only.
struct PluginRegistrar {
  __attribute__((visibility("hidden"))) explicit PluginRegistrar(PluginNode& node) {
    (plugin_list_tail ? plugin_list_tail->next : plugin_list_head) = &node;
    plugin_list_tail = &node;
  }
};

__attribute__((visibility("hidden"))) inline void declare_plugins(
    std::vector<Declaration>& declarations) {
  for (const PluginNode* node = plugin_list_head; node; node = node->next) {
    declarations.push_back(node->declare());
  }
}

}  // namespace detail
}  // namespace elsie

#define ELSIE_JOIN_TOKENS_(a, b) a##b
#define ELSIE_JOIN_(a, b) ELSIE_JOIN_TOKENS_(a, b)
#define ELSIE_REGISTER_PLUGIN_(kind, Class, ...)                                            \
  namespace {                                                                               \
  ::elsie::detail::PluginNode ELSIE_JOIN_(elsie_plugin_node_, Class){                       \
      [] { return ::elsie::declare<Class>(kind, __VA_ARGS__); }, nullptr};                  \
  const ::elsie::detail::PluginRegistrar ELSIE_JOIN_(elsie_plugin_registrar_,               \
                                                     Class)(ELSIE_JOIN_(elsie_plugin_node_, \
                                                                        Class));            \
  }                                                                                         \
  static_assert(true, "a semicolon may follow")

#ifndef ELSIE_BUILDING_CORE
namespace elsie::detail {
__attribute__((visibility("hidden"))) inline constexpr PluginLibrary plugin_library{
    ELSIE_ABI_WORD, &declare_plugins};
}

extern "C" {
/// The entry point; one weak definition serves all translation units of the library.
__attribute__((visibility("default"), used)) inline const elsie::PluginLibrary*
elsie_plugin_library() {
  return &elsie::detail::plugin_library;
}
}

// In assembly, because a variable in a section of this name does not become a note: g++ 12 gives
// the section the type "progbits", and then the linker makes no note segment. Every translation
// unit adds a note of its own, so the host can see when parts of one library do not fit together.
ELSIE_EMIT_ABI_NOTE_(ELSIE_ABI_WORD);
#endif
