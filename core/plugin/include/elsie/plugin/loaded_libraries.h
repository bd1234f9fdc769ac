// Finds the plugin library of a code address, for signal handlers.
#pragma once

namespace elsie::plugin {

/// Notes a loaded library; `code` is any address in it.
void note_loaded(const void* code, const char* file) noexcept;
/// Notes that it is about to be unloaded. Its addresses stay known: a thread that it left behind
/// crashes there.
void note_unloaded(const char* file) noexcept;

/// The file of the plugin library, loaded or unloaded, with this address; null: there is none.
/// Takes no locks.
const char* plugin_library_at(const void* address) noexcept;

}  // namespace elsie::plugin
