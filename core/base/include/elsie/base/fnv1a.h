// A hash that is the same on every machine.
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace elsie::base {

/// FNV-1a over 64 bits (Fowler, Noll and Vo). It hashes the bits of numbers, never memory that may
/// hold padding or addresses.
class Fnv1a {
 public:
  static constexpr std::uint64_t kStart = 0xcbf29ce484222325ULL;

  /// Continues a hash that another object has computed.
  constexpr explicit Fnv1a(std::uint64_t value = kStart) : value_(value) {}

  constexpr void add_byte(unsigned char byte) { value_ = (value_ ^ byte) * 0x100000001b3ULL; }
  constexpr void add(std::string_view bytes) {
    for (const char c : bytes) {
      add_byte(static_cast<unsigned char>(c));
    }
  }
  /// The eight bytes of the word, the lowest first.
  constexpr void add(std::uint64_t word) {
    for (int shift = 0; shift < 64; shift += 8) {
      add_byte(static_cast<unsigned char>((word >> shift) & 0xffU));
    }
  }
  constexpr void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }

  constexpr std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_;
};

}  // namespace elsie::base
