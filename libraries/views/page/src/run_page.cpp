#include "elsie/page/run_page.h"

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>
#include <zlib.h>

#include "elsie/base/error.h"
#include "elsie/base/number_text.h"
#include "elsie/files/base64.h"
#include "elsie/files/clean_text.h"
#include "elsie/picture/bodies.h"
#include "elsie/recording/recorded_run.h"
#include "elsie/world/escaped.h"

#include "decisions.h"
#include "motion.h"
#include "scenes.h"

namespace elsie::page {

// The viewer's files, and the SHA-256 of style and script in hexadecimal digits, as CMake read
// them.
extern const char* const kPage;
extern const char* const kStyle;
extern const char* const kScript;
extern const char* const kStyleHash;
extern const char* const kScriptHash;

namespace {

using recording::RecordedRun;

std::string escaped(std::string_view text) { return world::escaped_attribute(files::clean(text)); }

/// DEFLATE (RFC 1951) without a header.
std::string deflated(const std::string& bytes) {
  z_stream stream{};
  constexpr int kRaw = -15, kMemory = 9;
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kRaw, kMemory, Z_DEFAULT_STRATEGY) !=
      Z_OK) {
    throw std::runtime_error("zlib cannot be set up");
  }
  std::string out(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int result = deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  if (result != Z_STREAM_END) throw std::runtime_error("zlib: the data are too large");
  return out;
}

/// Everything that the recording says, while it is read.
class Film {
 public:
  explicit Film(const plugin::Host& drives) : drives_(drives) {}

  void add(const RecordedRun& run) {
    if (run.world_xml.empty()) return;
    if (times_.empty() || run.world_xml != world_xml_) {
      world_xml_ = run.world_xml;
      world_ = picture::bodies_of(run.world_xml, run.world_file, drives_);
      hold(scenes_, now(), scene_text(world_, bodies_, images_));
    }
    poses_.add(now(), run, world_, bodies_);
    lights_.add(now(), run, bodies_);
    sketches_.add(now(), run, bodies_);
    fields_.add(now(), run, world_);
    times_.push_back(fine(run.shown_s));
    constexpr std::size_t kMost = 10'000'000;  // numbers: more than a page can have
    for (SampledLayer* const layer : sampled()) {
      if (layer->size() > kMost) layer->thin();
    }
  }

  void finish() {
    for (SampledLayer* const layer : sampled()) layer->settle();
  }

  bool empty() const { return times_.empty(); }
  Sample pose_every() const { return poses_.every(); }
  std::array<SampledLayer*, 4> sampled() { return {&poses_, &lights_, &sketches_, &fields_}; }

  /// What stays.
  std::string text() const {
    std::string out = "\"times\":";
    append_differences(out, times_);
    out += ",\"scenes\":[";
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      out += (i > 0 ? "," : "") + ("{\"from\":" + std::to_string(scenes_[i].sample)) + "," +
             scenes_[i].value.substr(1);
    }
    return out += "],\"images\":" + nlohmann::json(images_).dump();
  }

 private:
  Sample now() const { return static_cast<Sample>(times_.size()); }

  const plugin::Host& drives_;
  std::string world_xml_;
  world::World world_;
  Bodies bodies_;
  std::vector<std::int64_t> times_;
  Keys<std::string> scenes_;
  std::vector<std::string> images_;  // of floors, for all scenes
  Poses poses_;
  Lights lights_;
  Sketches sketches_;
  Fields fields_;
};

std::string events_text(const RecordedRun& run) {
  auto events = nlohmann::ordered_json::array();
  for (const recording::RecordedEvent& event : run.events) {
    events.push_back({fine(event.time_s), files::one_line(event.robot), files::one_line(event.name),
                      files::one_line(event.detail), event.is_warning ? 1 : 0});
  }
  return "\"events\":" + events.dump();
}

std::string ending(const RecordedRun& run) {
  if (!run.result) {
    return "no outcome: the recording ends after " + base::fixed_text(run.end_s, 1) + " s";
  }
  const std::string& outcome = run.result->outcome;
  return (outcome == "time_limit" ? "time limit" : outcome) + " after " +
         base::fixed_text(run.result->simulated_s, 1) + " s";
}

/// What the page says about itself, as a list of terms.
std::string facts(const RecordedRun& run, double poses_every_s) {
  std::string out;
  const auto add = [&](const std::string& name, const std::string& value) {
    if (!value.empty()) {
      out += "<dt>" + escaped(name) + "</dt><dd>" + escaped(value) + "</dd>\n";
    }
  };
  add("world", run.world);
  add("file", std::filesystem::path(run.world_file).filename().string());
  add("seed", std::to_string(run.seed));
  add("outcome", ending(run));
  if (run.result) {
    add("reason", run.result->reason);
    if (!run.result->state_hash.empty()) {
      add("state hash",
          run.result->state_hash + " after " + std::to_string(run.result->steps) + " steps");
    }
    for (const auto& [name, value] : run.result->measures) {
      add(name, base::number_text(value, 6));
    }
  }
  add("recorded by", run.library);
  add("sampling",
      "poses every " + base::number_text(poses_every_s, 6) + " s, to 0.1 mm and 0.0001 rad");
  if (!run.crowd.empty()) {
    add("robots in brief", "of " + std::to_string(run.crowd.size()) + " robots only the poses");
  }
  add("note", run.missing_end);
  return out;
}

