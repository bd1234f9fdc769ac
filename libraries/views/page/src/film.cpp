#include "film.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include <nlohmann/json.hpp>
#include <zlib.h>

#include "elsie/base/number_text.h"
#include "elsie/files/base64.h"
#include "elsie/files/clean_text.h"
#include "elsie/picture/bodies.h"
#include "elsie/render/sketch_style.h"
#include "elsie/world/escaped.h"

#include "scenes.h"

namespace elsie::page {

using recording::RecordedRun;

std::string escaped(std::string_view text) { return world::escaped_attribute(files::clean(text)); }

namespace {

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
  const bool says_why = outcome == "stopped" || outcome == "failure";
  return (outcome == "time_limit" ? "time limit" : outcome) + " after " +
         base::fixed_text(run.result->simulated_s, 1) + " s" +
         (says_why && !run.result->reason.empty() ? ": " + run.result->reason : "");
}

std::string subtitle(const RecordedRun& run) {
  return ending(run) + "  (seed " + std::to_string(run.seed) + ")";
}

/// What the page says about itself, as a list of terms.
std::string facts_text(const RecordedRun& run, const Film::Facts& more) {
  std::string out;
  const auto add = [&](const std::string& name, const std::string& value) {
    if (!value.empty()) {
      out += "<dt>" + escaped(name) + "</dt><dd>" + escaped(value) + "</dd>\n";
    }
  };
  add("world", run.world);
  add("file", std::filesystem::path(run.world_file).filename().string());
  add("seed", std::to_string(run.seed));
  add("outcome", run.result ? run.result->outcome : ending(run));
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
  for (const auto& [name, value] : more) add(name, value);
  return out;
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
  for (bool can_thin = true;;) {
    std::string whole = "{" + fixed;
    for (const std::string& text : texts) whole += "," + text;
    whole += "}";
    std::string data = files::base64(deflated(whole));
    if (data.size() <= most_bytes || !can_thin) return data;
    // What is left out takes about as many bytes of the data as the rest.
    const double each = static_cast<double>(data.size()) / static_cast<double>(whole.size());
    double size = static_cast<double>(data.size());
    while (size > static_cast<double>(most_bytes) && (can_thin = thin_largest(layers, texts))) {
      size = each * static_cast<double>(fixed.size());
      for (const std::string& text : texts) size += each * static_cast<double>(text.size());
    }
  }
}

}  // namespace

void Film::add(const RecordedRun& run) {
  if (run.world_xml.empty()) return;
  if (times_.empty() || run.world_xml != world_xml_) {
    world_xml_ = run.world_xml;
    world_ = picture::bodies_of(run.world_xml, run.world_file, drives_);
    if (times_.empty()) first_world_ = world_;
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

/// What stays.
std::string Film::scenes_text() const {
  std::string out = "\"times\":";
  append_differences(out, times_);
  out += ",\"scenes\":[";
  for (std::size_t i = 0; i < scenes_.size(); ++i) {
    out += (i > 0 ? "," : "") + ("{\"from\":" + std::to_string(scenes_[i].sample)) + "," +
           scenes_[i].value.substr(1);
  }
  return out += "],\"images\":" + nlohmann::json(images_).dump();
}

namespace {

/// How sketches look, by their roles: colour, opacity, width and dashes in pixels.
std::string roles_text() {
  auto roles = nlohmann::ordered_json::array();
  for (const render::SketchStyle& style : render::kSketchStyles) {
    const auto& [red, green, blue] = style.colour;
    roles.push_back({{red, green, blue}, style.opacity, style.width, style.dash});
  }
  return "\"roles\":" + roles.dump();
}

}  // namespace

PageRun Film::page_run(const RecordedRun& whole, double end_s, const std::vector<Layer*>& others,
                       const std::string& exactness, const Facts& more, std::size_t most_bytes) {
  std::vector<Layer*> layers = others;
  for (SampledLayer* const layer : sampled()) {
    layer->settle();
    layers.push_back(layer);
  }
  // The picture from above, at the end, for browsers without WebGL and for print.
  constexpr picture::Size kPicture{900, 0};
  const std::string svg = recording::picture_svg(whole, drives_, {subtitle(whole)}, kPicture);
  const std::string fixed = "\"end\":" + std::to_string(fine(end_s)) + "," + events_text(whole) +
                            "," + scenes_text() + "," + roles_text() +
                            ",\"picture\":" + nlohmann::json(svg).dump();

  PageRun run;
  run.data = packed_data(fixed, layers, most_bytes);
  run.poses_every_s = whole.period_s * poses_.every();
  const std::string file = std::filesystem::path(whole.world_file).stem().string();
  run.title = escaped(!whole.world.empty() ? whole.world : !file.empty() ? file : "a run");
  run.summary = escaped(subtitle(whole));
  run.outcome = escaped(whole.result ? whole.result->outcome : "none");
  Facts facts = more;
  facts.insert(facts.end() - (more.empty() ? 0 : 1),
               {"sampling",
                "poses every " + base::number_text(run.poses_every_s, 6) + " s, to " + exactness});
  run.facts = facts_text(whole, facts);
  return run;
}

}  // namespace elsie::page
