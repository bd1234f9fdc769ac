// Its file says one thing, its code another.
#define ELSIE_BUILDING_CORE  // so that the header brings neither note nor entry point
#include "elsie/api/registration.h"

ELSIE_EMIT_ABI_NOTE_(ELSIE_ABI_WORD);

namespace {
void declare(std::vector<elsie::Declaration>&) {}
const elsie::PluginLibrary library{"api=0.0;runtime=other", &declare};
}  // namespace

extern "C" __attribute__((visibility("default"))) const elsie::PluginLibrary*
elsie_plugin_library() {
  return &library;
}
