// Bytes as text (RFC 4648, section 4).
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace elsie::files {

constexpr char kBase64Digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

inline std::string base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = bytes.size() - i < 3 ? bytes.size() - i : 3;
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (k < count ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kBase64Digits[group >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

/// How a content security policy names a script or style by its SHA-256, which is given in
/// hexadecimal digits: "'sha256-...'".
inline std::string policy_hash(std::string_view hexadecimal) {
  const auto digit = [](char c) { return c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10; };
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hexadecimal.size(); i += 2) {
    bytes += static_cast<char>(16 * digit(hexadecimal[i]) + digit(hexadecimal[i + 1]));
  }
  return "'sha256-" + base64(bytes) + "'";
}

/// The bytes of such a text; none if it is not one.
inline std::optional<std::string> from_base64(std::string_view text) {
  static constexpr std::uint8_t kNone = 64;
  static constexpr auto kValues = [] {
    std::array<std::uint8_t, 256> values{};
    values.fill(kNone);
    for (std::uint8_t i = 0; i < kNone; ++i) {
      values[static_cast<std::uint8_t>(kBase64Digits[i])] = i;
    }
    return values;
  }();
  if (text.size() % 4 != 0) {
    return std::nullopt;
  }
  const std::size_t padding = text.ends_with("==") ? 2 : text.ends_with('=') ? 1 : 0;
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  for (std::size_t i = 0; i < text.size(); i += 4) {
    std::uint32_t group = 0;
    for (std::size_t k = i; k < i + 4; ++k) {
      const bool pads = k >= text.size() - padding;
      const std::uint8_t value = pads ? 0 : kValues[static_cast<std::uint8_t>(text[k])];
      if (value == kNone) {
        return std::nullopt;
      }
      group = group << 6U | value;
    }
    for (const unsigned shift : {16U, 8U, 0U}) {
      bytes += static_cast<char>(group >> shift & 255U);
    }
  }
  bytes.resize(bytes.size() - padding);
  return bytes;
}

static_assert(std::endian::native == std::endian::little);

/// Little-endian numbers as text.
template <class Number>
std::string packed(const std::vector<Number>& numbers) {
  return base64({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)});
}

/// The numbers of such a text; none if it is not one.
template <class Number>
std::optional<std::vector<Number>> unpacked(std::string_view text) {
  const std::optional<std::string> bytes = from_base64(text);
  if (!bytes || bytes->size() % sizeof(Number) != 0) {
    return std::nullopt;
  }
  std::vector<Number> numbers(bytes->size() / sizeof(Number));
  if (!numbers.empty()) {
    std::memcpy(numbers.data(), bytes->data(), bytes->size());
  }
  return numbers;
}

}  // namespace elsie::files
