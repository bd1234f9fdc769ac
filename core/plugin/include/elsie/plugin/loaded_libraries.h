// Which plugin library some code belongs to, for handlers of signals.
#pragma once

namespace elsie::plugin {

/// Notes a library that is loaded: `code` is any address in it.
void note_loaded(const void* code, const char* file) noexcept;
/// Before it is unloaded. It stays known where its code was: a thread that it has left behind
/// crashes there.
void note_unloaded(const char* file) noexcept;

/// The file of the plugin library that the address lies in, or lay in until it was unloaded; null:
/// in none. For handlers of signals: takes no locks.
const char* plugin_library_at(const void* address) noexcept;

}  // namespace elsie::plugin
