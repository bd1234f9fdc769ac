#include <QAction>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <algorithm>

#include "authoring/authoring.h"
#include "authoring/new_behavior_dialog.h"
#include "help_window.h"
#include "main_window.h"
#include "paint/warning_label.h"
#include "text/sources_panel.h"
#include "watch/fuzzy_panel.h"

// Plugins that are written in the window, and the pages of the documentation.

namespace elsie::desktop {

void MainWindow::write_behavior() {
  const QString file = workbench_.is_borrowed() ? QString() : workbench_.file();
  auto* dialog = new NewBehaviorDialog(
      elsie_, options_, file.isEmpty() ? QDir::homePath() : QFileInfo(file).absolutePath(), this);
  connect(dialog, &NewBehaviorDialog::written, this, &MainWindow::use_source);
  dialog->open();
}

void MainWindow::use_source(const QString& source, const QString& name) {
  QString robot = authoring_->robot();
  QStringList all;
  for (const Stage::Body& body : scene_->stage().bodies()) {
    if (body.is_robot()) all << body.path;
  }
  if (robot.isEmpty() && all.size() == 1) robot = all.front();
  to_robots_[source] = {name, robot};
  workbench_.add_plugin(source, this, [](const Problems&) {});  // plugins_changed() comes, too
  open_source(source, 0);
  sources_->say(source, tr("The engine compiles and loads it..."));
}

void MainWindow::open_source(const QString& file, int line) {
  if (const QString why = sources_->open(file); !why.isEmpty()) {
    say(why);
    return;
  }
  if (docks_.source->isHidden()) {
    addDockWidget(Qt::RightDockWidgetArea, docks_.source);
    tabifyDockWidget(docks_.properties, docks_.source);
    resizeDocks({docks_.source}, {std::max(width() / 3, docks_.source->minimumWidth())},
                Qt::Horizontal);
  }
  docks_.source->show();
  docks_.source->raise();
  sources_->go_to(file, line);
  sources_->set_problems(problems_shown_);
}

void MainWindow::take_plugins(const QStringList& used, const QStringList& kept) {
  sources_->take(used, kept);
  for (const QString& file : used) {
    if (!to_robots_.contains(file)) continue;
    const auto [name, robot] = to_robots_.take(file);
    if (!place_of(workbench_.tree(), robot).element || robot.isEmpty()) {
      say(tr("%1 is loaded. Select a robot; Behaviours gives it to the robot.").arg(name));
      continue;
    }
    QStringList edits{robot + "/behavior[+]=<" + name + "/>"};
    if (!place_of(workbench_.tree(), robot + "/coordinator").element) {
      edits << robot + "/coordinator[+]=<fusion_vector_summation/>";
    }
    workbench_.edit(edits, tr("add %1 to %2").arg(name, robot_id(robot)), {}, this,
                    [this, name = name, robot = robot](const Problems& problems) {
                      if (problems.empty()) {
                        say(tr("%1 is loaded, and %2 has it.").arg(name, robot_id(robot)));
                      } else {
                        warn(this, tr("Not added"),
                             tr("%1 is loaded, but %2 cannot have it: %3")
                                 .arg(name, robot_id(robot), problems.front().message),
                             "behavior_not_added");
                      }
                    });
  }
}

/// A run keeps the models with which it began, so that it can be repeated.
void MainWindow::take_saved_model(const QString& file) {
  const QString mistake = fuzzy_->mistake_in(file);
  const bool is_ready = workbench_.run_state() == Workbench::Run::ready;
  if (!mistake.isEmpty()) {
    sources_->say(file, tr("✗ Saved, but no run can use it: %1").arg(mistake));
  } else if (is_ready) {
    sources_->say(file, tr("✓ Saved: the run will use it."));
    workbench_.reset(workbench_.seed());
  } else {
    sources_->say(file, tr("✓ Saved. This run keeps the version with which it began; the next one, "
                           "after Reset (Ctrl+R), has this."));
  }
}

/// Asks about sources that are not saved. Returns false if they stay open.
bool MainWindow::may_leave_sources(const QStringList& files) {
  if (files.isEmpty()) {
    return true;
  }
  switch (ask_about_unsaved(
      tr("The source '%1' has changes that are not saved. Save them?").arg(files.join("', '")))) {
    case Answer::save: {
      const QString why = sources_->save(files);
      if (!why.isEmpty()) warn(this, tr("Not saved"), why);
      return why.isEmpty();
    }
    case Answer::discard:
      return true;
    default:
      return false;
  }
}

// Help

void MainWindow::open_page(const QString& page) {
  if (HelpWindow::folder().isEmpty()) {
    warn(this, tr("No documentation"),
         tr("The pages of the documentation are not installed. They are in the folder docs of "
            "Elsie's sources; 'make install' installs them with the program."),
         "no_pages");
    return;
  }
  auto* help = findChild<HelpWindow*>();
  if (!help) {
    help = new HelpWindow(this);
    connect(help, &HelpWindow::world_wished, this, [this](const QString& file) { open(file); });
  }
  help->open(page);
  help->show();
  help->raise();
  help->activateWindow();
}

void MainWindow::open_page_of_selected() {
  const QString path = authoring_->selection().value(0);
  const ElementPlace place = place_of(workbench_.tree(), path);
  if (place.element) {
    const QString plugin = text_of(*place.element, "name");
    for (const char* kind : {"behavior", "coordinator", "sensor", "actuator", "drive", "measure",
                             "rule", "localisation"}) {
      if (const QString page = HelpWindow::page_of(kind, plugin); !page.isEmpty()) {
        open_page(page);
        return;
      }
    }
    const QString robot = authoring_->robot();
    say(robot == path || robot.isEmpty()
            ? tr("Select a plugin, such as a behaviour or a sensor: then this opens its page. Here "
                 "is the page about worlds.")
            : tr("%1 has no page; Properties shows what its parameters mean.").arg(plugin));
    if (robot != path && !robot.isEmpty()) return;
  }
  open_page("worlds.md");
}

}  // namespace elsie::desktop
