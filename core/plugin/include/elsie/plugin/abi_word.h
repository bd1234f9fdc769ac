// Comparing ABI words; see elsie/api/abi.h.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace elsie::plugin {

/// The ABI word of this program.
std::string_view host_abi_word();

/// Why a host must not load a plugin library: a sentence that names every key that differs, with
/// both values, and says what to do. None when they fit together.
std::optional<std::string> abi_mismatch(std::string_view host, std::string_view library);

}  // namespace elsie::plugin
