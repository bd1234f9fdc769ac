#include "words.h"

#include <algorithm>
#include <string_view>

#include "elsie/base/words.h"
#include "elsie/world/tree.h"

namespace elsie::server {
namespace {

constexpr std::size_t kMostNamed = 3;  // edits in a sentence
constexpr std::string_view kRemove = "/@remove";

/// "r1" of "robot[r1]", "ahead of r1" of "robot[r1]/sensor[ahead]", "the world" of "".
std::string title_of(const std::string& path) {
  if (path.empty()) return "the world";
  std::string title, step;
  int depth = 0;
  const auto end_step = [&] {
    const std::size_t open = step.find('['), close = step.rfind(']');
    const bool has_id = open != std::string::npos && close != std::string::npos;
    const std::string own = has_id ? step.substr(open + 1, close - open - 1) : step;
    const bool is_number = !own.empty() && std::all_of(own.begin(), own.end(),
                                                       [](char c) { return c >= '0' && c <= '9'; });
    const std::string name = is_number ? step.substr(0, open) + ' ' + own : own;
    title = title.empty() ? name : name + " of " + title;
    step.clear();
  };
  for (const char c : path) {
    depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    if (c == '/' && depth == 0) {
      end_step();
    } else {
      step += c;
    }
  }
  end_step();
  return title;
}

/// "static_box" of "<static_box x="1"/>".
std::string tag_of(const std::string& markup) {
  return markup.substr(1, markup.find_first_of(" \t\n/>", 1) - 1);
}

std::string joined_in_words(const std::vector<std::string>& edits) {
  std::string text;
  const std::size_t named = std::min(edits.size(), kMostNamed);
  for (std::size_t i = 0; i < named; ++i) {
    const bool is_last = i + 1 == edits.size();
    text += (i == 0 ? "" : is_last ? " and " : ", ") + words_of(edits[i]);
  }
  return edits.size() > named
             ? text + " and make " + std::to_string(edits.size() - named) + " more changes with it"
             : text;
}

}  // namespace

std::string words_of(const std::string& edit) {
  const std::size_t equals = world::end_of_path(edit);
  std::string path = edit.substr(0, equals);
  const std::string value = equals == std::string::npos ? std::string() : edit.substr(equals + 1);
  const bool removes = path.ends_with(kRemove);
  if (removes) path.resize(path.size() - kRemove.size());
  const std::size_t slash = path.rfind("/@");
  const bool of_world = path.starts_with('@');
  if (of_world || slash != std::string::npos) {
    const std::string holder = title_of(of_world ? std::string() : path.substr(0, slash));
    const std::string name = path.substr(of_world ? 1 : slash + 2);
    return removes ? "take " + name + " away from " + holder
                   : "set " + name + " of " + holder + " to " + value;
  }
  if (removes) return "remove " + title_of(path);
  if (!value.starts_with('<')) return "set " + title_of(path) + " to " + value;
  return path.find("[+") == std::string::npos ? "replace " + title_of(path)
                                              : "add a " + tag_of(value);
}

std::string refusal_in_words(const std::string& refusal, const std::vector<std::string>& edits) {
  const auto said = [&](const std::vector<std::string>& of) {
    const std::string before = base::joined(of) + ": ";
    return refusal.starts_with(before)
               ? "The run cannot " + joined_in_words(of) + ": " + refusal.substr(before.size())
               : std::string();
  };
  if (std::string all = said(edits); !all.empty()) return all;
  for (const std::string& edit : edits) {
    if (std::string one = said({edit}); !one.empty()) return one;
  }
  return refusal;
}

std::string without_edits(std::string sentence, const std::vector<std::string>& edits) {
  for (const std::string& edit : edits) {
    const std::string place = " (--set " + edit + ")";
    for (std::size_t at; (at = sentence.find(place)) != std::string::npos;) {
      sentence.erase(at, place.size());
    }
  }
  return sentence;
}

}  // namespace elsie::server
