// The process that has the simulation and the plugins, for a program with an event loop.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "elsie/client/connection.h"

class QSocketNotifier;

namespace elsie::desktop {

using client::Json;

/// Sends orders to the engine and receives answers and snapshots (docs/internals/session.md); no
/// call waits. When the process ends by itself, died() reports it, and a call of start() starts it
/// again.
class Engine : public QObject {
  Q_OBJECT

 public:
  using Answer = std::function<void(const Json&)>;

  /// `program` is elsie, `options` are its options for plugins.
  Engine(QString program, QStringList options, QObject* parent = nullptr);
  ~Engine() override;

  const QString& program() const { return program_; }
  const QStringList& options() const { return options_; }
  /// Those of the next start.
  void set_options(const QStringList& options) { options_ = options; }

  /// Starts the process; one that is running ends in the background. Throws base::Error if the
  /// program cannot be started.
  void start();
  bool is_there() const { return connection_ != nullptr; }
  /// The number of starts so far.
  int generation() const { return generation_; }
  /// Sends an order. The answer is not called if the engine ends first.
  void ask(Json order, Answer answer = {});
  /// Whether snapshots are expected at any time; otherwise they come with messages.
  void set_live(bool live);
  /// Ends a process that does not answer. Its report names the plugin that was active.
  void stop();
  /// How long the oldest order has been waiting for its answer, ms, by a clock that nobody sets; 0
  /// if none waits.
  qint64 waiting_ms() const;

 Q_SIGNALS:
  void event(const elsie::desktop::Json& message);
  /// The snapshot is valid during the signal.
  void snapshot(const elsie::snapshots::Snapshot& snapshot);
  void died(int exit_code, const QString& report);

 private:
  struct Pending {
    Answer answer;
    qint64 since_ms = 0;
  };

  void read();
  void read_messages();
  void leave(int exit_code, const QString& report);
  void end_in_background(std::unique_ptr<client::Connection> connection);
  void see_who_ended();
  void take_snapshot();
  void pace();

  QString program_;
  QStringList options_;
  std::unique_ptr<client::Connection> connection_;
  std::unique_ptr<QSocketNotifier> notifier_;
  std::vector<std::unique_ptr<client::Connection>> ending_;
  std::map<std::int64_t, Pending> pending_;
  std::int64_t last_id_ = 0;
  int generation_ = 0;
  bool live_ = false;
  QElapsedTimer clock_;
  QTimer timer_;
  QTimer ending_timer_;
};

}  // namespace elsie::desktop
