#include "shipped.h"

namespace elsie::test {

const plugin::Host& shipped() {
  static const plugin::Host host(shipped_directory());
  return host;
}

}  // namespace elsie::test
