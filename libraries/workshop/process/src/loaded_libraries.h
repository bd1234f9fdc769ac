// Finds the plugin library of a code address, for signal handlers.
#pragma once

namespace elsie::process {

/// Notes from now on which plugin libraries are loaded.
void watch_libraries() noexcept;

/// The file of the plugin library with this address, loaded or unloaded since; null: there is none.
/// Takes no locks.
const char* plugin_library_at(const void* address) noexcept;

}  // namespace elsie::process
