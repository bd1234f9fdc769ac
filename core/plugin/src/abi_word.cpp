#include "elsie/plugin/abi_word.h"

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

#include "elsie/api/abi.h"

#include "text.h"

namespace elsie::plugin {
namespace {

using KeyAndValue = std::pair<std::string_view, std::string_view>;

constexpr std::string_view kInterface = "api";

std::vector<KeyAndValue> entries_of(std::string_view word) {
  std::vector<KeyAndValue> entries;
  while (!word.empty()) {
    const std::string_view item = word.substr(0, word.find(';'));
    word.remove_prefix(std::min(item.size() + 1, word.size()));
    const std::size_t equals = item.find('=');
    entries.emplace_back(item.substr(0, equals), equals == std::string_view::npos
                                                     ? std::string_view()
                                                     : item.substr(equals + 1));
  }
  return entries;
}

std::optional<std::string_view> value_of(const std::vector<KeyAndValue>& entries,
                                         std::string_view key) {
  const auto at = std::find_if(entries.begin(), entries.end(),
                               [key](const KeyAndValue& entry) { return entry.first == key; });
  return at == entries.end() ? std::nullopt : std::optional(at->second);
}

/// "1.12" as (1, 12).
std::optional<std::pair<unsigned, unsigned>> version_of(std::string_view text) {
  unsigned major = 0;
  unsigned minor = 0;
  const char* const end = text.data() + text.size();
  const auto [dot, bad_major] = std::from_chars(text.data(), end, major);
  if (bad_major != std::errc() || dot == end || *dot != '.') return std::nullopt;
  const auto [rest, bad_minor] = std::from_chars(dot + 1, end, minor);
  if (bad_minor != std::errc() || rest != end) return std::nullopt;
  return std::pair(major, minor);
}

/// The problem with the interface version of a library; empty if there is none.
std::string interface_difference(std::string_view host, std::string_view library) {
  const auto ours = version_of(host);
  const auto theirs = version_of(library);
  const std::string text = "plugin interface " + std::string(library);
  if (!ours || !theirs) {
    return host == library ? "" : text + ", where this program has " + std::string(host);
  }
  if (*theirs > *ours) return text + ", which is newer than this program's " + std::string(host);
  // Before 1.0, each minor version may break plugins of the one before.
  const bool is_too_old = theirs->first < ours->first || (ours->first == 0 && *theirs < *ours);
  return is_too_old ? text + ", which is older than this program's " + std::string(host) : "";
}

std::string with_value(std::string_view key, std::optional<std::string_view> value) {
  return value ? std::string(key) + "=" + std::string(*value) : "no " + std::string(key);
}

}  // namespace

std::string_view host_abi_word() { return ELSIE_ABI_WORD; }

std::optional<std::string> abi_mismatch(std::string_view host, std::string_view library) {
  const std::vector<KeyAndValue> ours = entries_of(host);
  const std::vector<KeyAndValue> theirs = entries_of(library);
  const auto version = value_of(ours, kInterface);
  const auto their_version = value_of(theirs, kInterface);
  std::vector<std::string> differences;
  const auto compare = [&](std::string_view key) {
    const auto mine = value_of(ours, key);
    const auto other = value_of(theirs, key);
    if (mine != other && !(key == kInterface && mine && other)) {
      differences.push_back("with " + with_value(key, other) + ", where this program has " +
                            with_value(key, mine));
    }
  };
  const std::string of_interfaces =
      version && their_version ? interface_difference(*version, *their_version) : "";
  if (!of_interfaces.empty()) {
    differences = {"for " + of_interfaces};  // whose words have other settings
  } else {
    for (const KeyAndValue& entry : ours) {
      compare(entry.first);
    }
    for (const KeyAndValue& entry : theirs) {
      if (!value_of(ours, entry.first)) {
        compare(entry.first);
      }
    }
  }
  if (differences.empty()) return std::nullopt;
  return "was built " + joined(differences, ", and ") +
         "; rebuild it with the headers of this Elsie (plugin interface " +
         std::string(version.value_or("unknown")) + ") and with the same build settings";
}

}  // namespace elsie::plugin
