// Comparing ABI words; see elsie/api/abi.h.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace elsie::plugin {

/// The ABI word of this program.
std::string_view host_abi_word();

/// Why a host must not load a plugin library: a sentence with every key that differs, both values,
/// and what to do. None when the host may load it.
std::optional<std::string> abi_mismatch(std::string_view host, std::string_view library);

}  // namespace elsie::plugin
