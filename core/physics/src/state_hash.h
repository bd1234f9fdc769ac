// A hash over the states of bodies, by which two runs are compared.
#pragma once

#include <bit>
#include <cstdint>

#include "ode_handles.h"

namespace elsie::physics {

/// FNV-1a over 64 bits (Fowler, Noll and Vo), fed with the bits of numbers, never with memory that
/// may hold padding or addresses.
class StateHash {
 public:
  explicit StateHash(std::uint64_t start) : value_(start) {}

  void add(const dReal* numbers, int count) {
    for (int i = 0; i < count; ++i) add(std::bit_cast<std::uint64_t>(numbers[i]));
  }
  void add(std::uint64_t word) {
    for (int i = 0; i < 8; ++i) {
      value_ = (value_ ^ ((word >> (8 * i)) & 0xff)) * 0x100000001b3ULL;
    }
  }
  void add_body(dBodyID body) {
    add(dBodyGetPosition(body), 3);
    add(dBodyGetQuaternion(body), 4);
    add(dBodyGetLinearVel(body), 3);
    add(dBodyGetAngularVel(body), 3);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_;
};

}  // namespace elsie::physics
