#include "export/film.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QImage>
#include <cmath>

namespace elsie::desktop {
namespace {

constexpr quint32 kHead = 224;  // bytes before the frames
constexpr quint32 kHasIndex = 0x10;
constexpr quint32 kKeyFrame = 0x10;
constexpr int kQuality = 90;

}  // namespace

Film::Film(const QString& file, double frames_per_second, qint64 most)
    : file_(file), rate_(frames_per_second), most_(most) {
  file_.setDirectWriteFallback(false);
  file_.open(QIODevice::WriteOnly);
}

void Film::word(quint32 value) {
  const char bytes[] = {static_cast<char>(value), static_cast<char>(value >> 8U),
                        static_cast<char>(value >> 16U), static_cast<char>(value >> 24U)};
  file_.write(bytes, 4);
}

void Film::half(quint16 value) {
  const char bytes[] = {static_cast<char>(value), static_cast<char>(value >> 8U)};
  file_.write(bytes, 2);
}

void Film::name(const char* four) { file_.write(four, 4); }

// Writes the list of headers with that of the only stream, and the start of the list of frames,
// whose length is `bytes`.
void Film::head(quint32 frames, quint32 bytes) {
  const auto width = static_cast<quint32>(width_), height = static_cast<quint32>(height_);
  const auto period_us = static_cast<quint32>(std::lround(1e6 / rate_));
  name("RIFF");
  word(kHead - 12 + bytes + 8 + 16 * frames);
  name("AVI ");
  name("LIST");
  word(192);
  name("hdrl");
  name("avih");
  word(56);
  for (const quint32 value : {period_us, quint32{0}, quint32{0}, kHasIndex, frames, quint32{0},
                              quint32{1}, largest_, width, height}) {
    word(value);
  }
  for (int i = 0; i < 4; ++i) word(0);
  name("LIST");
  word(116);
  name("strl");
  name("strh");
  word(56);
  name("vids");
  name("MJPG");
  for (const quint32 value : {quint32{0}, quint32{0}, quint32{0}, period_us, quint32{1'000'000},
                              quint32{0}, frames, largest_, quint32{10'000}, quint32{0}}) {
    word(value);
  }
  for (const int value : {0, 0, width_, height_}) half(static_cast<quint16>(value));
  name("strf");
  word(40);
  word(40);
  word(width);
  word(height);
  half(1);
  half(24);
  name("MJPG");
  word(3 * width * height);
  for (int i = 0; i < 4; ++i) word(0);
  name("LIST");
  word(bytes);
  name("movi");
}

bool Film::add(const QImage& picture) {
  if (!file_.isOpen()) {
    return false;
  }
  if (places_.empty()) {
    width_ = picture.width();
    height_ = picture.height();
    head(0, 4);
  }
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!picture.scaled(width_, height_).save(&buffer, "JPG", kQuality)) {
    return false;
  }
  const qint64 index = 16 * (static_cast<qint64>(places_.size()) + 1);
  if (file_.pos() + bytes.size() + index > most_) {
    why_ = QCoreApplication::translate("Film",
                                       "after %1 s it has reached %2 MB, the most that an "
                                       "AVI file can hold; make the window smaller, or the "
                                       "run shorter")
               .arg(static_cast<double>(places_.size()) / rate_, 0, 'f', 1)
               .arg(most_ / 1'000'000);
    return false;
  }
  const auto size = static_cast<quint32>(bytes.size());
  places_.emplace_back(static_cast<quint32>(file_.pos()) - kHead + 4, size);
  largest_ = std::max(largest_, size);
  name("00dc");
  word(size);
  const bool is_whole = file_.write(bytes) == bytes.size();
  if (size % 2 != 0) file_.write("\0", 1);
  return is_whole && file_.error() == QFileDevice::NoError;
}

bool Film::end() {
  if (!file_.isOpen() || places_.empty() || !why_.isEmpty()) {
    return false;
  }
  const auto bytes = static_cast<quint32>(file_.pos()) - kHead + 4;
  name("idx1");
  word(static_cast<quint32>(16 * places_.size()));
  for (const auto& [place, size] : places_) {
    name("00dc");
    word(kKeyFrame);
    word(place);
    word(size);
  }
  file_.seek(0);
  head(static_cast<quint32>(places_.size()), bytes);
  return file_.flush() && file_.commit();  // commit() alone does not notice a full disk
}

}  // namespace elsie::desktop
