#include "engine/engine.h"

#include <QSocketNotifier>
#include <exception>

namespace elsie::desktop {
namespace {

constexpr int kBetweenSnapshots_ms = 30;
constexpr int kReport_ms = 3000;  // for writing a report on a busy machine
constexpr int kBetweenLooks_ms = 100;

}  // namespace

Engine::Engine(QString program, QStringList options, QObject* parent)
    : QObject(parent), program_(std::move(program)), options_(std::move(options)) {
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(kBetweenSnapshots_ms);
  connect(&timer_, &QTimer::timeout, this, &Engine::read);
  ending_timer_.setInterval(kBetweenLooks_ms);
  connect(&ending_timer_, &QTimer::timeout, this, &Engine::see_who_ended);
  clock_.start();
}

Engine::~Engine() = default;

void Engine::start() {
  notifier_.reset();
  end_in_background(std::move(connection_));
  pending_.clear();
  std::vector<std::string> options;
  for (const QString& option : options_) {
    options.push_back(option.toStdString());
  }
  connection_ = std::make_unique<client::Connection>(program_.toStdString(), options);
  ++generation_;
  notifier_ = std::make_unique<QSocketNotifier>(connection_->descriptor(), QSocketNotifier::Read);
  connect(notifier_.get(), &QSocketNotifier::activated, this, &Engine::read);
}

void Engine::ask(Json order, Answer answer) {
  if (!connection_) {
    return;
  }
  order["id"] = ++last_id_;
  pending_[last_id_] = {std::move(answer), clock_.elapsed()};
  connection_->send(order);
  pace();
}

void Engine::set_live(bool live) {
  live_ = live;
  pace();
}

void Engine::stop() {
  if (connection_) {
    connection_->quit();
    QTimer::singleShot(kReport_ms, this, [this, generation = generation_] {
      if (connection_ && generation == generation_) {
        connection_->kill();
      }
    });
  }
}

qint64 Engine::waiting_ms() const {
  return pending_.empty() ? 0 : clock_.elapsed() - pending_.begin()->second.since_ms;
}

// The timer stops while nothing moves and nobody waits. While the world moves, messages are read
// only with the next picture: a process that is woken by each message would be put on the same
// processor as the engine.
void Engine::pace() {
  const bool is_needed = connection_ && (live_ || !pending_.empty());
  if (notifier_) {
    notifier_->setEnabled(!live_);
  }
  if (is_needed != timer_.isActive()) {
    is_needed ? timer_.start() : timer_.stop();
  }
}

void Engine::leave(int exit_code, const QString& report) {
  notifier_.reset();
  end_in_background(std::move(connection_));
  pending_.clear();
  pace();
  Q_EMIT died(exit_code, report);
}

void Engine::end_in_background(std::unique_ptr<client::Connection> connection) {
  if (connection) {
    connection->close();
    ending_.push_back(std::move(connection));
    ending_timer_.start();
  }
}

void Engine::see_who_ended() {
  std::erase_if(ending_, [](const auto& each) { return each->ended().has_value(); });
  if (ending_.empty()) {
    ending_timer_.stop();
  }
}

// An engine that sends invalid data has been damaged by a plugin: it is ended here, and nothing is
// thrown through the event loop.
void Engine::read() {
  try {
    read_messages();
  } catch (const std::exception& problem) {
    if (connection_) {
      connection_->kill();
      leave(0, tr("The engine sent an unreadable message: %1").arg(problem.what()));
    }
  }
}

void Engine::read_messages() {
  if (!connection_) {
    return;
  }
  const int generation = generation_;
  for (const Json& message : connection_->receive()) {
    take_snapshot();
    const auto pending = pending_.find(message.value("answer", std::int64_t{0}));
    if (pending != pending_.end()) {
      const Answer answer = std::move(pending->second.answer);
      pending_.erase(pending);
      if (answer) {
        answer(message);
      }
    } else if (message.contains("event")) {
      Q_EMIT event(message);
    }
    if (generation != generation_ || !connection_) {
      return;  // a listener has started it again
    }
  }
  take_snapshot();
  if (const auto end = connection_->ended()) {
    leave(end->exit_code, QString::fromStdString(end->report));
    return;
  }
  pace();
}

void Engine::take_snapshot() {
  if (const auto taken = connection_->snapshots().take()) {
    Q_EMIT snapshot(*taken);
  }
}

}  // namespace elsie::desktop
