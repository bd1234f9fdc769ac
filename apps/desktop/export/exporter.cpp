#include "export/exporter.h"

#include <QApplication>
#include <QClipboard>
#include <QImage>
#include <QProgressDialog>
#include <algorithm>
#include <cmath>
#include <utility>

#include "control_bar.h"
#include "engine/past.h"
#include "engine/workbench.h"
#include "export/film_writer.h"
#include "paint/save_picture.h"
#include "paint/warning_label.h"
#include "scene/scene_view.h"

namespace elsie::desktop {
namespace {

constexpr double kUsualHeight = 720.0;  // px; names in a larger film are as large as in this one
constexpr int kBetweenShown_ms = 500;   // pictures of a film in the view

}  // namespace

Exporter::Exporter(Workbench& workbench, SceneView& scene, TimeLine& time_line, const Past& past,
                   QWidget* window)
    : QObject(window),
      workbench_(workbench),
      scene_(scene),
      time_line_(time_line),
      past_(past),
      window_(window) {
  connect(&workbench_, &Workbench::described, this, [this] {
    if (film_) stop_film(tr("the world was changed meanwhile"));
  });
}

Exporter::~Exporter() = default;

// Pictures

std::unique_ptr<SceneView> Exporter::studio(const QSize& pixels, double ratio) {
  auto made = std::make_unique<SceneView>();
  made->resize(static_cast<int>(std::ceil(pixels.width() / ratio)),
               static_cast<int>(std::ceil(pixels.height() / ratio)));
  made->set_scene(workbench_.scene(), workbench_.epoch());
  made->overlays() = scene_.overlays();
  made->show_trails(past_);
  made->follow(scene_.followed(), scene_.follows());
  made->camera() = scene_.camera();
  connect(&workbench_, &Workbench::snapshot, made.get(), &SceneView::take);
  connect(&workbench_, &Workbench::state, made.get(), &SceneView::take_state);
  return made;
}

/// Makes the engine send what the view shows again.
void Exporter::show_time_in_view() {
  Json order{{"do", "at"}};
  if (time_line_.is_in_the_past()) order["time_s"] = workbench_.time_s();
  workbench_.ask(order, {});
}

void Exporter::export_picture() {
  const auto choice = ask_for_picture(scene_.size(), window_);
  if (!choice) {
    return;
  }
  const QString file = ask_for_file(tr("Export the picture"), "world." + choice->ending,
                                    tr("Pictures (*.%1)").arg(choice->ending), window_);
  if (!file.isEmpty()) {
    choice->is_from_above ? write_from_above(file, *choice) : write_view(file, *choice);
  }
}

void Exporter::write_view(const QString& file, const PictureChoice& choice) {
  if (const QString why = wrong_picture_name(file); !why.isEmpty()) {
    end_picture(file, why);
    return;
  }
  const double ratio = choice.dpi / kUsualDpi;
  const std::shared_ptr<SceneView> view(studio(choice.size, ratio).release(),
                                        [](SceneView* done) { done->deleteLater(); });
  connect(
      &workbench_, &Workbench::snapshot, this,
      [this, file, choice, ratio, view] {
        QImage picture = view->picture(SceneView::kPicture, ratio).copy(QRect({}, choice.size));
        const bool was_too_large = view->device().isEmpty() && !scene_.device().isEmpty();
        picture.setDevicePixelRatio(1.0);
        const int dots = static_cast<int>(std::lround(choice.dpi / 0.0254));
        picture.setDotsPerMeterX(dots);
        picture.setDotsPerMeterY(dots);
        end_picture(file, was_too_large
                              ? tr("The graphics of this machine draws no picture of %1 x %2 "
                                   "pixels. Choose fewer dots per inch.")
                                    .arg(picture.width())
                                    .arg(picture.height())
                              : save_picture(picture, file));
      },
      Qt::SingleShotConnection);
  show_time_in_view();
}

void Exporter::write_from_above(const QString& file, const PictureChoice& choice) {
  const bool is_of_dots = file.endsWith(".png", Qt::CaseInsensitive);
  const double as_lines = choice.size.width() * kUsualDpi / choice.dpi;
  workbench_.ask(
      {{"do", "picture"},
       {"file", file.toStdString()},
       {"width", is_of_dots ? choice.size.width()
                            : std::max(kNarrowest_px, static_cast<int>(std::lround(as_lines)))}},
      [this, file](const Json& answer) {
        const Problems problems = problems_of(answer);
        end_picture(file, problems.empty() ? QString() : problems.front().message);
      });
}

void Exporter::end_picture(const QString& file, const QString& why) {
  why.isEmpty() ? Q_EMIT said(tr("The picture is in '%1'").arg(file))
                : warn(window_, tr("Not exported"), why, "picture_failed");
  Q_EMIT picture_ended(why.isEmpty());
}

// The film

void Exporter::export_film() {
  if (workbench_.latest_s() <= 0.0) {
    Q_EMIT said(tr("There is no run to show: run the world first."));
    return;
  }
  if (film_) {
    Q_EMIT said(tr("A film is being written already."));
    return;
  }
  const auto choice = ask_for_film(scene_.size(), workbench_.latest_s(), window_);
  if (!choice) {
    return;
  }
  const QString file = ask_for_file(tr("Export the film"), "run." + choice->ending,
                                    tr("Films (*.%1)").arg(choice->ending), window_);
  if (!file.isEmpty()) {
    write_film(file, *choice);
  }
}

void Exporter::write_film(const QString& file) {
  FilmChoice choice;
  choice.size = {scene_.width() / 2 * 2, scene_.height() / 2 * 2};
  write_film(file, choice);
}

void Exporter::write_film(const QString& file, const FilmChoice& choice) {
  if (film_) {
    return;
  }
  if (!FilmWriter::can_write(file)) {
    warn(
        window_, tr("Not exported"),
        tr("'%1' does not end in .mp4, .webm, .gif or .avi, as the name of a film does.").arg(file),
        "film_failed");
    Q_EMIT film_ended(false);
    return;
  }
  if (workbench_.run_state() == Workbench::Run::running) {
    workbench_.pause();
  }
  film_ = FilmWriter::for_file(file, choice.size);
  film_file_ = file;
  film_choice_ = choice;
  film_rate_ = FilmWriter::rate_of(file);
  film_ratio_ = std::max(1.0, choice.size.height() / kUsualHeight);
  frames_ = 0;
  waiting_.reset();
  studio_ = studio(choice.size, film_ratio_);
  scene_.setUpdatesEnabled(false);  // it would draw every picture of the film, too
  shown_.start();
  connect(film_.get(), &FilmWriter::finished, this, &Exporter::take_film);
  connect(film_.get(), &FilmWriter::has_room, this, [this] {
    if (const auto frame = std::exchange(waiting_, std::nullopt)) add_frame(*frame);
  });
  progress_ = new QProgressDialog(tr("Writing '%1'").arg(file), tr("Cancel"), 0, 0, window_);
  progress_->setObjectName("film_progress");
  progress_->setWindowTitle(tr("Film"));
  progress_->setMinimumDuration(0);
  connect(progress_, &QProgressDialog::canceled, this, [this] { stop_film(std::nullopt); });
  // The engine knows how far the run has gone, whatever the view shows.
  workbench_.ask({{"do", "at"}, {"time_s", 0.0}},
                 [this, number = ++film_number_](const Json& answer) {
                   if (!film_ || number != film_number_) {
                     return;
                   }
                   film_until_s_ = answer.value("to_s", 0.0);
                   const double frames = film_until_s_ / film_choice_.speed * film_rate_;
                   progress_->setMaximum(static_cast<int>(std::floor(frames + 1e-6)) + 1);
                   add_frame(0);
                 });
}

void Exporter::add_frame(int number) {
  if (!film_) {
    return;  // cancelled in the meantime
  }
  const double time_s = number * film_choice_.speed / film_rate_;
  if (time_s > film_until_s_ + 1e-9) {
    film_->end();
    return;
  }
  workbench_.ask({{"do", "at"}, {"time_s", time_s}}, [this, number,
                                                      film = film_number_](const Json& answer) {
    if (!film_ || film != film_number_) {
      return;  // cancelled in the meantime
    }
    if (answer.contains("refused")) {
      stop_film(tr("the run went on meanwhile; pause it until the film is written"));
      return;
    }
    // The snapshot of that instant came before the answer, unless the user has moved the time on.
    if (std::abs(studio_->stage().time_s() - answer.value("time_s", 0.0)) > 1e-9) {
      constexpr int kMostAgain = 500;
      ++again_ < kMostAgain ? add_frame(number) : stop_film(tr("the time was moved all the while"));
      return;
    }
    again_ = 0;
    if (shown_.elapsed() > kBetweenShown_ms) {
      scene_.setUpdatesEnabled(true);
      scene_.repaint();
      scene_.setUpdatesEnabled(false);
      shown_.restart();
    }
    if (!film_->add(studio_->film_picture(film_ratio_).copy(QRect({}, film_choice_.size)))) {
      stop_film(film_->error());
      return;
    }
    ++frames_;
    progress_->setValue(number);
    if (!film_->is_ready()) {
      waiting_ = number + 1;
    } else {
      add_frame(number + 1);
    }
  });
}

void Exporter::take_film(bool is_whole) {
  if (!is_whole) {
    stop_film(film_->error());
    return;
  }
  leave_film();
  Q_EMIT said(tr("%1 pictures in '%2'").arg(frames_).arg(film_file_));
  Q_EMIT film_ended(true);
}

void Exporter::stop_film(const std::optional<QString>& why) {
  if (!film_) {
    return;
  }
  leave_film();
  if (why) {
    warn(window_, tr("Not exported"),
         tr("The film could not be written to '%1': %2. What was there before is unchanged.")
             .arg(film_file_, *why),
         "film_failed");
  }
  Q_EMIT film_ended(false);
}

void Exporter::leave_film() {
  film_->disconnect(this);
  film_.release()->deleteLater();  // it may be emitting
  studio_.reset();
  scene_.setUpdatesEnabled(true);
  if (progress_) {
    progress_->disconnect(this);
    progress_->deleteLater();
  }
  time_line_.go_to_now();
}

// Recordings and commands

void Exporter::record() {
  const QString file = ask_for_file(tr("Record the next run: 10 samples per simulated second"),
                                    "run.mcap", tr("Recordings (*.mcap *.csv)"), window_);
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
