// Numbers and texts in MCAP's encoding: little-endian, texts after their length.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

namespace elsie::mcap {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

template <std::unsigned_integral Number>
void put(std::string& out, Number value) {
  char bytes[sizeof(Number)];
  std::memcpy(bytes, &value, sizeof(Number));
  out.append(bytes, sizeof(Number));
}

/// The length of a text or a list. Throws std::length_error when it does not fit into 32 bits.
inline std::uint32_t length32(std::size_t length) {
  if (length > std::numeric_limits<std::uint32_t>::max()) {
    throw std::length_error("MCAP: a text of more than 4 GiB");
  }
  return static_cast<std::uint32_t>(length);
}

inline void put_text(std::string& out, std::string_view text) {
  put(out, length32(text.size()));
  out.append(text);
}

inline void put_texts(std::string& out, const std::map<std::string, std::string>& texts) {
  std::string entries;
  for (const auto& [key, value] : texts) {
    put_text(entries, key);
    put_text(entries, value);
  }
  put_text(out, entries);
}

/// Thrown for fewer bytes than a record must have.
class TooShort : public std::exception {};

/// Takes numbers and texts from the front of some bytes. Each function throws TooShort when there
/// are not enough bytes.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : rest_(bytes) {}

  template <std::unsigned_integral Number>
  Number number() {
    Number value;
    std::memcpy(&value, take(sizeof(Number)).data(), sizeof(Number));
    return value;
  }
  std::string_view text() { return take(number<std::uint32_t>()); }
  std::string_view take(std::uint64_t count) {
    if (count > rest_.size()) {
      throw TooShort();
    }
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }
  std::map<std::string, std::string> texts() {
    std::map<std::string, std::string> all;
    for (Bytes entries(text()); !entries.rest().empty();) {
      std::string key(entries.text());
      all.insert_or_assign(std::move(key), std::string(entries.text()));
    }
    return all;
  }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

}  // namespace elsie::mcap
