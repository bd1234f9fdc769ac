#include "export/exporter.h"

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QProgressDialog>
#include <cmath>

#include "control_bar.h"
#include "engine/workbench.h"
#include "export/film.h"
#include "paint/save_picture.h"
#include "paint/warning_label.h"
#include "scene/scene_view.h"

namespace elsie::desktop {
namespace {

constexpr double kFilmRate = 25.0;  // pictures a second

}  // namespace

Exporter::Exporter(Workbench& workbench, SceneView& scene, TimeLine& time_line, QWidget* window)
    : QObject(window),
      workbench_(workbench),
      scene_(scene),
      time_line_(time_line),
      window_(window) {}

Exporter::~Exporter() = default;

QString Exporter::ask_for_file(const QString& title, const QString& name, const QString& kinds) {
  QFileDialog dialog(window_, title, {}, kinds);
  dialog.setObjectName("export_dialog");
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.selectFile(name);
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().front() : QString();
}

void Exporter::export_picture() {
  const QString file =
      ask_for_file(tr("Export the picture"), "world.png", tr("Pictures (*.png *.jpg)"));
  if (file.isEmpty()) {
    return;
  }
  const QString why = save_picture(scene_.picture(), file);
  why.isEmpty() ? Q_EMIT said(tr("The picture is in '%1'").arg(file))
                : warn(window_, tr("Not exported"), why, "picture_failed");
}

// The film

void Exporter::export_film() {
  if (workbench_.latest_s() <= 0.0) {
    Q_EMIT said(tr("There is no run to show: run the world first."));
    return;
  }
  const QString file = ask_for_file(tr("Export the film"), "run.avi", tr("Films (*.avi)"));
  if (!file.isEmpty()) {
    write_film(file);
  }
}

void Exporter::write_film(const QString& file) {
  if (film_) {
    return;
  }
  if (workbench_.run_state() == Workbench::Run::running) {
    workbench_.pause();
  }
  film_ = std::make_unique<Film>(file, kFilmRate);
  film_file_ = file;
  progress_ = new QProgressDialog(tr("Writing '%1'").arg(file), tr("Cancel"), 0, 0, window_);
  progress_->setObjectName("film_progress");
  progress_->setWindowModality(Qt::WindowModal);
  connect(progress_, &QProgressDialog::canceled, this, [this] { end_film(false); });
  // The engine knows how far the run has gone, whatever the view shows.
  workbench_.ask({{"do", "at"}, {"time_s", 0.0}}, [this](const Json& answer) {
    if (film_) {
      film_until_s_ = answer.value("to_s", 0.0);
      progress_->setMaximum(static_cast<int>(std::lround(film_until_s_ * kFilmRate)));
      add_frame(0);
    }
  });
}

void Exporter::add_frame(int number) {
  if (!film_) {
    return;  // cancelled in the meantime
  }
  const double time_s = number / kFilmRate;
  if (time_s > film_until_s_ + 1e-9) {
    end_film(true);
    return;
  }
  workbench_.ask({{"do", "at"}, {"time_s", time_s}}, [this, number](const Json& answer) {
    if (!film_) {
      return;  // cancelled in the meantime
    }
    // The snapshot of that instant came before the answer.
    if (answer.contains("refused") || !film_->add(scene_.picture(SceneView::kFilm))) {
      end_film(true);
      return;
    }
    progress_->setValue(number);  // handles Cancel
    add_frame(number + 1);
  });
}

void Exporter::end_film(bool is_wanted) {
  if (!film_) {
    return;
  }
  const bool is_whole = is_wanted && film_->end();
  const QString why = film_->error();
  const int frames = film_->frames();
  film_.reset();
  progress_->deleteLater();
  time_line_.go_to_now();
  if (is_whole) {
    Q_EMIT said(tr("%1 pictures in '%2'").arg(frames).arg(film_file_));
  } else if (is_wanted) {
    warn(window_, tr("Not exported"),
         tr("The film could not be written to '%1': %2. What was there before is unchanged.")
             .arg(film_file_, why),
         "film_failed");
  }
  Q_EMIT film_ended(is_whole);
}

// Recordings and commands

void Exporter::record() {
  const QString file = ask_for_file(tr("Record the next run: 10 samples per simulated second"),
                                    "run.mcap", tr("Recordings (*.mcap *.csv)"));
  if (!file.isEmpty()) {
    record_into(file);
  }
}

void Exporter::record_into(const QString& file) {
  workbench_.ask({{"do", "record"}, {"files", {file.toStdString()}}},
                 [this, file](const Json& answer) {
                   const Problems problems = problems_of(answer);
                   Q_EMIT said(problems.empty() ? tr("The next run is recorded in '%1'").arg(file)
                                                : problems.front().message);
                 });
}

void Exporter::copy_command() {
  workbench_.ask({{"do", "command"}}, [this](const Json& answer) {
    const QString text = text_of(answer, "text");
    if (text.isEmpty()) {
      Q_EMIT said(tr("There is no world yet."));
      return;
    }
    QApplication::clipboard()->setText(text);
    Q_EMIT said(answer.value("saved", true)
                    ? tr("Copied: %1").arg(text)
                    : tr("Copied, but the command gives a different run, because its file has "
                         "changed since this run began. %1")
                          .arg(text));
  });
}

}  // namespace elsie::desktop
