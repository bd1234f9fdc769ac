#include <QDir>
#include <algorithm>
#include <iterator>

#include "engine/workbench.h"

// Changes, one after another, and undo.

namespace elsie::desktop {

void Workbench::in_turn(std::function<void()> begin, bool is_edit, QObject* receiver, Done done,
                        const QString& name) {
  changes_.push_back(
      {std::move(begin), receiver, receiver != nullptr, std::move(done), is_edit, name});
  next_change();
}

void Workbench::next_change() {
  if (!is_changing_ && !changes_.empty()) {
    is_changing_ = true;
    ++turn_;
    const auto begin = changes_.front().begin;  // a copy: the change may be dropped during it
    begin();
  }
}

void Workbench::end_change(const Problems& problems) {
  const Change ended = std::move(changes_.front());
  changes_.pop_front();
  is_changing_ = false;
  under_way_.clear();
  ++turn_;
  if (ended.is_edit) {
    Q_EMIT history_changed();  // it is no longer pending
  }
  if (ended.done && (!ended.has_receiver || ended.receiver)) {
    ended.done(problems);
  }
  if (!problems.empty()) {
    Q_EMIT refused(problems);
  }
  next_change();
}

/// Takes out the edits that a new engine can make: all but the one that the engine was making when
/// it ended, unless it was making steps, which end it more often than edits do.
std::deque<Workbench::Change> Workbench::take_waiting() {
  const auto first = changes_.begin() + (is_changing_ && !is_busy() ? 1 : 0);
  const auto edits = std::stable_partition(first, changes_.end(),
                                           [](const Change& each) { return !each.is_edit; });
  std::deque<Change> waiting(std::make_move_iterator(edits),
                             std::make_move_iterator(changes_.end()));
  changes_.erase(edits, changes_.end());
  return waiting;
}

/// The names of the edits among them.
QStringList Workbench::drop_changes(const QString& why) {
  QStringList names;
  std::deque<Change> dropped;
  dropped.swap(changes_);
  is_changing_ = false;
  under_way_.clear();
  ++turn_;
  for (const Change& each : dropped) {
    if (!each.name.isEmpty()) names << each.name;
    if (each.done && (!each.has_receiver || each.receiver)) {
      each.done({{{}, 0, why}});
    }
  }
  return names;
}

/// Sends an order of the present change; its answer is ignored if the change is over by then.
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

void Workbench::remember(const QString& name, const QString& merge, const QString& before) {
  if (before != history_text_) {
    history_.push({name, merge, before, history_text_, file_});
  }
  keep();
  Q_EMIT history_changed();
}

void Workbench::edit(const QStringList& edits, const QString& name, const QString& merge,
                     QObject* receiver, Done done) {
  Q_EMIT about_to_change();
  deaths_ = 0;
  in_turn(
      [this, edits, name, merge] {
        if (engine_.is_there() && (!is_right() || text_ != history_text_)) {
          end_change({{{},
                       0,
                       tr("The text of the world has mistakes; fix them first, or undo what was "
                          "typed.")}});
          return;
        }
        order({{"do", "edit"}, {"edits", list_of(edits)}},
              [this, name, merge, before = history_text_](const Json& answer) {
                if (answer.contains("refused")) {
                  end_change(problems_of(answer));
                  return;
                }
                changes_.front().name.clear();  // the text has them
                take(answer, before);
                remember(name, merge, before);
                end_change();
              });
      },
      true, receiver, std::move(done), name);
  Q_EMIT history_changed();
}

void Workbench::type(const QString& text) {
  if (text == text_) {
    return;
  }
  deaths_ = 0;
  text_ = text;
  keep();
  Q_EMIT history_changed();
  in_turn([this] { send_typed(); }, true);
}

void Workbench::send_typed(const QString& name, const QString& merge) {
  const QString sent = text_;
  if (tree_.is_null()) {
    open_as_edit(sent, name, merge);
    return;
  }
  under_way_ = sent;
  order({{"do", "become"}, {"text", sent.toStdString()}},
        [this, sent, name, merge, before = history_text_](const Json& answer) {
          if (!answer.contains("refused")) {
            take(answer, sent);
            remember(name, merge, before);
          } else if (text_ == sent) {  // otherwise more was typed, which is sent next
            set_problems(problems_of(answer));
          }
          end_change();
        });
}

// There is no world that could become another one: the text is opened, and undo leads back by text.
void Workbench::open_as_edit(const QString& text, const QString& name, const QString& merge) {
  if (text != history_text_) {
    history_.push({name, merge, history_text_, text, file_, true});
    history_text_ = text;
    keep();
  }
  open_in_engine(text);
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

void Workbench::lead(const History::Entry& entry, const QString& text, void (History::*done)()) {
  if (entry.is_opened || tree_.is_null()) {
    text_ = history_text_ = text;
    (history_.*done)();
    keep();
    open_in_engine(text);
    return;
  }
  // Without a file, names of files start at the present folder.
  const QString file =
      entry.file.isEmpty() && !file_.isEmpty() ? QDir::current().filePath("world.xml") : entry.file;
  order({{"do", "become"}, {"text", text.toStdString()}, {"file", file.toStdString()}},
        [this, done, before = history_text_](const Json& answer) {
          if (answer.contains("refused")) {
            end_change(problems_of(answer));
            return;
          }
          take(answer, before);
          (history_.*done)();
          keep();
          Q_EMIT history_changed();
          end_change();
        });
}

void Workbench::undo() {
  Q_EMIT about_to_change();
  deaths_ = 0;
  in_turn(
      [this] {
        const History::Entry* entry = history_.next_undo();
        if (text_ != history_text_) {  // invalid typed text is dropped
          text_ = history_text_;
          keep();
          Q_EMIT history_changed();
          if (!is_right()) {
            open_in_engine(text_);
            return;
          }
          set_problems({});
          Q_EMIT described();
          end_change();
        } else if (entry) {
          lead(*entry, entry->before, &History::undone);
        } else {
          end_change();
        }
      },
      true);
}

void Workbench::redo() {
  Q_EMIT about_to_change();
  deaths_ = 0;
  in_turn(
      [this] {
        const History::Entry* entry = history_.next_redo();
        if (entry && text_ == history_text_) {
          lead(*entry, entry->after, &History::redone);
        } else {
          end_change();
        }
      },
      true);
}

}  // namespace elsie::desktop
