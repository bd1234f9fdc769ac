// Exports pictures, films, recordings, and the command that repeats a run.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <memory>
#include <optional>

#include "export/export_dialogs.h"

class QProgressDialog;
class QWidget;

namespace elsie::desktop {

class FilmWriter;
class Past;
class SceneView;
class TimeLine;
class Workbench;

/// Files are written whole or not at all.
class Exporter : public QObject {
  Q_OBJECT

 public:
  /// `window` owns this object and the dialogs.
  Exporter(Workbench& workbench, SceneView& scene, TimeLine& time_line, const Past& past,
           QWidget* window);
  ~Exporter() override;

  /// These ask the user for the file.
  void export_picture();
  void export_film();
  void record();
  /// Draws what the view shows, at that size.
  void write_view(const QString& file, const PictureChoice& choice);
  /// Draws the present from above; the engine does it.
  void write_from_above(const QString& file, const PictureChoice& choice);
  /// Writes the run from its start to now. The window stays usable meanwhile; when the run goes on,
  /// the film is given up.
  void write_film(const QString& file);
  void write_film(const QString& file, const FilmChoice& choice);
  /// Records the next run, from its start, into a CSV or MCAP file.
  void record_into(const QString& file);
  /// Copies the command line that repeats the run to the clipboard.
  void copy_command();

 Q_SIGNALS:
  void said(const QString& sentence);
  void picture_ended(bool is_whole);
  /// The film was completed, or not.
  void film_ended(bool is_whole);

 private:
  void end_picture(const QString& file, const QString& why);
  /// A view like that of the window, for pictures of another size.
  std::unique_ptr<SceneView> studio(const QSize& pixels, double ratio);
  void show_time_in_view();
  void add_frame(int number);
  /// `why`: what is wrong; nullopt: the user has cancelled it.
  void stop_film(const std::optional<QString>& why);
  void take_film(bool is_whole);
  void leave_film();

  Workbench& workbench_;
  SceneView& scene_;
  TimeLine& time_line_;
  const Past& past_;
  QWidget* window_;

  std::unique_ptr<SceneView> studio_;
  std::unique_ptr<FilmWriter> film_;
  int film_number_ = 0;  // answers to another film's orders are ignored
  FilmChoice film_choice_;
  double film_ratio_ = 1.0;
  double film_rate_ = 25.0;
  QString film_file_;
  double film_until_s_ = 0.0;
  int again_ = 0;        // how often the present frame was asked for in vain
  QElapsedTimer shown_;  // since the view has shown a picture of it
  int frames_ = 0;
  std::optional<int> waiting_;  // the frame for which the film has no room yet
  QPointer<QProgressDialog> progress_;
};

}  // namespace elsie::desktop
