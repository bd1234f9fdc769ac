// The viewer of run pages, for pages that have several runs and one viewer.
//
// viewer_html() has {{names}} in the place of a run. Whoever replaces them by the members of a
// PageRun, in C++ or in a browser, has the page of that run.
#pragma once

#include <cstddef>
#include <string>

namespace elsie::page {

struct PageOptions {
  /// The page becomes no larger if it can be helped, bytes: the more a run has, the coarser it is
  /// sampled, down to kFewestSamples.
  std::size_t most_bytes = 3'000'000;
};

/// At least so many samples of the poses are kept.
inline constexpr std::size_t kFewestSamples = 64;

/// A run for the viewer. The texts are HTML, in which everything that a world or a plugin says is
/// escaped.
struct PageRun {
  std::string title;
  std::string summary;  // outcome, time, seed
  std::string outcome;  // one word: the class of the summary
  std::string facts;    // a list of terms
  std::string data;     // what is played
  double poses_every_s = 0.0;

  /// Calls `visit(name, text)` for each text.
  template <class Visit>
  void for_each_text(Visit visit) const {
    visit("title", title);
    visit("summary", summary);
    visit("outcome", outcome);
    visit("facts", facts);
    visit("data", data);
  }
};

/// A page without a run, with {{title}}, {{summary}}, {{outcome}}, {{facts}} and {{data}}.
std::string viewer_html();
std::string html_of(const PageRun& run);

/// The viewer's style and script as a content security policy names them: "'sha256-...'".
std::string viewer_style_hash();
std::string viewer_script_hash();

}  // namespace elsie::page
