#include "engine/workbench.h"

#include <QCoreApplication>
#include <QFileSystemWatcher>
#include <QRegularExpression>
#include <algorithm>
#include <csignal>
#include <iterator>
#include <utility>

#include "elsie/base/error.h"

#include "engine/compiler_messages.h"

// The engine and its messages.

namespace elsie::desktop {
namespace {

constexpr int kMostDeaths = 3;
constexpr int kKilled = 128 + SIGKILL;
constexpr int kGone_ms = 300;
constexpr std::size_t kMostListed = 200;  // a user fixes the first ones first

Problems listed(const Json& object, const char* list, bool are_warnings) {
  Problems problems;
  const Json& all = member(object, list);
  for (const Json& each : all) {
    if (problems.size() == kMostListed) {
      problems.push_back({{},
                          0,
                          QCoreApplication::translate("elsie::desktop::Workbench", "And %1 more.")
                              .arg(all.size() - kMostListed),
                          are_warnings});
      break;
    }
    // A world that was never saved has lines, but no file.
    static const QRegularExpression only_line("\\(:(\\d+)\\)");
    const QString message = text_of(each, "message").replace(only_line, "(line \\1)");
    problems.push_back({text_of(each, "file"), each.value("line", 0), message, are_warnings});
  }
  return problems;
}

QStringList names_in(const Json& event, const char* list) {
  QStringList names;
  for (const Json& each : member(event, list)) names << written(each);
  return names;
}

}  // namespace

Problems problems_of(const Json& answer) {
  Problems problems = listed(answer, "refused", false);
  const Problems others = listed(answer, "problems", false);
  problems.insert(problems.end(), others.begin(), others.end());
  return problems;
}

QString cause_in(const QString& report) {
  const QString program = "elsie: ";
  const QStringList lines = report.trimmed().split('\n');
  for (const QString& line : lines) {
    if (line.startsWith(program)) {
      return line.mid(program.size());
    }
  }
  return lines.front();
}

bool names_plugin(const QString& report) { return cause_in(report).startsWith("plugin "); }

Workbench::Workbench(QString elsie, QStringList options, QObject* parent)
    : QObject(parent),
      engine_(std::move(elsie), std::move(options)),
      on_disk_watcher_(std::make_unique<QFileSystemWatcher>()) {
  connect(&engine_, &Engine::event, this, &Workbench::heard);
  connect(&engine_, &Engine::died, this, &Workbench::lost);
  connect(&engine_, &Engine::snapshot, this, [this](const snapshots::Snapshot& taken) {
    if (is_current(taken.facts.epoch)) {
      time_s_ = taken.facts.time_s;
      latest_s_ = std::max(latest_s_, time_s_);
      pace_ = taken.facts.pace;
      Q_EMIT snapshot(taken);
    }
  });
  gone_timer_.setSingleShot(true);
  gone_timer_.setInterval(kGone_ms);
  connect(&gone_timer_, &QTimer::timeout, this, [this] { set_gone(true); });
  connect(on_disk_watcher_.get(), &QFileSystemWatcher::fileChanged, this, &Workbench::look_at_disk);
  connect(on_disk_watcher_.get(), &QFileSystemWatcher::directoryChanged, this, [this] {
    if (on_disk_watcher_->files().isEmpty()) {  // the file was missing
      look_at_disk();
    }
  });
  start_engine();
}

Workbench::~Workbench() {
  engine_.disconnect(this);
  if (!is_modified()) {
    recovery_.forget();
  }
}

void Workbench::start_engine() {
  is_stopping_ = is_stepping_ = false;
  engine_.start();
  had_world_ = false;
  epoch_ = 0;  // each engine has its own count
  plugin_problems_.clear();
  load_catalog();
}

void Workbench::load_catalog() {
  engine_.ask({{"do", "catalog"}}, [this](const Json& answer) {
    catalog_ = Catalog(answer);
    Q_EMIT catalog_changed();
  });
}

void Workbench::stop_engine() {
  deaths_ = 0;
  is_stopping_ = engine_.is_there();
  engine_.stop();
}

void Workbench::open_in_engine(const QString& text) {
  set_run(Run::none);
  if (!engine_.is_there() || had_world_) {  // plugins' threads may end it later
    try {
      start_engine();
    } catch (const base::Error& error) {
      keep_as_text(QString::fromStdString(error.what()));
      end_change();
      return;
    }
  }
  under_way_ = text;
  order({{"do", "open"},
         {"text", text.toStdString()},
         {"file", file_.toStdString()},
         {"seed", seed_}},
        [this, text](const Json& answer) {
          under_way_.clear();  // it has been read
          had_world_ = !answer.contains("refused") || answer.value("made_plugins", true);
          if (answer.contains("refused")) {
            tree_ = scene_ = Json();
            warnings_.clear();
            set_problems(problems_of(answer));
            Q_EMIT described();
          } else {
            engine_.ask({{"do", "speed"}, {"factor", speed_}});
            take(answer, text);
            set_run(Run::ready);
          }
          Q_EMIT history_changed();
          end_change();
        });
}

/// `sent` is the text when the order was sent; anything typed since then stays.
void Workbench::describe(const Json& answer, const QString& sent) {
  history_text_ = text_of(answer, "text");
  if (text_ == sent) {
    text_ = history_text_;
  }
  tree_ = answer.value("tree", Json());
  scene_ = answer.value("scene", Json());
  epoch_ = answer.value("epoch", std::uint64_t{0});
  warnings_ = listed(answer, "warnings", true);
  set_problems(text_ == history_text_ ? Problems() : problems_);
  Q_EMIT described();
}

void Workbench::take(const Json& answer, const QString& sent) {
  if (run_ == Run::ended) {
    set_run(Run::ready);
  }
  describe(answer, sent);
}

Problems Workbench::remarks() const {
  Problems all = problems_of_plugins();
  all.insert(all.end(), warnings_.begin(), warnings_.end());
  return all;
}

void Workbench::set_problems(Problems problems) {
  problems_ = std::move(problems);
  Q_EMIT problems_changed();
}

void Workbench::heard(const Json& event) {
  const std::string what = event.value("event", std::string());
  if (what == "state") {
    if (is_current(event.value("epoch", epoch_))) Q_EMIT state(event);
  } else if (what == "stuck") {
    if (is_current(event.value("epoch", epoch_))) Q_EMIT stuck(event);
  } else if (what == "note") {
    Q_EMIT noted(text_of(event, "text"));
  } else if (what == "raised") {
    Q_EMIT raised(event);
  } else if (what == "paused") {
    if (run_ == Run::running) set_run(Run::paused);
    Q_EMIT came_to(event);
  } else if (what == "ended") {
    set_run(Run::ended);
    Q_EMIT ended(event);
  } else if (what == "plugins") {
    take_plugin_problems(event);
    load_catalog();
    if (event.contains("tree")) {
      describe(event, history_text_);
    } else {
      Q_EMIT problems_changed();
    }
    take_plugins(event);
  }
}

/// Replaces what is listed about the plugins that the event or one of its messages names; what is
/// wrong with others stays.
void Workbench::take_plugin_problems(const Json& event) {
  const QStringList used = names_in(event, "files") + names_in(event, "restored");
  const QStringList kept = names_in(event, "kept");
  QStringList wrong = kept;  // also what was kept earlier, and has another mistake now
  for (const PluginProblem& each : plugin_problems_) {
    for (const QString& file : each.plugins) {
      if (!used.contains(file) && !wrong.contains(file)) wrong << file;
    }
  }
  std::vector<PluginProblem> now;
  QStringList named = used + kept;
  for (const Json& each : member(event, "problems")) {
    const QString message = written(each);
    const Problem first = problems_in(message).front();
    QStringList plugins;
    std::copy_if(wrong.begin(), wrong.end(), std::back_inserter(plugins),
                 [&message](const QString& file) { return message.contains(file); });
    named += plugins;
    now.push_back({{first.file, first.line, message}, plugins.isEmpty() ? kept : plugins});
  }
  std::erase_if(plugin_problems_, [&named](const PluginProblem& each) {
    return each.plugins.isEmpty() ||
           std::any_of(each.plugins.begin(), each.plugins.end(),
                       [&named](const QString& file) { return named.contains(file); });
  });
  plugin_problems_.insert(plugin_problems_.end(), now.begin(), now.end());
}

Problems Workbench::problems_of_plugins() const {
  Problems all;
  for (const PluginProblem& each : plugin_problems_) all.push_back(each.problem);
  return all;
}

/// A plugin that was to be added is there, or is refused; or others have changed.
void Workbench::take_plugins(const Json& event) {
  const QStringList files = names_in(event, "files") + names_in(event, "restored");
  const QStringList kept = names_in(event, "kept");
  if (!awaited_.isEmpty() && (files.contains(awaited_) || kept.contains(awaited_))) {
    const QString awaited = std::exchange(awaited_, QString());
    Problems own;
    for (const PluginProblem& each : plugin_problems_) {
      if (each.plugins.contains(awaited)) own.push_back(each.problem);
    }
    const bool is_used = files.contains(awaited);
    end_change(is_used ? Problems() : own.empty() ? problems_of_plugins() : own);
  }
  Q_EMIT plugins_changed(files, kept);
}

void Workbench::add_plugin(const QString& file, QObject* receiver, Done done) {
  Q_EMIT about_to_change();
  deaths_ = 0;
  in_turn(
      [this, file] {
        const QStringList option{QStringLiteral("--draft"), file};
        if (engine_.options().contains(file)) {
          end_change();
          return;
        }
        engine_.set_options(engine_.options() + option);
        awaited_ = file;
        order({{"do", "plugin"}, {"file", file.toStdString()}}, [this](const Json& answer) {
          if (answer.contains("refused")) {
            awaited_.clear();
            end_change(problems_of(answer));
          }  // otherwise an event says how it went
        });
      },
      false, receiver, std::move(done));
}

/// Keeps the world as a text only, because no engine accepts it.
void Workbench::keep_as_text(const QString& why) {
  tree_ = scene_ = Json();
  warnings_.clear();
  const Problem first = problems_in(why).front();
  set_problems({{first.line > 0 ? first.file : file_, first.line, why}});
  Q_EMIT described();
  Q_EMIT history_changed();
}

void Workbench::lost(int exit_code, const QString& report) {
  ++deaths_;
  if (!awaited_.isEmpty()) {  // it may end every engine that loads it
    QStringList options = engine_.options();
    options.remove(options.indexOf(awaited_) - 1, 2);
    engine_.set_options(options);
    awaited_.clear();
  }
  const bool was_stopped = std::exchange(is_stopping_, false);
  const QString said = !report.trimmed().isEmpty() ? report.trimmed()
                       : was_stopped               ? tr("No plugin was active.")
                       : exit_code == kKilled
                           ? tr("It was killed from outside, for example for lack of memory.")
                           : tr("The engine ended with exit code %1.").arg(exit_code);
  const QString deadly = under_way_;
  const bool was_busy = is_busy();
  const bool is_deadly = !had_world_ && !deadly.isEmpty() && deadly == history_text_;
  std::deque<Change> waiting = take_waiting();
  const QString why = tr("The engine ended before this was done: %1").arg(cause_in(said));
  QStringList not_made = drop_changes(why);
  const auto give_up = [&] {
    changes_.swap(waiting);
    not_made += drop_changes(why);
  };
  set_run(Run::none);
  try {
    if (deaths_ > kMostDeaths) {
      throw base::Error(tr("The engine ends as soon as it starts: %1").arg(said).toStdString());
    }
    start_engine();
  } catch (const base::Error& error) {
    keep_as_text(QString::fromStdString(error.what()));
    give_up();
    Q_EMIT engine_lost(said, was_stopped, not_made);
    return;
  }
  const QString cause = was_stopped
                            ? tr("You stopped the engine while it read this world: %1").arg(said)
                            : tr("The engine ended when it read this world: %1").arg(said);
  if (is_deadly) {
    keep_as_text(cause);
    give_up();
    if (text_ != history_text_) {  // typed since
      in_turn([this] { send_typed(); }, true);
    }
  } else if (deaths_ == kMostDeaths && !text_.isEmpty()) {
    keep_as_text(tr("The engine ended %1 times with this world, which is not opened again until "
                    "you change it: %2")
                     .arg(deaths_)
                     .arg(said));
    give_up();
  } else if (!text_.isEmpty()) {
    in_turn([this] { open_in_engine(history_text_); });
    if (!was_busy && !deadly.isEmpty() && deadly == text_ && text_ != history_text_) {
      in_turn([this, cause] {
        set_problems({{file_, 0, cause}});
        end_change();
      });
    } else if (text_ != history_text_) {
      in_turn([this] { send_typed(); });
    }
    std::move(waiting.begin(), waiting.end(), std::back_inserter(changes_));
  }
  Q_EMIT engine_lost(said, was_stopped, not_made);
}

}  // namespace elsie::desktop
