// What a recording for viewers and a live view say of a run: channels, schemas and messages in
// JSON. docs/recordings.md describes the channels. Where the messages go is a MessageSink's matter,
// and when samples are taken is the caller's:
//
//   RunMessages messages(sink, options);
//   messages.begin(simulation);                      // before the first step
//   messages.sample(simulation, false, period_s);
//   ...
//   messages.step(simulation);                       // after every step
//   messages.sample(simulation, true, period_s);     // after those in which a sample is due
//   ...
//   messages.end(simulation, true, period_s);
#pragma once

#include <memory>
#include <string>

#include "elsie/recording/formats.h"
#include "elsie/recording/message_sink.h"

namespace elsie::simulation {
class Simulation;
}

namespace elsie::recording {

/// To be called in Observer::ended(): the sentence of what has ended the run, such as a plugin's
/// fault; "" for a run that ended by itself, or that the user stopped.
std::string why_stopped();

class RunMessages {
 public:
  /// The sink must outlive it. RecorderOptions::rate_hz is not used, and warn() gets what is left
  /// out and why: "sketches: plugin ...".
  RunMessages(MessageSink& sink, RecorderOptions options);
  ~RunMessages();

  /// Adds the channels, and says what the world is.
  void begin(const simulation::Simulation& simulation);
  /// Says what happened in a step: decisions that differ from those before, what was heard, events,
  /// boxes that left the scene.
  void step(const simulation::Simulation& simulation);
  /// Says where everything is now. `decided`: also readings, commands and what plugins draw, as of
  /// the last decision. `period_s`: simulated time to the next sample, after which drawings fade.
  void sample(const simulation::Simulation& simulation, bool decided, double period_s);
  /// After an edit or new plugins: robots that are new, or have other behaviours or sensors than
  /// before, get channels of their own from now on.
  void replace(const simulation::Simulation& simulation);
  /// Says the rest: the last events, and the last sample if it was not taken yet.
  void end(const simulation::Simulation& simulation, bool decided, double period_s);

  /// Says the whole present state again, with the events so far (the last thousand), for those who
  /// have not heard it. Changes nothing for the others.
  void repeat(const simulation::Simulation& simulation, double period_s);
  /// Goes on with another simulation of the same world, at any time of it, and says its whole
  /// state. `decided_s`: the time of its last decision.
  void resume(const simulation::Simulation& simulation, double decided_s, double period_s);
  /// The same where the other one has just reached the present state: nothing is said again.
  void follow(const simulation::Simulation& simulation, double decided_s);
  /// The time of the last decision, s.
  double decided_s() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::recording
