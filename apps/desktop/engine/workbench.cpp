#include "engine/workbench.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QFileSystemWatcher>
#include <QSaveFile>
#include <QTimer>

#include "elsie/base/error.h"

namespace elsie::desktop {
namespace {

constexpr int kMostDeaths = 2;  // in a row; after that nothing is opened by itself

QString text_at(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string()
             ? QString::fromStdString(found->get<std::string>())
             : QString();
}

Json list_of(const QStringList& texts) {
  Json list = Json::array();
  for (const QString& each : texts) {
    list.push_back(each.toStdString());
  }
  return list;
}

std::optional<QByteArray> bytes_of(const QString& file) {
  QFile opened(file);
  if (!opened.open(QIODevice::ReadOnly)) {
    return std::nullopt;
  }
  return opened.readAll();
}

}  // namespace

Problems problems_of(const Json& answer) {
  Problems problems;
  for (const char* list : {"refused", "problems"}) {
    for (const Json& each : answer.value(list, Json::array())) {
      problems.push_back({text_at(each, "file"), each.value("line", 0), text_at(each, "message")});
    }
  }
  return problems;
}

Workbench::Workbench(QString elsie, QStringList options, QObject* parent)
    : QObject(parent),
      engine_(std::move(elsie), std::move(options)),
      on_disk_watcher_(std::make_unique<QFileSystemWatcher>()) {
  connect(&engine_, &Engine::event, this, &Workbench::heard);
  connect(&engine_, &Engine::died, this, &Workbench::lost);
  connect(&engine_, &Engine::snapshot, this, [this](const snapshots::Snapshot& taken) {
    time_s_ = taken.facts.time_s;
    pace_ = taken.facts.pace;
    Q_EMIT snapshot(taken);
  });
  connect(on_disk_watcher_.get(), &QFileSystemWatcher::fileChanged, this, [this] {
    if (is_changed_on_disk()) {
      Q_EMIT changed_on_disk();
    }
    watch_file();  // a file that was replaced is not watched any more
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
  engine_.start();
  load_catalog();
}

void Workbench::load_catalog() {
  engine_.ask({{"do", "catalog"}}, [this](const Json& answer) {
    catalog_ = Catalog(answer);
    Q_EMIT catalog_changed();
  });
}

// Files

void Workbench::open_text(const QString& text, const QString& file, bool is_saved) {
  file_ = file;
  text_ = text;
  history_text_ = text;
  history_.clear();
  if (!is_saved) {
    history_.set_dirty();
  }
  on_disk_ = is_saved && !file.isEmpty() ? bytes_of(file).value_or(QByteArray()) : QByteArray();
  tree_ = scene_ = Json();
  is_right_ = false;
  deaths_ = 0;
  watch_file();
  open_in_engine();
  Q_EMIT history_changed();
}

bool Workbench::open(const QString& file, QString& why, std::optional<std::uint64_t> seed) {
  QFile opened(file);
  if (!opened.open(QIODevice::ReadOnly)) {
    why = tr("'%1' cannot be read: %2").arg(file, opened.errorString());
    return false;
  }
  seed_ = seed.value_or(seed_);
  open_text(QString::fromUtf8(opened.readAll()), QFileInfo(file).absoluteFilePath());
  return true;
}

void Workbench::open_in_engine() {
  set_run(Run::none);
  const QString text = text_;
  if (!engine_.is_there()) {
    start_engine();
  }
  engine_.ask({{"do", "open"},
               {"text", text.toStdString()},
               {"file", file_.toStdString()},
               {"seed", seed_}},
              [this, text](const Json& answer) {
                if (answer.contains("refused")) {
                  is_right_ = false;
                  deaths_ = 0;
                  set_problems(problems_of(answer));
                  Q_EMIT described();
                } else {
                  history_text_ = text;
                  engine_.ask({{"do", "speed"}, {"factor", speed_}});
                  take(answer);
                  set_run(Run::ready);
                }
              });
}

void Workbench::watch_file() {
  if (!on_disk_watcher_->files().isEmpty()) {
    on_disk_watcher_->removePaths(on_disk_watcher_->files());
  }
  if (!file_.isEmpty() && QFileInfo::exists(file_)) {
    on_disk_watcher_->addPath(file_);
  }
}

bool Workbench::is_changed_on_disk() const {
  if (file_.isEmpty()) {
    return false;
  }
  const auto now = bytes_of(file_);
  return now && *now != on_disk_;
}

void Workbench::save_as(const QString& file, std::function<void(const QString&)> done) {
  const QString target = QFileInfo(file).absoluteFilePath();
  const auto write = [this, target, done](const QString& text, bool leads_on) {
    QSaveFile saved(target);
    saved.setDirectWriteFallback(false);
    const QByteArray bytes = text.toUtf8();
    if (!saved.open(QIODevice::WriteOnly) || saved.write(bytes) != bytes.size() ||
        !saved.commit()) {
      done(tr("The world could not be saved as '%1': %2. What was there before is unchanged.")
               .arg(target, saved.errorString()));
      return;
    }
    on_disk_ = bytes;
    file_ = target;
    if (!leads_on) {
      open_text(text, target);
    }
    history_.set_clean();
    watch_file();
    recovery_.forget();
    Q_EMIT history_changed();
    done({});
  };
  if (!is_right_) {
    write(text_, true);
    return;
  }
  const QString now = text_;
  engine_.ask({{"do", "text_for"}, {"file", target.toStdString()}}, [this, now, write,
                                                                     done](const Json& answer) {
    if (answer.contains("refused")) {
      const Problems problems = problems_of(answer);
      done(problems.empty() ? tr("The engine has no text for it.") : problems.front().message);
      return;
    }
    const QString text = text_at(answer, "text");
    write(text, text == now);
  });
}

// Changes

void Workbench::take(const Json& answer) {
  deaths_ = 0;
  is_right_ = true;
  text_ = history_text_ = text_at(answer, "text");
  tree_ = answer.value("tree", Json());
  scene_ = answer.value("scene", Json());
  epoch_ = answer.value("epoch", std::uint64_t{0});
  set_problems({});
  if (run_ == Run::ended) {
    set_run(Run::ready);
  }
  Q_EMIT described();
}

void Workbench::set_problems(Problems problems) {
  problems_ = std::move(problems);
  Q_EMIT problems_changed();
}

void Workbench::refuse(const Json& answer, const Refused& hears) {
  const Problems problems = problems_of(answer);
  if (hears) {
    hears(problems);
  }
  Q_EMIT refused(problems);
}

void Workbench::edit(const QStringList& edits, const QString& name, const QString& merge,
                     Refused hears) {
  if (!is_right_ || text_ != history_text_) {
    refuse({{"refused",
             {{{"message",
                tr("The text of the world has mistakes; mend them first, or undo what was typed.")
                    .toStdString()}}}}},
           hears);
    return;
  }
  engine_.ask({{"do", "edit"}, {"edits", list_of(edits)}},
              [this, name, merge, hears](const Json& answer) {
                if (answer.contains("refused")) {
                  refuse(answer, hears);
                  return;
                }
                const QString before = history_text_;
                take(answer);
                history_.push({name, merge, before, text_, answer.value("undo", std::uint64_t{0}),
                               engine_.generation(), QDateTime::currentMSecsSinceEpoch()});
                keep();
                Q_EMIT history_changed();
              });
}

void Workbench::type(const QString& text) {
  if (text == text_) {
    return;
  }
  text_ = text;
  keep();
  Q_EMIT history_changed();
  if (tree_.is_null()) {
    history_.set_dirty();
    open_in_engine();
    return;
  }
  engine_.ask({{"do", "become"}, {"text", text.toStdString()}}, [this, text](const Json& answer) {
    if (text != text_) {
      // More was typed since. If the engine has this text, that is where the next one starts.
      if (!answer.contains("refused")) {
        history_.push({tr("type"), "type", history_text_, text, 0, engine_.generation(),
                       QDateTime::currentMSecsSinceEpoch()});
        history_text_ = text;
      }
      return;
    }
    if (answer.contains("refused")) {
      set_problems(problems_of(answer));
      return;
    }
    const QString before = history_text_;
    take(answer);
    if (before != text_) {
      history_.push({tr("type"), "type", before, text_, answer.value("undo", std::uint64_t{0}),
                     engine_.generation(), QDateTime::currentMSecsSinceEpoch()});
    }
    Q_EMIT history_changed();
  });
}

QString Workbench::undo_name() const {
  if (text_ != history_text_) {
    return tr("type");
  }
  const History::Entry* entry = history_.next_undo();
  return entry ? entry->name : QString();
}

QString Workbench::redo_name() const {
  const History::Entry* entry = history_.next_redo();
  return entry && text_ == history_text_ ? entry->name : QString();
}

void Workbench::lead(const QString& text, std::uint64_t inverse, int engine,
                     std::function<void(std::uint64_t)> done) {
  is_leading_ = true;
  Json order{{"do", "undo"}, {"edit", inverse}};
  if (inverse == 0 || engine != engine_.generation()) {
    order = {{"do", "become"}, {"text", text.toStdString()}};
  }
  engine_.ask(order, [this, done](const Json& answer) {
    is_leading_ = false;
    if (answer.contains("refused")) {
      refuse(answer, {});
      return;
    }
    take(answer);
    done(answer.value("undo", std::uint64_t{0}));
    keep();
    Q_EMIT history_changed();
  });
}

void Workbench::undo() {
  if (text_ != history_text_) {  // what was typed is no world: it goes
    text_ = history_text_;
    set_problems({});
    keep();
    Q_EMIT described();
    Q_EMIT history_changed();
    return;
  }
  const History::Entry* entry = history_.next_undo();
  if (entry && !is_leading_) {
    lead(entry->before, entry->inverse, entry->engine,
         [this](std::uint64_t inverse) { history_.undone(inverse, engine_.generation()); });
  }
}

void Workbench::redo() {
  const History::Entry* entry = history_.next_redo();
  if (entry && !is_leading_ && text_ == history_text_) {
    lead(entry->after, entry->inverse, entry->engine,
         [this](std::uint64_t inverse) { history_.redone(inverse, engine_.generation()); });
  }
}

void Workbench::keep() {
  if (is_modified()) {
    recovery_.keep(file_, text_);
  } else {
    recovery_.forget();
  }
}

// The run

void Workbench::set_run(Run run) {
  if (run_ != run) {
    run_ = run;
    engine_.set_live(run == Run::running);
    if (run != Run::running) {
      pace_ = 0.0;
    }
    Q_EMIT run_changed();
  }
}

void Workbench::run() {
  if (run_ == Run::ready || run_ == Run::paused) {
    engine_.ask({{"do", "run"}});
    set_run(Run::running);
  }
}

void Workbench::pause() {
  if (run_ == Run::running) {
    engine_.ask({{"do", "pause"}}, [this](const Json&) {
      if (run_ == Run::running) {
        set_run(Run::paused);
      }
    });
  }
}

void Workbench::step() {
  if (run_ == Run::ready || run_ == Run::paused) {
    engine_.ask({{"do", "step"}}, [this](const Json&) {
      if (run_ == Run::ready) {
        set_run(Run::paused);
      }
    });
  }
}

void Workbench::reset(std::uint64_t seed) {
  seed_ = seed;
  if (!is_right_) {
    return;
  }
  engine_.ask({{"do", "reset"}, {"seed", seed}}, [this](const Json& answer) {
    if (answer.contains("refused")) {
      refuse(answer, {});
      return;
    }
    scene_ = answer.value("scene", Json());
    epoch_ = answer.value("epoch", std::uint64_t{0});
    time_s_ = 0.0;
    set_run(Run::ready);
    Q_EMIT described();
    Q_EMIT run_changed();
  });
}

void Workbench::set_speed(double factor) {
  speed_ = factor;
  engine_.ask({{"do", "speed"}, {"factor", factor}});
  Q_EMIT run_changed();
}

void Workbench::heard(const Json& event) {
  const std::string what = event.value("event", std::string());
  if (what == "state") {
    Q_EMIT state(event);
  } else if (what == "note") {
    Q_EMIT noted(text_at(event, "text"));
  } else if (what == "raised") {
    Q_EMIT raised(event);
  } else if (what == "ended") {
    set_run(Run::ended);
    Q_EMIT ended(event);
  } else if (what == "plugins") {
    load_catalog();
  }
}

void Workbench::lost(int exit_code, const QString& report) {
  is_leading_ = false;
  ++deaths_;
  const QString said = report.trimmed().isEmpty()
                           ? tr("The engine ended with exit code %1.").arg(exit_code)
                           : report.trimmed();
  try {
    start_engine();
  } catch (const base::Error& error) {
    set_run(Run::none);
    set_problems({{{}, 0, QString::fromStdString(error.what())}});
    Q_EMIT engine_lost(said);
    return;
  }
  if (deaths_ >= kMostDeaths) {
    is_right_ = false;
    tree_ = scene_ = Json();
    set_run(Run::none);
    set_problems({{file_, 0, tr("The engine ended when it opened this world: %1").arg(said)}});
    Q_EMIT described();
  } else {
    const QString typed = text_;
    text_ = history_text_;
    open_in_engine();
    if (typed != history_text_) {
      type(typed);
    }
  }
  Q_EMIT engine_lost(said);
}

}  // namespace elsie::desktop
