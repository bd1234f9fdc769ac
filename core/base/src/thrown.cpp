#include "elsie/base/thrown.h"

#include <cstdlib>
#include <exception>
#include <memory>
#include <typeinfo>

#include <cxxabi.h>

namespace elsie::base {
namespace {

std::string (*place_known_to_program)() = nullptr;

}  // namespace

std::string what_was_thrown() {
  const char* text = nullptr;
  try {
    throw;
  } catch (const std::exception& error) {
    if ((text = error.what()) && *text) return text;
  } catch (...) {
  }
  const std::type_info* const type = abi::__cxa_current_exception_type();
  return "an exception of type " + (type ? demangled_name(type->name()) : "unknown to C++");
}

std::string place_of_throw() { return place_known_to_program ? place_known_to_program() : ""; }

void watch_throws(std::string (*place)()) noexcept { place_known_to_program = place; }

std::string demangled_name(const std::string& name) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> readable(
      abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status), &std::free);
  return status == 0 && readable ? std::string(readable.get()) : name;
}

}  // namespace elsie::base
