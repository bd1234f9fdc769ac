#include "elsie/recording/mcap_recorder.h"

#include <cmath>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "elsie/base/number_text.h"
#include "elsie/files/emergency.h"
#include "elsie/mcap/writer.h"
#include "elsie/recording/run_messages.h"
#include "elsie/simulation/fault.h"
#include "elsie/simulation/simulation.h"
#include "elsie/traces/sampling.h"

#include "crowd.h"
#include "format.h"
#include "messages.h"

namespace elsie::recording {
namespace {

using simulation::Simulation;

/// The channels and messages of a file.
class FileSink final : public MessageSink {
 public:
  explicit FileSink(mcap::Writer& out) : out_(out) {}

  std::uint32_t add_schema(const std::string& name, const std::string& text) override {
    return out_.add_schema(name, "jsonschema", text);
  }
  std::uint32_t add_channel(const std::string& topic, std::uint32_t schema,
                            const std::map<std::string, std::string>& metadata) override {
    return out_.add_channel(topic, static_cast<std::uint16_t>(schema), "json", metadata);
  }
  void write(std::uint32_t channel, std::uint64_t time_ns, std::string_view text) override {
    out_.write(static_cast<std::uint16_t>(channel), time_ns, text);
  }

 private:
  mcap::Writer& out_;
};

/// What the messages need to know of the options.
RecorderOptions with_own_words(RecorderOptions options) {
  if (const auto warn = options.warn) {
    options.warn = [warn](const std::string& text) { warn("the recording lacks " + text); };
  }
  return options;
}

class McapRecorder final : public simulation::Observer, private files::EmergencyWriter {
 public:
  McapRecorder(const std::filesystem::path& file, const RecorderOptions& options)
      : options_(checked(options)),
        out_(file, {.library = options_.program}),
        messages_(sink_, with_own_words(options_)) {}

  ~McapRecorder() override { retire(); }

  void started(const Simulation& simulation) override {
    const world::Physics& physics = simulation.world().physics;
    every_ = traces::steps_in(1.0 / options_.rate_hz, physics.step);
    sampling_ = traces::Sampling(static_cast<double>(every_) * physics.step);
    sampling_.is_due(simulation.time_s());
    control_steps_ = static_cast<std::uint64_t>(physics.control_steps);
    write_head(simulation);
    out_.set_last_words(
        {kResultMetadata,
         {{"outcome", kStopped}, {"reason", "the program was brought down in the step after it"}}},
        kEndTime);
    messages_.begin(simulation);
    messages_.sample(simulation, false, sampling_.period_s());
  }

  void stepped(const Simulation& simulation) override {
    messages_.step(simulation);
    if (sampling_.is_due(simulation.time_s())) {
      messages_.sample(simulation, true, sampling_.period_s());
    }
    out_.pass(nanoseconds(simulation.time_s()));
  }

  /// Robots that are new, or have other behaviours or other sensors than before, get channels of
  /// their own from now on.
  void replaced(const Simulation& simulation) override { messages_.replace(simulation); }

  void ended(const Simulation& simulation) override {
    std::exception_ptr fault;
    std::string reason = why_stopped();
    const simulation::RunResult result = result_of(simulation, fault);
    if (reason.empty()) reason = result.reason;
    const bool stopped = fault || result.outcome == simulation::Outcome::running;
    // The last decision may be half of a step that a plugin did not end.
    messages_.end(simulation, !stopped, sampling_.period_s());
    out_.write(mcap::Metadata{kResultMetadata,
                              {{"outcome", stopped ? kStopped : to_string(result.outcome)},
                               {"reason", reason},
                               {kEndTime, base::number_text(result.simulated_s)},
                               {"steps", std::to_string(result.steps)},
                               {"state_hash", simulation::hash_text(result.state_hash)}}});
    write_measures(result);
    out_.close();
    if (fault) {
      std::rethrow_exception(fault);
    }
  }

 private:
  bool write_now() noexcept override { return out_.write_in_emergency(); }

  static const RecorderOptions& checked(const RecorderOptions& options) {
    if (!(options.rate_hz > 0.0) || !std::isfinite(options.rate_hz)) {
      throw std::invalid_argument("a recording needs a positive number of samples a second");
    }
    return options;
  }

  void write_head(const Simulation& simulation) {
    const world::World& world = simulation.world();
    out_.write(mcap::Metadata{kRunMetadata,
                              {{"program", options_.program},
                               {"world", world.name},
                               {"file", world.file},
                               {"seed", std::to_string(simulation.seed())},
                               {"time_limit_s", base::number_text(simulation.time_limit_s())},
                               {"step_s", base::number_text(world.physics.step)},
                               {"control_steps", std::to_string(control_steps_)},
                               {"sample_steps", std::to_string(every_)}}});
  }

  /// A measure that fails at the end has no values; its fault is reported later.
  static simulation::RunResult result_of(const Simulation& simulation, std::exception_ptr& fault) {
    try {
      return simulation.result();
    } catch (const simulation::PluginFault&) {
      fault = std::current_exception();
      return simulation.result();
    }
  }

  void write_measures(const simulation::RunResult& result) {
    mcap::Metadata measures{kMeasuresMetadata, {}};
    for (const simulation::MeasuredValue& measure : result.measures) {
      if (measure.value) {
        measures.values[measure.name] = base::number_text(*measure.value);
      }
    }
    out_.write(measures);
  }
  RecorderOptions options_;
  mcap::Writer out_;
  FileSink sink_{out_};
  RunMessages messages_;
  std::uint64_t every_ = 1;  // steps from one sample to the next, as the run begins
  traces::Sampling sampling_;
  std::uint64_t control_steps_ = 1;  // from one decision to the next
};

}  // namespace

std::unique_ptr<simulation::Observer> mcap_recorder(const std::filesystem::path& file,
                                                    const RecorderOptions& options) {
  return std::make_unique<McapRecorder>(file, options);
}

Format mcap_format() {
  return {.suffix = ".mcap",
          .description = "a recording for viewers, `elsie replay` and `elsie explain`",
          .mark = "\x89MCAP",
          .maker = "elsie",
          .images = true,
          .most_robots = kMostWithChannels,
          .recorder = mcap_recorder};
}

}  // namespace elsie::recording
