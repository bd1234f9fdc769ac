#include "engine/workbench.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QFileSystemWatcher>
#include <QStringDecoder>
#include <cerrno>

#include "elsie/base/error.h"
#include "elsie/base/write_whole.h"

namespace elsie::desktop {
namespace {

constexpr int kMostDeaths = 3;  // in a row; after that it is not started again by itself

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

constexpr auto kMark = "\xEF\xBB\xBF";  // that Windows writes before UTF-8

bool is_utf8(const QByteArray& bytes) {
  QStringDecoder decoder(QStringDecoder::Utf8);
  const QString text = decoder(bytes);
  return !decoder.hasError();
}

/// The first line, from 1, that is no UTF-8; 0: all are.
int line_without_utf8(const QByteArray& bytes) {
  if (is_utf8(bytes)) {
    return 0;
  }
  int number = 1;
  for (const QByteArray& line : bytes.split('\n')) {
    if (!is_utf8(line)) {
      return number;
    }
    ++number;
  }
  return 1;
}

QString folder_of(const QString& file) { return QFileInfo(file).absolutePath(); }

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
  had_world_ = false;
  load_catalog();
}

void Workbench::load_catalog() {
  engine_.ask({{"do", "catalog"}}, [this](const Json& answer) {
    catalog_ = Catalog(answer);
    deaths_ = 0;
    Q_EMIT catalog_changed();
  });
}

// Files

void Workbench::open_text(const QString& text, const QString& file, bool is_saved) {
  drop_changes(tr("Another world was opened before this was done."));
  file_ = file;
  text_ = text;
  history_text_ = text;
  history_.clear();
  has_mark_ = has_carriages_ = false;
  on_disk_ = is_saved && !file.isEmpty() ? bytes_of(file).value_or(QByteArray()) : QByteArray();
  if (!is_saved) {
    history_.set_dirty();
    keep();
  }
  tree_ = scene_ = Json();
  is_right_ = false;
  watch_file();
  in_turn([this] { open_in_engine(text_); });
  Q_EMIT history_changed();
}

bool Workbench::open(const QString& file, QString& why, std::optional<std::uint64_t> seed) {
  QFile opened(file);
  if (!opened.open(QIODevice::ReadOnly)) {
    why = tr("'%1' cannot be read: %2").arg(file, opened.errorString());
    return false;
  }
  QByteArray bytes = opened.readAll();
  if (const int line = line_without_utf8(bytes); line > 0) {
    why = tr("'%1' is no text in UTF-8: line %2 has other bytes. Convert it first, for example "
             "with: iconv -f latin1 -t utf-8")
              .arg(file)
              .arg(line);
    return false;
  }
  const bool has_mark = bytes.startsWith(kMark);
  if (has_mark) {
    bytes.remove(0, 3);
  }
  const bool has_carriages = bytes.count('\n') > 0 && bytes.count("\r\n") == bytes.count('\n');
  seed_ = seed.value_or(seed_);
  open_text(QString::fromUtf8(bytes).replace("\r\n", "\n"), QFileInfo(file).absoluteFilePath());
  has_mark_ = has_mark;
  has_carriages_ = has_carriages;
  return true;
}

void Workbench::open_in_engine(const QString& text) {
  set_run(Run::none);
  if (!engine_.is_there() || had_world_) {  // threads of its plugins may end the engine later
    try {
      start_engine();
    } catch (const base::Error& error) {
      set_problems({{{}, 0, QString::fromStdString(error.what())}});
      Q_EMIT described();
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
          had_world_ = true;
          if (answer.contains("refused")) {
            is_right_ = false;
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

QString Workbench::write(const QString& file, const QString& text) {
  QString lines = text;
  if (has_carriages_) {
    lines.replace("\n", "\r\n");
  }
  const QByteArray bytes = (has_mark_ ? QByteArray(kMark) : QByteArray()) + lines.toUtf8();
  // Without a second file beside it, a full disk would take the one that is there.
  const int error =
      QFileInfo(folder_of(file)).isWritable()
          ? base::write_whole(file.toStdString(), bytes.toStdString(), base::Durable::yes)
          : EACCES;
  if (error != 0) {
    return tr("The world could not be saved as '%1': %2. What was there before is unchanged.")
        .arg(file, qt_error_string(error));
  }
  on_disk_ = bytes;
  return {};
}

void Workbench::save_as(const QString& file, std::function<void(const QString&)> done) {
  Q_EMIT about_to_change();
  const QString target = QFileInfo(file).absoluteFilePath();
  const auto save = [this, target](const QString& text) {
    if (const QString why = write(target, text); !why.isEmpty()) {
      end_change({{target, 0, why}});
      return;
    }
    const QByteArray bytes = on_disk_;
    const bool has_mark = has_mark_, has_carriages = has_carriages_;
    file_ = target;
    recovery_.forget();
    if (text == text_) {
      history_.set_clean();
      watch_file();
      Q_EMIT history_changed();
      end_change();
      return;
    }
    const Change saved = std::move(changes_.front());  // opening drops the others
    changes_.pop_front();
    open_text(text, target);
    on_disk_ = bytes;
    has_mark_ = has_mark;
    has_carriages_ = has_carriages;
    saved.done({});
  };
  in_turn(
      [this, target, save] {
        if (!is_right_ || text_ != history_text_ || folder_of(target) == folder_of(file_)) {
          save(text_);
          return;
        }
        order({{"do", "text_for"}, {"file", target.toStdString()}},
              [this, save](const Json& answer) {
                if (answer.contains("refused")) {
                  end_change(problems_of(answer));
                } else {
                  save(text_at(answer, "text"));
                }
              });
      },
      this,
      [done](const Problems& problems) {
        done(problems.empty() ? QString() : problems.front().message);
      });
}

// Changes

void Workbench::in_turn(std::function<void()> begin, QObject* receiver, Done done) {
  changes_.push_back({std::move(begin), receiver, receiver != nullptr, std::move(done)});
  next_change();
}

void Workbench::next_change() {
  if (!is_changing_ && !changes_.empty()) {
    is_changing_ = true;
    ++turn_;
    const auto begin = changes_.front().begin;  // it may end, and be dropped, while it begins
    begin();
  }
}

void Workbench::end_change(const Problems& problems) {
  const Change ended = std::move(changes_.front());
  changes_.pop_front();
  is_changing_ = false;
  under_way_.clear();
  ++turn_;
  if (ended.done && (!ended.has_receiver || ended.receiver)) {
    ended.done(problems);
  }
  if (!problems.empty()) {
    Q_EMIT refused(problems);
  }
  next_change();
}

void Workbench::drop_changes(const QString& why) {
  std::deque<Change> dropped;
  dropped.swap(changes_);
  is_changing_ = false;
  under_way_.clear();
  ++turn_;
  for (const Change& each : dropped) {
    if (each.done && (!each.has_receiver || each.receiver)) {
      each.done({{{}, 0, why}});
    }
  }
}

/// An order of the change that is under way: the answer is not heard if that is over by then.
void Workbench::order(const Json& order, Engine::Answer answer) {
  if (!engine_.is_there()) {
    end_change({{{}, 0, tr("There is no engine: it could not be started.")}});
    return;
  }
  engine_.ask(order, [this, turn = turn_, answer = std::move(answer)](const Json& said) {
    if (turn == turn_) {
      answer(said);
    }
  });
}

/// `sent`: the text when the order was sent. What was typed since stays.
void Workbench::take(const Json& answer, const QString& sent) {
  is_right_ = true;
  history_text_ = text_at(answer, "text");
  if (text_ == sent) {
    text_ = history_text_;
  }
  tree_ = answer.value("tree", Json());
  scene_ = answer.value("scene", Json());
  epoch_ = answer.value("epoch", std::uint64_t{0});
  if (text_ == history_text_) {
    set_problems({});
  }
  if (run_ == Run::ended) {
    set_run(Run::ready);
  }
  Q_EMIT described();
}

void Workbench::set_problems(Problems problems) {
  problems_ = std::move(problems);
  Q_EMIT problems_changed();
}

void Workbench::remember(const QString& name, const QString& merge, const QString& before,
                         const Json& answer) {
  if (before != history_text_) {
    history_.push({name, merge, before, history_text_, answer.value("undo", std::uint64_t{0}),
                   engine_.generation(), QDateTime::currentMSecsSinceEpoch()});
  }
  keep();
  Q_EMIT history_changed();
}

void Workbench::edit(const QStringList& edits, const QString& name, const QString& merge,
                     QObject* receiver, Done done) {
  Q_EMIT about_to_change();
  in_turn(
      [this, edits, name, merge] {
        if (!is_right_ || text_ != history_text_) {
          end_change({{{},
                       0,
                       tr("The text of the world has mistakes; mend them first, or undo what was "
                          "typed.")}});
          return;
        }
        order({{"do", "edit"}, {"edits", list_of(edits)}},
              [this, name, merge, before = history_text_](const Json& answer) {
                if (answer.contains("refused")) {
                  end_change(problems_of(answer));
                  return;
                }
                take(answer, before);
                remember(name, merge, before, answer);
                end_change();
              });
      },
      receiver, std::move(done));
}

void Workbench::type(const QString& text) {
  if (text == text_) {
    return;
  }
  text_ = text;
  keep();
  Q_EMIT history_changed();
  in_turn([this] { send_typed(); });
}

void Workbench::send_typed() {
  const QString sent = text_;
  if (tree_.is_null()) {
    history_.set_dirty();
    open_in_engine(sent);
    return;
  }
  under_way_ = sent;
  order({{"do", "become"}, {"text", sent.toStdString()}},
        [this, sent, before = history_text_](const Json& answer) {
          if (!answer.contains("refused")) {
            take(answer, sent);
            remember(tr("type"), "type", before, answer);
          } else if (text_ == sent) {  // otherwise more was typed, which is sent next
            set_problems(problems_of(answer));
          }
          end_change();
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
  Json way{{"do", "undo"}, {"edit", inverse}};
  if (inverse == 0 || engine != engine_.generation()) {
    way = {{"do", "become"}, {"text", text.toStdString()}};
  }
  order(way, [this, done, before = history_text_](const Json& answer) {
    if (answer.contains("refused")) {
      end_change(problems_of(answer));
      return;
    }
    take(answer, before);
    done(answer.value("undo", std::uint64_t{0}));
    keep();
    Q_EMIT history_changed();
    end_change();
  });
}

void Workbench::undo() {
  Q_EMIT about_to_change();
  in_turn([this] {
    const History::Entry* entry = history_.next_undo();
    if (text_ != history_text_) {  // what was typed is no world: it goes
      text_ = history_text_;
      keep();
      Q_EMIT history_changed();
      if (!is_right_) {
        open_in_engine(text_);
        return;
      }
      set_problems({});
      Q_EMIT described();
      end_change();
    } else if (entry) {
      lead(entry->before, entry->inverse, entry->engine,
           [this](std::uint64_t inverse) { history_.undone(inverse, engine_.generation()); });
    } else {
      end_change();
    }
  });
}

void Workbench::redo() {
  Q_EMIT about_to_change();
  in_turn([this] {
    const History::Entry* entry = history_.next_redo();
    if (entry && text_ == history_text_) {
      lead(entry->after, entry->inverse, entry->engine,
           [this](std::uint64_t inverse) { history_.redone(inverse, engine_.generation()); });
    } else {
      end_change();
    }
  });
}

void Workbench::keep() {
  if (!is_modified()) {
    recovery_.forget();
    return;
  }
  const bool was_kept = is_kept_;
  is_kept_ = recovery_.keep(file_, text_);
  if (was_kept && !is_kept_) {
    Q_EMIT noted(
        tr("Unsaved work cannot be kept for after a crash: the folder of your data is full "
           "or read-only. Save the world."));
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
  Q_EMIT about_to_change();
  in_turn([this] {
    if (run_ == Run::ready || run_ == Run::paused) {
      engine_.ask({{"do", "run"}});
      set_run(Run::running);
    }
    end_change();
  });
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
  Q_EMIT about_to_change();
  in_turn([this] {
    if (run_ == Run::ready || run_ == Run::paused) {
      engine_.ask({{"do", "step"}}, [this](const Json&) {
        if (run_ == Run::ready) {
          set_run(Run::paused);
        }
      });
    }
    end_change();
  });
}

void Workbench::reset(std::uint64_t seed) {
  Q_EMIT about_to_change();
  seed_ = seed;
  in_turn([this, seed] {
    if (!is_right_) {
      end_change();
      return;
    }
    order({{"do", "reset"}, {"seed", seed}}, [this](const Json& answer) {
      if (answer.contains("refused")) {
        end_change(problems_of(answer));
        return;
      }
      scene_ = answer.value("scene", Json());
      epoch_ = answer.value("epoch", std::uint64_t{0});
      time_s_ = 0.0;
      set_run(Run::ready);
      Q_EMIT described();
      Q_EMIT run_changed();
      end_change();
    });
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
  ++deaths_;
  const QString said = report.trimmed().isEmpty()
                           ? tr("The engine ended with exit code %1.").arg(exit_code)
                           : report.trimmed();
  const QString deadly = under_way_;
  const bool is_deadly = !had_world_ && !deadly.isEmpty() && deadly == history_text_;
  drop_changes(tr("The engine ended before this was done: %1").arg(cause_in(said)));
  set_run(Run::none);
  try {
    if (deaths_ > kMostDeaths) {
      throw base::Error(tr("The engine ends as soon as it starts: %1").arg(said).toStdString());
    }
    start_engine();
  } catch (const base::Error& error) {
    set_problems({{{}, 0, QString::fromStdString(error.what())}});
    Q_EMIT engine_lost(said);
    return;
  }
  const Problem cause{file_, 0, tr("The engine ended when it read this world: %1").arg(said)};
  if (is_deadly) {
    is_right_ = false;
    tree_ = scene_ = Json();
    set_problems({cause});
    Q_EMIT described();
  } else if (!text_.isEmpty()) {
    in_turn([this] { open_in_engine(history_text_); });
    if (!deadly.isEmpty() && deadly == text_ && text_ != history_text_) {
      in_turn([this, cause] {
        set_problems({cause});
        end_change();
      });
    } else if (text_ != history_text_) {
      in_turn([this] { send_typed(); });
    }
  }
  Q_EMIT engine_lost(said);
}

}  // namespace elsie::desktop
