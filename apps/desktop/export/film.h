// Writes films that players open.
#pragma once

#include <QSaveFile>
#include <QString>
#include <utility>
#include <vector>

class QImage;

namespace elsie::desktop {

/// Writes pictures of one size as JPEG into an AVI file (Motion JPEG), which ffmpeg, VLC, mpv and
/// browsers' converters read. The layout of the file: "AVI RIFF File Reference" (Microsoft).
class Film {
 public:
  /// The limit of players for this format: all offsets are numbers of 31 bits.
  static constexpr qint64 kMostBytes = 0x7fff'0000;

  /// `most` is in bytes; a frame that would make the film longer is refused.
  Film(const QString& file, double frames_per_second, qint64 most = kMostBytes);
  /// Adds a picture. Returns false if the file cannot be written; error() says why.
  bool add(const QImage& picture);
  /// Replaces the file by the finished film. Without this call the file is untouched.
  bool end();
  QString error() const { return why_.isEmpty() ? file_.errorString() : why_; }
  int frames() const { return static_cast<int>(places_.size()); }

 private:
  void head(quint32 frames, quint32 bytes);
  void word(quint32 value);
  void half(quint16 value);
  void name(const char* four);

  QSaveFile file_;
  double rate_;
  qint64 most_;
  QString why_;  // why a frame was refused
  int width_ = 0, height_ = 0;
  std::vector<std::pair<quint32, quint32>>
      places_;  // of the frames, their offsets from the list's start and their lengths
  quint32 largest_ = 0;
};

}  // namespace elsie::desktop