/// The template with the values of its {{names}}.
std::string filled(std::string_view text,
                   const std::vector<std::pair<std::string_view, std::string>>& values) {
  std::string out;
  for (std::size_t at = 0;;) {
    const std::size_t open = text.find("{{", at), close = text.find("}}", open);
    out += text.substr(at, open - at);
    if (open == std::string_view::npos) return out;
    const std::string_view name = text.substr(open + 2, close - open - 2);
    const auto value = std::find_if(values.begin(), values.end(),
                                    [&](const auto& each) { return each.first == name; });
    if (value == values.end()) throw std::logic_error("page.html: " + std::string(name));
    out += value->second;
    at = close + 2;
  }
}

std::string subtitle(const RecordedRun& run) {
  return ending(run) + "  (seed " + std::to_string(run.seed) + ")";
}

/// The picture from above, at the end, for browsers without WebGL and for print.
std::string picture_text(const RecordedRun& run, const plugin::Host& drives) {
  constexpr picture::Size kSize{900, 0};
  const std::string svg = recording::picture_svg(run, drives, {subtitle(run)}, kSize);
  return "\"picture\":" + nlohmann::json(svg).dump();
}

/// Makes the largest layer that can become smaller do so. False: none can.
bool thin_largest(const std::vector<Layer*>& layers, std::vector<std::string>& texts) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < layers.size(); ++i) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return texts[a].size() > texts[b].size(); });
  const auto thinner =
      std::find_if(order.begin(), order.end(), [&](std::size_t i) { return layers[i]->thin(); });
  if (thinner == order.end()) return false;
  texts[*thinner] = layers[*thinner]->text();
  return true;
}

/// The data, in at most so many bytes if that is possible.
std::string packed_data(const std::string& fixed, const std::vector<Layer*>& layers,
                        std::size_t most_bytes) {
  std::vector<std::string> texts;
  for (const Layer* layer : layers) texts.push_back(layer->text());
  while (true) {
    std::string whole = "{" + fixed;
    for (const std::string& text : texts) whole += "," + text;
    whole += "}";
    std::string data = files::base64(deflated(whole));
    if (data.size() <= most_bytes) return data;
    // What is left out takes about as many bytes of the data as the rest.
    const double each = static_cast<double>(data.size()) / static_cast<double>(whole.size());
    double size = static_cast<double>(data.size());
    while (size > static_cast<double>(most_bytes)) {
      if (!thin_largest(layers, texts)) return data;
      size = each * static_cast<double>(fixed.size());
      for (const std::string& text : texts) size += each * static_cast<double>(text.size());
    }
  }
}

}  // namespace

RunPage run_page(const std::filesystem::path& recording, const plugin::Host& drives,
                 const PageOptions& options) {
  Film film(drives);
  const RecordedRun run =
      recording::watch_recorded_run(recording, [&](const RecordedRun& state) { film.add(state); });
  film.finish();
  if (film.empty()) {
    throw base::BadInput(
        "'" + recording.string() + "' " +
        (run.missing_end.empty() ? "has no run of Elsie" : "breaks off before its first second") +
        "; expected a recording that `elsie run WORLD --record FILE.mcap` has written to its end");
  }
  const traces::Trace trace = recording::read_trace(recording);
  Decisions decisions(trace);
  Numbers numbers(trace);
  std::vector<Layer*> layers{&decisions, &numbers};
  for (SampledLayer* const layer : film.sampled()) layers.push_back(layer);

  const std::string fixed = "\"end\":" + std::to_string(fine(std::max(run.end_s, trace.end_s))) +
                            "," + events_text(run) + "," + film.text() + "," +
                            picture_text(run, drives);
  const std::size_t rest = std::string_view(kPage).size() + std::string_view(kStyle).size() +
                           std::string_view(kScript).size() + 8192;
  const std::string data =
      packed_data(fixed, layers, options.most_bytes - std::min(rest, options.most_bytes));

  RunPage page;
  page.poses_every_s = run.period_s * film.pose_every();
  page.html =
      filled(kPage, {{"policy", "default-src 'none'; style-src " + files::policy_hash(kStyleHash) +
                                    "; script-src " + files::policy_hash(kScriptHash) +
                                    "; img-src data:; base-uri 'none'; form-action 'none'"},
                     {"style", kStyle},
                     {"script", kScript},
                     {"title", escaped(run.world.empty() ? "a run" : run.world)},
                     {"summary", escaped(subtitle(run))},
                     {"outcome", escaped(run.result ? run.result->outcome : "none")},
                     {"facts", facts(run, page.poses_every_s)},
                     {"data", data}});
  return page;
}

}  // namespace elsie::page
