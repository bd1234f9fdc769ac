// Films in the formats that people share.
#pragma once

#include <QObject>
#include <QProcess>
#include <QSize>
#include <memory>

#include "elsie/files/replacement.h"

class QImage;

namespace elsie::desktop {

/// Receives the pictures of a film one after another, and replaces its file once it is whole.
class FilmWriter : public QObject {
  Q_OBJECT

 public:
  /// The writer for the ending of the file: .avi, or with the program ffmpeg .mp4, .webm and .gif.
  /// All pictures have this size.
  static std::unique_ptr<FilmWriter> for_file(const QString& file, const QSize& size);
  /// Whether the file has one of these endings.
  static bool can_write(const QString& file);
  /// The program; "" if it is not installed.
  static QString ffmpeg();
  /// The endings that need it.
  static QStringList endings_with_ffmpeg();
  /// Pictures per second of a film with this ending.
  static double rate_of(const QString& file);

  /// Takes the next picture. Returns false after an error.
  virtual bool add(const QImage& picture) = 0;
  /// Whether the next picture should be added now; otherwise has_room() comes.
  virtual bool is_ready() const { return true; }
  /// No more pictures come: finished() follows.
  virtual void end() = 0;
  /// Why it failed; "" if it has not.
  virtual QString error() const = 0;

 Q_SIGNALS:
  void has_room();
  void finished(bool is_whole);
};

/// Passes pictures to ffmpeg, which runs beside the window: its code is not part of this program.
class PipedFilm : public FilmWriter {
  Q_OBJECT

 public:
  PipedFilm(const QString& file, const QSize& size);
  ~PipedFilm() override;

  bool add(const QImage& picture) override;
  bool is_ready() const override;
  void end() override;
  QString error() const override;

 private:
  void finish();

  QSize size_;
  files::Replacement written_;
  QProcess process_;
  QString why_;
  QByteArray said_;
  bool is_over_ = false;
};

}  // namespace elsie::desktop
