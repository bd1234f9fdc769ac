#include "elsie/page/run_page.h"

#include <algorithm>

#include "elsie/base/error.h"
#include "elsie/recording/recorded_run.h"

#include "decisions.h"
#include "film.h"

namespace elsie::page {

using recording::RecordedRun;

RunPage run_page(const std::filesystem::path& recording, const plugin::Host& drives,
                 const PageOptions& options) {
  Film film(drives);
  const RecordedRun run =
      recording::watch_recorded_run(recording, [&](const RecordedRun& state) { film.add(state); });
  if (film.empty()) {
    const std::string what = !run.missing_end.empty() ? "breaks off before its first second"
                             : run.result             ? "has a run without robots"
                                                      : "has no run of Elsie";
    throw base::BadInput("'" + recording.string() + "' " + what +
                         "; expected a recording with robots that `elsie run WORLD --record "
                         "FILE.mcap` has written to its end");
  }
  const traces::Trace trace = recording::read_trace(recording);
  Decisions decisions(trace);
  Numbers numbers(trace);
  Film::Facts facts{{"recorded by", run.library}};
  if (!run.crowd.empty()) {
    facts.emplace_back("robots in brief",
                       "of " + std::to_string(run.crowd.size()) + " robots only the poses");
  }
  facts.emplace_back("note", run.missing_end);
  constexpr std::size_t kFacts = 8192;  // about as many bytes
  const std::size_t rest = viewer_html().size() + kFacts;
  const PageRun shown = film.page_run(run, std::max(run.end_s, trace.end_s), {&decisions, &numbers},
                                      "0.1 mm and 0.0001 rad", facts,
                                      options.most_bytes - std::min(rest, options.most_bytes));
  return {html_of(shown), shown.poses_every_s};
}

}  // namespace elsie::page
