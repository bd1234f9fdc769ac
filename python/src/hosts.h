// The plugins of worlds in this process.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "elsie/plugin/host.h"

namespace elsie::python {

/// The host with the plugins of the default search path, made at the first call. It lives as long
/// as the process: what it has loaded may be in use until the end.
std::shared_ptr<const plugin::Host> default_host();

/// A host that searches these places first: folders, libraries, scripts, and sources, which are
/// compiled unless the cache has them; the default host if there are none. Throws base::BadInput
/// for a place that does not exist or holds no usable plugin, and build::BuildError.
std::shared_ptr<const plugin::Host> host_with(const std::vector<std::string>& places);

}  // namespace elsie::python
