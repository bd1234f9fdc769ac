// The layers of a page's data, which grow with the length of a run. Each can make itself smaller.
//
// Values are kept where they change: a key says what holds from its sample on. Samples are numbered
// as in the recording, also where only each second, fourth ... is left.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace elsie::page {

using Sample = std::uint32_t;

template <class Value>
struct Key {
  Sample sample = 0;
  Value value{};
};

template <class Value>
using Keys = std::vector<Key<Value>>;

/// Adds a value unless it holds already. Returns whether it did.
template <class Value>
bool hold(Keys<Value>& keys, Sample sample, Value value) {
  if (!keys.empty() && keys.back().value == value) return false;
  keys.push_back({sample, std::move(value)});
  return true;
}

/// Leaves the keys at multiples of `every` and at the last sample; others move there, so that none
/// holds before it did. `join` takes over what must not be lost of the earlier of two keys that
/// meet.
template <class Value, class Join>
void thin(Keys<Value>& keys, Sample every, Sample last, const Join& join) {
  std::size_t left = 0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    Key<Value> key = std::move(keys[i]);
    key.sample = std::min((key.sample + every - 1) / every * every, last);
    if (left > 0 && keys[left - 1].sample == key.sample) {
      join(key.value, keys[left - 1].value);
      keys[left - 1] = std::move(key);
    } else {
      keys[left++] = std::move(key);
    }
  }
  keys.resize(left);
}

/// Appends "[3,1,-2]": the first number, then how each differs from the one before.
template <class Numbers>
void append_differences(std::string& out, const Numbers& numbers) {
  std::int64_t before = 0;
  char separator = '[';
  for (const std::int64_t number : numbers) {
    out += separator;
    out += std::to_string(number - before);
    before = number;
    separator = ',';
  }
  out += separator == '[' ? "[]" : "]";
}

/// Appends "[3,4,2]".
template <class Numbers>
void append_list(std::string& out, const Numbers& numbers) {
  char separator = '[';
  for (const auto& number : numbers) {
    out += separator;
    out += std::to_string(number);
    separator = ',';
  }
  out += separator == '[' ? "[]" : "]";
}

/// In units of 0.1 ms, 0.1 mm or 1e-4 rad.
inline std::int64_t fine(double value) { return std::llround(value * 1e4); }

/// Something of a run over its time.
class Layer {
 public:
  virtual ~Layer() = default;
  /// Its members of the data: "\"poses\":{...}".
  virtual std::string text() const = 0;
  /// Halves what it says of a second. False: it is as coarse as may be.
  virtual bool thin() = 0;
};

}  // namespace elsie::page
