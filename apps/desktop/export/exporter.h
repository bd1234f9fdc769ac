// Exports pictures, films, recordings, and the command that repeats a run.
#pragma once

#include <QObject>
#include <QPointer>
#include <memory>

class QProgressDialog;
class QWidget;

namespace elsie::desktop {

class Film;
class SceneView;
class TimeLine;
class Workbench;

/// Files are written whole or not at all.
class Exporter : public QObject {
  Q_OBJECT

 public:
  /// `window` owns this object and the dialogs.
  Exporter(Workbench& workbench, SceneView& scene, TimeLine& time_line, QWidget* window);
  ~Exporter() override;

  /// These ask the user for the file.
  void export_picture();
  void export_film();
  void record();
  /// Writes the run from its start to now into an AVI file, with 25 pictures per second. The window
  /// stays usable meanwhile.
  void write_film(const QString& file);
  /// Records the next run, from its start, into a CSV or MCAP file.
  void record_into(const QString& file);
  /// Copies the command line that repeats the run to the clipboard.
  void copy_command();

 Q_SIGNALS:
  void said(const QString& sentence);
  /// The film was completed, or not.
  void film_ended(bool is_whole);

 private:
  /// Returns "" if the user cancels.
  QString ask_for_file(const QString& title, const QString& name, const QString& kinds);
  void add_frame(int number);
  void end_film(bool is_wanted);

  Workbench& workbench_;
  SceneView& scene_;
  TimeLine& time_line_;
  QWidget* window_;
  std::unique_ptr<Film> film_;
  QString film_file_;
  double film_until_s_ = 0.0;
  QPointer<QProgressDialog> progress_;
};

}  // namespace elsie::desktop
