#include <QAction>
#include <QCloseEvent>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <algorithm>

#include "authoring/authoring.h"
#include "control_bar.h"
#include "main_window.h"
#include "paint/warning_label.h"
#include "recorded_world.h"
#include "scene/scene_view.h"
#include "start_page.h"
#include "text/sources_panel.h"
#include "watch/fuzzy_panel.h"
#include "watch/graph_panel.h"
#include "watch/plots_panel.h"
#include "watch/sensors_panel.h"
#include "watch/vision_panel.h"

// Opening and saving files, and unsaved work.

namespace elsie::desktop {
namespace {

constexpr int kMostRecent = 10;

/// Judged by its permissions, because root may write everything.
bool is_write_protected(const QString& file) {
  const QFileInfo info(file);
  constexpr auto kWriters = QFile::WriteOwner | QFile::WriteGroup | QFile::WriteOther;
  return info.isFile() && (!info.isWritable() || !(info.permissions() & kWriters));
}

}  // namespace

// Files

bool MainWindow::may_leave() {
  enter_what_is_typed();
  if (!workbench_.is_modified()) {
    return true;
  }
  const QString name = workbench_.file().isEmpty()
                           ? tr("The new world")
                           : '\'' + QFileInfo(workbench_.file()).fileName() + '\'';
  switch (ask_about_unsaved(tr("%1 has changes that are not saved. Save them?").arg(name))) {
    case Answer::save:
      return save(false);
    case Answer::discard:
      return true;
    default:
      return false;
  }
}

bool MainWindow::open(const QString& file) {
  if (may_be_database(file)) {
    open_database(file);
    return true;
  }
  if (may_be_run(file)) {
    read_run(file, {});
    return true;
  }
  if (may_be_table(file)) {
    warn(this, tr("The table of a run cannot be played"),
         tr("'%1' has the numbers of a run, but not its world. Record the run as .mcap to open it "
            "here; Plots shows numbers while it runs.")
             .arg(file));
    return false;
  }
  if (!may_leave()) {
    return false;
  }
  QString why;
  if (!workbench_.open(file, why)) {
    warn(this, tr("The world cannot be opened"), why);
    return false;
  }
  show_opened(file);
  return true;
}

void MainWindow::show_opened(const QString& file) {
  note_recent(file);
  forget_world();
  show_page(false);
  scene_->setFocus();
  show_title();
  show_state();
  if (workbench_.is_opening()) {
    opening_ = tr("Opening '%1'...").arg(file);
    say(opening_);
  }
}

// Forgets what belongs to the previous world.
void MainWindow::forget_world() {
  outcome_.clear();
  runs_->stop();
  time_line_->expect({}, 0.0);
  time_line_->clear();
  scene_->unlock_all();
  authoring_->close_dialogs();
  authoring_->select({});
  plots_->set_names({});
  vision_->clear();
  fuzzy_->clear();
  graph_->clear();
  sensors_->clear();
  filled_.clear();
  put_away_empty();
  recorded_.reset();
}

void MainWindow::begin_world(const std::function<QString()>& text) {
  if (!may_leave()) {
    return;
  }
  const QString begun = text();
  if (!begun.isEmpty()) {
    statusBar()->clearMessage();      // of the run before
    workbench_.open_text(begun, {});  // this loses nothing
    forget_world();
    show_page(false);
    show_title();
  }
}

bool MainWindow::is_agreed(const char* name, const QString& title, const QString& question) {
  QMessageBox box(QMessageBox::Question, title, question, QMessageBox::Yes | QMessageBox::No, this);
  box.setObjectName(name);
  box.setDefaultButton(QMessageBox::No);
  return box.exec() == QMessageBox::Yes;
}

/// Asks before invalid text replaces a file.
bool MainWindow::may_have_mistakes() {
  enter_what_is_typed();
  if (workbench_.engine().is_there() && workbench_.has_mistakes()) {  // or the text is not read yet
    const auto waiting = std::make_shared<QEventLoop>();
    workbench_.when_settled(this, [waiting] { waiting->quit(); });
    if (workbench_.has_mistakes()) {
      QTimer::singleShot(kStuck_ms, waiting.get(), &QEventLoop::quit);
      waiting->exec(QEventLoop::ExcludeUserInputEvents);
    }
  }
  return !workbench_.has_mistakes() || workbench_.problems().empty() ||
         is_agreed("save_mistakes", tr("The text has mistakes"),
                   tr("The text of the world has mistakes: %1\nSave it anyway?")
                       .arg(workbench_.problems().front().message));
}

bool MainWindow::save(bool elsewhere) {
  if (!may_have_mistakes()) {
    return false;
  }
  QString file = workbench_.file();
  if (elsewhere || file.isEmpty() || workbench_.is_borrowed()) {
    QFileDialog dialog(
        this, tr("Save the world"),
        file.isEmpty() || workbench_.is_borrowed() ? QDir::currentPath() + "/world.xml" : file,
        tr("Worlds (*.xml)"));
    dialog.setObjectName("save_dialog");
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix("xml");
    if (dialog.exec() != QDialog::Accepted) {
      return false;
    }
    file = dialog.selectedFiles().front();
  } else if (workbench_.is_changed_on_disk() &&
             !is_agreed("write_over", tr("The file has changed"),
                        tr("Another program has changed '%1' since it was opened. Overwrite it?")
                            .arg(file))) {
    return false;
  }
  if (is_write_protected(file) &&
      !is_agreed(
          "write_protected", tr("The file is write-protected"),
          tr("'%1' is write-protected. Write it anyway? It stays write-protected.").arg(file))) {
    return false;
  }
  // The save may still happen after this function has stopped waiting.
  struct Saving {
    std::optional<QString> why;
    QEventLoop waiting;
  };
  const auto saving = std::make_shared<Saving>();
  workbench_.save_as(file, [this, saving](const QString& why) {
    saving->why = why;
    saving->waiting.quit();
    if (why.isEmpty()) {
      note_recent(workbench_.file());
      say(tr("Saved as '%1'").arg(workbench_.file()));
    }
    show_title();
  });
  if (!saving->why) {
    QTimer::singleShot(kStuck_ms, &saving->waiting, &QEventLoop::quit);
    saving->waiting.exec(QEventLoop::ExcludeUserInputEvents);
  }
  if (saving->why && saving->why->isEmpty()) {
    return true;
  }
  warn(
      this, tr("Not saved"),
      saving->why.value_or(tr("The engine does not answer: a plugin takes long. The world is saved "
                              "as soon as it does. 'Stop the engine now' in the menu Simulation "
                              "starts it again; then save again.")));
  return false;
}

// The box does not block the event loop: a run continues, and a file that changes again leads to
// one question.
void MainWindow::ask_about_disk() {
  if (changed_on_disk_) {
    return;
  }
  QMessageBox* box = changed_on_disk_ = new QMessageBox(
      QMessageBox::Question, tr("The file has changed"),
      workbench_.is_modified()
          ? tr("Another program has changed '%1'. Read it again? Undo leads back to your unsaved "
               "changes.")
                .arg(workbench_.file())
          : tr("Another program has changed '%1'. Read it again?").arg(workbench_.file()),
      QMessageBox::NoButton, this);
  box->setObjectName("changed_on_disk");
  box->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* again = box->addButton(tr("&Read again"), QMessageBox::AcceptRole);
  again->setObjectName("read_again");
  QPushButton* keep = box->addButton(tr("&Keep mine"), QMessageBox::RejectRole);
  keep->setObjectName("keep_mine");
  box->setEscapeButton(keep);
  box->setDefaultButton(workbench_.is_modified() ? keep : again);  // it comes while one types
  const QString file = workbench_.file();
  connect(again, &QPushButton::clicked, this, [this, file] {
    QString why;
    if (file == workbench_.file() && !workbench_.read_again(why)) warn(this, tr("Not read"), why);
  });
  box->open();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!may_leave() || !may_leave_sources(sources_->modified())) {
    event->ignore();
    return;
  }
  workbench_.give_up_unsaved();
  keep_layout();
  event->accept();
}

