#include "elsie/base/error.h"

namespace elsie::base {

std::string Error::message() const { return std::string("elsie: ") + what(); }

}  // namespace elsie::base
