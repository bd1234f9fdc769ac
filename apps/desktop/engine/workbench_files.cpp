#include <QFile>
#include <QFileInfo>
#include <QFileSystemWatcher>
#include <algorithm>
#include <cerrno>
#include <utility>

#include "elsie/files/write_whole.h"

#include "engine/workbench.h"

// Files, and recovery after a crash.

namespace elsie::desktop {
namespace {

// Each edit reads the whole world again, which is too slow for a window if the file is larger.
constexpr qint64 kMost_MB = 32;

/// None unless it is a regular file: reading a pipe might not end, and a device contains no text.
std::optional<QByteArray> bytes_of(const QString& file) {
  const QFileInfo info(file);
  QFile opened(file);
  if (!info.isFile() || info.size() > kMost_MB * 1'000'000 || !opened.open(QIODevice::ReadOnly)) {
    return std::nullopt;
  }
  return opened.readAll();
}

QString folder_of(const QString& file) { return QFileInfo(file).absolutePath(); }

}  // namespace

void Workbench::open_text(const QString& text, const QString& file, bool is_saved, bool is_borrowed,
                          const QStringList& plugins, std::uint64_t seed) {
  drop_changes(tr("Another world was opened before this was done."));
  halt_s_.reset();
  deaths_ = 0;
  seed_ = seed;
  file_ = file;
  is_borrowed_ = is_borrowed;
  text_ = text;
  history_text_ = text;
  history_.clear();
  form_ = {};
  on_disk_ = is_saved && !file.isEmpty() ? bytes_of(file).value_or(QByteArray()) : QByteArray();
  saved_text_ = is_saved ? std::optional(text) : std::nullopt;
  is_gone_ = false;
  typed_.clear();
  keep();
  tree_ = scene_ = Json();
  time_s_ = latest_s_ = 0.0;
  watch_file();
  for (const QString& each : plugins) add_plugin(each, this, [](const Problems&) {});
  in_turn([this] { open_in_engine(text_); });
  Q_EMIT history_changed();
}

/// The bytes of a world's file; none, with a sentence, if it has others.
std::optional<QByteArray> Workbench::bytes_of_world(const QString& file, QString& why) {
  const QFileInfo info(file);
  if (info.exists() && !info.isFile()) {
    why = tr("'%1' is a folder, a device or a pipe; expected the file of a world.").arg(file);
    return std::nullopt;
  }
  if (info.size() > kMost_MB * 1'000'000) {
    why = tr("'%1' has more than %2 MB, too large for the window; use `elsie run` instead.")
              .arg(file)
              .arg(kMost_MB);
    return std::nullopt;
  }
  QFile opened(file);
  if (!opened.open(QIODevice::ReadOnly)) {
    why = tr("'%1' cannot be read: %2").arg(file, opened.errorString());
    return std::nullopt;
  }
  const QByteArray bytes = opened.readAll();
  if (const int line = line_without_utf8(bytes); line > 0) {
    why = tr("'%1' is not UTF-8 text: line %2 has other bytes. Convert it first, for example "
             "with: iconv -f latin1 -t utf-8")
              .arg(file)
              .arg(line);
    return std::nullopt;
  }
  return bytes;
}

bool Workbench::open(const QString& file, QString& why, std::uint64_t seed, bool is_borrowed) {
  std::optional<QByteArray> bytes = bytes_of_world(file, why);
  if (!bytes) {
    return false;
  }
  const TextForm form = TextForm::take_from(*bytes);
  open_text(QString::fromUtf8(*bytes), QFileInfo(file).absoluteFilePath(), true, is_borrowed, {},
            seed);
  form_ = form;
  return true;
}

bool Workbench::read_again(QString& why) {
  const std::optional<QByteArray> bytes = bytes_of_world(file_, why);
  if (!bytes) {
    return false;
  }
  Q_EMIT about_to_change();
  deaths_ = 0;
  in_turn(
      [this, bytes = *bytes, name = tr("read the file again")] {
        QByteArray plain = on_disk_ = bytes;
        form_ = TextForm::take_from(plain);
        const QString text = QString::fromUtf8(plain);
        saved_text_ = text;
        history_.stop_merging();
        const QString mine = std::exchange(text_, text);
        keep();
        if (mine == history_text_) {
          send_typed(name, {});
        } else {  // what was typed is no world, and is there again after undo
          history_text_ = mine;
          open_as_edit(text, name);
        }
      },
      true);
  return true;
}

void Workbench::watch_file() {
  const QStringList watched = on_disk_watcher_->files() + on_disk_watcher_->directories();
  if (!watched.isEmpty()) {
    on_disk_watcher_->removePaths(watched);
  }
  if (!file_.isEmpty() && QFileInfo(folder_of(file_)).isDir()) {
    on_disk_watcher_->addPath(folder_of(file_));  // where a missing file comes back
  }
  if (!file_.isEmpty() && QFileInfo::exists(file_)) {
    on_disk_watcher_->addPath(file_);
  }
}

void Workbench::look_at_disk() {
  watch_file();  // a file that was replaced is no longer watched
  if (!QFileInfo::exists(file_)) {
    gone_timer_.start();
    return;
  }
  set_gone(false);
  if (is_changed_on_disk()) {
    Q_EMIT changed_on_disk();
  }
}

void Workbench::set_gone(bool is_gone) {
  gone_timer_.stop();
  is_gone = is_gone && !file_.isEmpty() && !is_borrowed_ && !QFileInfo::exists(file_);
  if (is_gone != is_gone_) {
    is_gone_ = is_gone;
    keep();
    Q_EMIT history_changed();
    Q_EMIT noted(is_gone ? tr("'%1' is not on disk any more: another program has deleted, renamed "
                              "or moved it. The world is unsaved until you save it.")
                               .arg(file_)
                         : tr("'%1' is on disk again.").arg(file_));
  }
}

bool Workbench::is_changed_on_disk() const {
  if (file_.isEmpty()) {
    return false;
  }
  const auto now = bytes_of(file_);
  return now && *now != on_disk_;
}

// Saving

QString Workbench::write(const QString& file, const QString& text) {
  if (!QFileInfo(folder_of(file)).isDir()) {
    return tr("The world could not be saved as '%1': there is no folder '%2'. 'Save as...' saves "
              "it elsewhere.")
        .arg(file, folder_of(file));
  }
  QByteArray bytes = form_.bytes_of(text);
  // Without a second file in the same folder, a full disk would destroy the present one.
  const int error =
      QFileInfo(folder_of(file)).isWritable()
          ? files::write_whole(file.toStdString(), bytes.toStdString(), files::Durable::yes)
          : EACCES;
  if (error != 0) {
    return tr("The world could not be saved as '%1': %2. What was there before is unchanged.")
        .arg(file, qt_error_string(error));
  }
  on_disk_ = bytes;
  form_ = TextForm::take_from(bytes);
  return {};
}

void Workbench::save_as(const QString& file, std::function<void(const QString&)> done) {
  Q_EMIT about_to_change();
  const QString target = QFileInfo(file).absoluteFilePath();
  in_turn([this, target] { save_in_turn(target); }, false, this,
          [done = std::move(done)](const Problems& problems) {
            done(problems.empty() ? QString() : problems.front().message);
          });
}

void Workbench::when_settled(QObject* receiver, std::function<void()> done) {
  in_turn([this] { end_change(); }, false, receiver,
          [done = std::move(done)](const Problems&) { done(); });
}

void Workbench::save_in_turn(const QString& target) {
  const bool is_in_engine = engine_.is_there() && tree_.is_object() && text_ == history_text_;
  if (is_in_engine && target != file_) {
    save_elsewhere(target);
  } else if (const QString why = write(target, text_); !why.isEmpty()) {
    end_change({{target, 0, why}});
  } else if (target == file_ || !engine_.is_there() || text_.isEmpty()) {
    saved_as(target, text_);
    end_change();
  } else {
    // The engine has a world of another file, or none; it gets the text again.
    const bool has_world = tree_.is_object();
    saved_as(target, text_);
    if (!has_world) {
      open_in_engine(text_);
      return;
    }
    order({{"do", "move"}, {"file", target.toStdString()}}, [this](const Json& answer) {
      if (!answer.contains("refused")) describe(answer, history_text_);
      in_turn([this] { send_typed(); });
      end_change();
    });
  }
}

// From then on the engine has the world of that file, with the names of other files as seen from
// there.
void Workbench::save_elsewhere(const QString& target) {
  order({{"do", "text_for"}, {"file", target.toStdString()}}, [this, target,
                                                               sent = text_](const Json& answer) {
    if (answer.contains("refused")) {
      end_change(problems_of(answer));
      return;
    }
    if (const QString why = write(target, text_of(answer, "text")); !why.isEmpty()) {
      end_change({{target, 0, why}});
      return;
    }
    order({{"do", "move"}, {"file", target.toStdString()}}, [this, target, sent](const Json& said) {
      if (said.contains("refused")) {
        end_change(problems_of(said));
        return;
      }
      describe(said, sent);
      saved_as(target, history_text_);
      end_change();
    });
  });
}

void Workbench::saved_as(const QString& target, const QString& text) {
  file_ = target;
  is_borrowed_ = is_gone_ = false;
  saved_text_ = text;
  history_.stop_merging();
  keep();
  watch_file();
  Q_EMIT history_changed();
}

// Recovery after a crash

bool Workbench::is_modified() const {
  return has_unsaved_text() || std::any_of(changes_.begin(), changes_.end(),
                                           [](const Change& each) { return each.is_edit; });
}

void Workbench::keep_typed(const QObject* by, std::vector<Typed> typed) {
  const bool is_new = typed_[by] != typed;
  typed.empty() ? void(typed_.erase(by)) : void(typed_[by] = std::move(typed));
  if (is_new) keep();
}

void Workbench::keep_sources(std::vector<Typed> sources) {
  if (sources != std::exchange(sources_, sources)) keep();
}

void Workbench::open_recovered(const Recovered& recovered) {
  open_text(recovered.text, recovered.file, false, recovered.is_borrowed, recovered.plugins);
  keep_typed(this, recovered.typed);
  for (const Typed& each : recovered.typed) {
    edit(
        {each.path + '=' + each.text}, tr("enter what was typed"), {}, this,
        [this, each](const Problems& problems) {
          keep_typed(this, {});
          if (!problems.empty()) {
            Q_EMIT noted(tr("'%1' was typed for %2 and is not entered: %3")
                             .arg(each.text, each.path.section('@', -1), problems.front().message));
          }
        });
  }
}

/// The sources of plugins that were added in the window.
QStringList Workbench::drafts() const {
  QStringList files;
  const QStringList& options = engine_.options();
  for (qsizetype i = 0; i + 1 < options.size(); ++i) {
    if (options[i] == QLatin1String("--draft")) files << options[i + 1];
  }
  return files;
}

void Workbench::keep() {
  if (!has_unsaved_text() && typed_.empty() && sources_.empty()) {
    recovery_.forget();
    is_kept_ = true;
    return;
  }
  const bool was_kept = is_kept_;
  std::vector<Typed> typed;
  for (const auto& [by, all] : typed_) typed.insert(typed.end(), all.begin(), all.end());
  is_kept_ =
      recovery_.keep({file_, text_, is_borrowed_, {}, false, std::move(typed), sources_, drafts()});
  if (was_kept && !is_kept_) {
    Q_EMIT noted(
        tr("Unsaved work cannot be kept for the case of a crash: your data folder is full or "
           "read-only. Save the world."));
  }
}

void Workbench::give_up_unsaved() { recovery_.forget(); }

}  // namespace elsie::desktop