bool MainWindow::offer_recovered(const QString& instead_of) {
  std::vector<Recovered> left = Recovery::left_behind();
  const auto damaged = std::stable_partition(
      left.begin(), left.end(), [](const Recovered& each) { return !each.is_damaged; });
  for (auto each = damaged; each != left.end(); ++each) {
    warn(this, tr("Unsaved work"),
         tr("The unsaved work of a window that was not closed properly cannot be read. It is in "
            "'%1', and stays there.")
             .arg(each->kept_in));
  }
  left.erase(damaged, left.end());
  for (const Recovered& each : left) {
    QMessageBox box(QMessageBox::Question, tr("Unsaved work"),
                    tr("A window was not closed properly. Continue its unsaved work on %1?")
                        .arg(each.file.isEmpty() ? tr("a new world") : '\'' + each.file + '\''),
                    QMessageBox::Yes | QMessageBox::Discard | QMessageBox::Cancel, this);
    box.setObjectName("recovered");
    const int answer = box.exec();
    if (answer == QMessageBox::Yes) {
      workbench_.open_recovered(each);
      forget_world();
      show_page(false);
      show_title();
      const bool has_sources = bring_back_sources(each);
      if (workbench_.is_kept() && has_sources) {
        Recovery::discard(each);
      }
      if (!instead_of.isEmpty()) {
        say(tr("This window continues the unsaved work; '%1' is not opened.").arg(instead_of));
      }
      return true;
    }
    if (answer == QMessageBox::Discard) {
      Recovery::discard(each);
    }
  }
  return false;
}

/// Opens the sources that were changed and not saved. Returns false if one is not there any more.
bool MainWindow::bring_back_sources(const Recovered& recovered) {
  bool has_all = true;
  for (const Typed& each : recovered.sources) {
    if (QFileInfo(each.path).isFile()) {
      open_source(each.path, 0);
      sources_->put(each);
    } else {
      has_all = false;
      warn(
          this, tr("Unsaved work"),
          tr("The source '%1' is not there any more. Its unsaved text is in '%2', and stays there.")
              .arg(each.path, recovered.kept_in));
    }
  }
  return has_all;
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  if (!event->mimeData()->urls().isEmpty()) open(event->mimeData()->urls().front().toLocalFile());
}

void MainWindow::note_recent(const QString& file) {
  QSettings settings;
  QStringList files = settings.value("recent").toStringList();
  const QString absolute = QFileInfo(file).absoluteFilePath();
  files.removeAll(absolute);
  files.prepend(absolute);
  settings.setValue("recent", files.mid(0, kMostRecent));
  show_recent();
}

void MainWindow::show_recent() {
  const QStringList files = QSettings().value("recent").toStringList();
  start_->show_recent(files);
  recent_->clear();
  for (const QString& file : files) {
    connect(recent_->addAction(file), &QAction::triggered, this, [this, file] { open(file); });
  }
  recent_->setEnabled(!files.isEmpty());
}

void MainWindow::show_start() {
  is_start_wished_ = !is_start_shown_;
  show_page(is_start_wished_ || !workbench_.tree().is_object());
}

}  // namespace elsie::desktop
