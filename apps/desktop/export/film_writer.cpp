#include "export/film_writer.h"

#include <QFileInfo>
#include <QHash>
#include <QImage>
#include <QStandardPaths>
#include <QTimer>
#include <cerrno>
#include <system_error>
#include <utility>

#include "elsie/files/write_whole.h"

#include "export/film.h"

namespace elsie::desktop {
namespace {

constexpr double kRate = 25.0;
constexpr double kGifRate = 12.5;   // its files are large
constexpr qint64 kMostPending = 4;  // pictures in the pipe

QString ending_of(const QString& file) { return QFileInfo(file).suffix().toLower(); }

QString reason_of(int error) {
  return QString::fromStdString(std::generic_category().message(error));
}

/// What ffmpeg is asked to write.
const QHash<QString, QStringList>& encodings() {
  static const QHash<QString, QStringList> all{
      {QStringLiteral("mp4"),
       {"-c:v", "libx264", "-preset", "veryfast", "-crf", "20", "-pix_fmt", "yuv420p", "-movflags",
        "+faststart", "-f", "mp4"}},
      {QStringLiteral("webm"),
       {"-c:v", "libvpx-vp9", "-crf", "30", "-b:v", "0", "-deadline", "realtime", "-cpu-used", "6",
        "-row-mt", "1", "-pix_fmt", "yuv420p", "-f", "webm"}},
      // A palette for each picture, because one for all would keep all in memory.
      {QStringLiteral("gif"),
       {"-filter_complex",
        "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=bayer", "-f",
        "gif"}}};
  return all;
}

/// Motion JPEG, written here.
class AviFilm : public FilmWriter {
 public:
  explicit AviFilm(const QString& file) : film_(file, kRate) {}

  bool add(const QImage& picture) override { return film_.add(picture); }
  void end() override {
    is_whole_ = film_.end();
    Q_EMIT finished(is_whole_);
  }
  QString error() const override { return is_whole_ ? QString() : film_.error(); }

 private:
  Film film_;
  bool is_whole_ = false;
};

}  // namespace

std::unique_ptr<FilmWriter> FilmWriter::for_file(const QString& file, const QSize& size) {
  if (encodings().contains(ending_of(file))) {
    return std::make_unique<PipedFilm>(file, size);
  }
  return std::make_unique<AviFilm>(file);
}

bool FilmWriter::can_write(const QString& file) {
  return encodings().contains(ending_of(file)) || ending_of(file) == QLatin1String("avi");
}

QString FilmWriter::ffmpeg() { return QStandardPaths::findExecutable(QStringLiteral("ffmpeg")); }

QStringList FilmWriter::endings_with_ffmpeg() { return {"mp4", "webm", "gif"}; }

double FilmWriter::rate_of(const QString& file) {
  return ending_of(file) == QLatin1String("gif") ? kGifRate : kRate;
}

PipedFilm::PipedFilm(const QString& file, const QSize& size)
    : size_(size), written_(files::end_of_links(file.toStdString())) {
  if (written_.error() != 0) {
    why_ = reason_of(written_.error());
    return;
  }
  const QString program = ffmpeg();
  if (program.isEmpty()) {
    why_ = tr("the program ffmpeg is not installed; 'sudo apt install ffmpeg' installs it");
    return;
  }
  connect(&process_, &QProcess::bytesWritten, this, [this] {
    if (is_ready()) Q_EMIT has_room();
  });
  connect(&process_, &QProcess::readyReadStandardError, this,
          [this] { said_ += process_.readAllStandardError(); });
  connect(&process_, &QProcess::finished, this, &PipedFilm::finish);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) {
      why_ = process_.errorString();
      finish();
    }
  });
  process_.setStandardOutputFile(QProcess::nullDevice());
  process_.start(program, QStringList{"-hide_banner", "-loglevel", "error", "-y", "-f", "rawvideo",
                                      "-pix_fmt", "rgb24", "-s",
                                      QStringLiteral("%1x%2").arg(size.width()).arg(size.height()),
                                      "-r", QString::number(rate_of(file)), "-i", "-", "-an"} +
                              encodings().value(ending_of(file)) +
                              QStringList{QString::fromStdString(written_.path().string())});
}

PipedFilm::~PipedFilm() {
  process_.disconnect(this);
  process_.kill();
  process_.waitForFinished(1000);
}

bool PipedFilm::add(const QImage& picture) {
  if (!why_.isEmpty() || is_over_) {
    return false;
  }
  const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
  const QImage fitting = rgb.size() == size_ ? rgb : rgb.scaled(size_);
  for (int y = 0; y < fitting.height(); ++y) {  // rows of an image are padded
    process_.write(reinterpret_cast<const char*>(fitting.constScanLine(y)),
                   qint64{3} * fitting.width());
  }
  return true;
}

bool PipedFilm::is_ready() const {
  return process_.bytesToWrite() < kMostPending * 3 * size_.width() * size_.height();
}

void PipedFilm::end() {
  if (is_over_ || process_.state() == QProcess::NotRunning) {
    QTimer::singleShot(0, this, &PipedFilm::finish);
  } else {
    process_.closeWriteChannel();  // finished() follows
  }
}

void PipedFilm::finish() {
  if (std::exchange(is_over_, true)) {
    return;
  }
  if (why_.isEmpty() &&
      (process_.exitStatus() != QProcess::NormalExit || process_.exitCode() != 0)) {
    const QString last = QString::fromLocal8Bit(said_).trimmed().section(u'\n', -1);
    why_ = said_.contains("No space left on device") ? reason_of(ENOSPC)  // in any language
           : last.isEmpty() ? tr("ffmpeg ended with exit code %1").arg(process_.exitCode())
                            : tr("ffmpeg says '%1'").arg(last);
  }
  if (why_.isEmpty() && written_.replace() != 0) {
    why_ = reason_of(written_.error());
  }
  Q_EMIT finished(why_.isEmpty());
}

QString PipedFilm::error() const { return why_; }

}  // namespace elsie::desktop
