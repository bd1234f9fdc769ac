// What the window costs: a run at full speed in it against the same run by `elsie run`, the time to
// the first picture, pictures per second and how fine they are, the time to the finest picture, the
// processor time of a picture of a film, and that of a window and its engine that are paused.
//
//   desktop [--repeats N]
//
// World: arena_of_robots.h. The runs are done in turn, and the ratio is taken pair by pair, because
// machines drift. Without a display it draws into memory. Prints tables in Markdown.
#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTimer>
#include <clocale>
#include <cstdio>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include "elsie/world/writer.h"

#include "arena_of_robots.h"
#include "export/exporter.h"
#include "main_window.h"
#include "scene/scene_view.h"
#include "statistics.h"

namespace {

using elsie::bench::median;
using elsie::desktop::MainWindow;
using elsie::desktop::Workbench;
using Json = nlohmann::json;

constexpr int kPatience_ms = 120'000;
constexpr int kStepsInAll = 200'000;  // robot-steps of one run
constexpr int kWatched_ms = 5000;
constexpr int kWatchedPaused_ms = 20'000;  // the kernel counts in steps of 10 ms
constexpr QSize kSize(1280, 800);
constexpr const char* kFirstPicture = "--first-picture";

QString elsie_program() { return QApplication::applicationDirPath() + "/elsie"; }

void wait_for(const std::function<bool()>& is_so) {
  QElapsedTimer waited;
  waited.start();
  while (!is_so()) {
    if (waited.hasExpired(kPatience_ms)) {
      throw std::runtime_error("the window does not get on");
    }
    QApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents);
  }
}

void go_on_for(int duration_ms) {
  bool is_over = false;
  QTimer::singleShot(duration_ms, [&] { is_over = true; });
  wait_for([&] { return is_over; });
}

/// Counts the pictures of the scene.
class Pictures : public QObject {
 public:
  explicit Pictures(MainWindow& window) { window.scene().installEventFilter(this); }
  int count() const { return count_; }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    count_ += event->type() == QEvent::Paint ? 1 : 0;
    return false;
  }

 private:
  int count_ = 0;
};

/// A window of 1280 x 800 with this world, as the program opens it.
class Window {
 public:
  explicit Window(const QString& world) : window_(elsie_program(), {}) {
    // A timer that wakes whoever waits, also when nothing else happens.
    wake_.start(50);
    window_.resize(kSize);
    window_.show();
    if (!window_.open(world)) {
      throw std::runtime_error("the window did not open " + world.toStdString());
    }
  }
  MainWindow& window() { return window_; }
  Workbench& bench() { return window_.workbench(); }
  void be_ready() {
    wait_for([&] { return bench().is_right() && !bench().catalog().is_empty(); });
    wake_.stop();
  }

 private:
  QTimer wake_;
  MainWindow window_;
};

QString world_file(const QTemporaryDir& folder, int robots, double duration_s) {
  elsie::world::World world = elsie::bench::arena_of_robots(robots);
  world.limits.time = duration_s;
  QFile file(folder.filePath("world.xml"));
  if (!file.open(QIODevice::WriteOnly) ||
      file.write(elsie::world::write_world(world).c_str()) < 0) {
    throw std::runtime_error("cannot write into " + folder.path().toStdString());
  }
  return file.fileName();
}

/// Seconds from the order to run until the news of its end.
double in_the_window(Window& window) {
  std::optional<double> seconds;
  QElapsedTimer clock;
  QObject here;
  QObject::connect(&window.bench(), &Workbench::ended, &here,
                   [&] { seconds = 1e-9 * static_cast<double>(clock.nsecsElapsed()); });
  window.bench().reset(1);
  wait_for([&] { return window.bench().run_state() == Workbench::Run::ready; });
  window.bench().set_speed(0.0);
  clock.start();
  window.bench().run();
  wait_for([&] { return seconds.has_value(); });
  return *seconds;
}

/// Seconds of the run alone, without starting and reading.
double headless(const QString& world) {
  QProcess elsie;
  elsie.start(elsie_program(), {"run", world, "--seed", "1", "--json"});
  if (!elsie.waitForFinished(kPatience_ms)) {
    throw std::runtime_error("elsie run does not end");
  }
  return Json::parse(elsie.readAllStandardOutput().toStdString()).at("wall_s");
}

void compare(const QTemporaryDir& folder, int robots, int repeats) {
  const int steps = kStepsInAll / robots;
  const QString world = world_file(folder, robots, 0.01 * steps);
  Window window(world);
  window.be_ready();
  in_the_window(window);  // warm up
  std::vector<double> with, without, ratios;
  for (int i = 0; i < repeats; ++i) {
    with.push_back(kStepsInAll / in_the_window(window));
    without.push_back(kStepsInAll / headless(world));
    ratios.push_back(with.back() / without.back());
  }
  const auto [low, high] = std::minmax_element(ratios.begin(), ratios.end());
  std::printf("| %d | %.0f | %.0f | %.2f | %.2f to %.2f |\n", robots, median(with), median(without),
              median(ratios), *low, *high);
  std::fflush(stdout);
}

struct Moving {
  double pictures_per_second;
  std::size_t quality;  // from 0 to the number of levels, without it
  double finest_s;      // from the last movement to the finest picture
};

Moving moving_pictures(const QTemporaryDir& folder) {
  Window window(world_file(folder, 100, 1e6));
  window.be_ready();
  const Pictures pictures(window.window());
  const auto& photograph = window.window().scene().photograph();
  window.bench().set_speed(0.0);
  window.bench().run();
  go_on_for(1500);
  const int before = pictures.count();
  QElapsedTimer clock;
  clock.start();
  go_on_for(kWatched_ms);
  const double rate = 1e3 * (pictures.count() - before) / static_cast<double>(clock.elapsed());
  const std::size_t quality = photograph.quality().number();
  QTimer wake;
  wake.start(10);
  window.bench().pause();
  wait_for([&] { return window.bench().run_state() == Workbench::Run::paused; });
  clock.restart();
  wait_for([&] { return photograph.is_finished(); });
  return {rate, quality, 1e-3 * static_cast<double>(clock.elapsed())};
}

/// Processor time of a process and all that it has started and that lives, s.
double processor_s(const QString& process) {
  // man 5 proc: after the name in brackets, utime and stime are the 12th and 13th field.
  QFile stat("/proc/" + process + "/stat");
  double used = 0.0;
  if (stat.open(QIODevice::ReadOnly)) {
    const QByteArray line = stat.readAll();
    const QList<QByteArray> fields = line.mid(line.lastIndexOf(')') + 2).split(' ');
    used = (fields.value(11).toDouble() + fields.value(12).toDouble()) /
           static_cast<double>(sysconf(_SC_CLK_TCK));
  }
  const QDir tasks("/proc/" + process + "/task");
  for (const QString& task : tasks.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    QFile children(tasks.filePath(task + "/children"));
    if (children.open(QIODevice::ReadOnly)) {
      for (const QByteArray& child : children.readAll().simplified().split(' ')) {
        used += child.isEmpty() ? 0.0 : processor_s(child);
      }
    }
  }
  return used;
}

/// Of the window and its engine.
double processor_s() { return processor_s(QString::number(QCoreApplication::applicationPid())); }

/// Processor time of a picture of a film of 100 robots, ms.
double film_ms(const QTemporaryDir& folder, const QSize& size) {
  constexpr double kUntil_s = 2.0;
  Window window(world_file(folder, 100, kUntil_s));
  window.be_ready();
  window.bench().run();
  QTimer wake;
  wake.start(20);
  wait_for([&] { return window.bench().run_state() == Workbench::Run::ended; });
  wait_for([&] { return window.window().scene().photograph().is_finished(); });
  auto* exporter = window.window().findChild<elsie::desktop::Exporter*>();
  std::optional<bool> is_whole;
  QObject here;
  QObject::connect(exporter, &elsie::desktop::Exporter::film_ended, &here,
                   [&](bool whole) { is_whole = whole; });
  const double before = processor_s();
  exporter->write_film(folder.filePath("film.avi"), {"avi", size, 1.0});
  wait_for([&] { return is_whole.has_value(); });
  const double pictures = 25.0 * kUntil_s + 1.0;
  return 1e3 * (processor_s() - before) / pictures;
}

double share_when_paused(const QTemporaryDir& folder) {
  Window window(world_file(folder, 100, 1e6));
  window.be_ready();
  window.bench().set_speed(1.0);
  window.bench().run();
  go_on_for(1000);
  window.bench().pause();
  QTimer wake;
  wake.start(50);
  wait_for([&] { return window.window().scene().photograph().is_finished(); });
  wake.stop();
  go_on_for(500);
  QElapsedTimer clock;
  const double before = processor_s();
  clock.start();
  go_on_for(kWatchedPaused_ms);
  return 1e3 * (processor_s() - before) / static_cast<double>(clock.elapsed());
}

/// Of a process of its own, which does what the program does: "seen" once the world is drawn.
int show_first_picture(const QString& world) {
  Window window(world);
  const Pictures pictures(window.window());
  std::optional<int> before;
  QObject::connect(&window.bench(), &Workbench::described, &window.window(),
                   [&] { before = before.value_or(pictures.count()); });
  wait_for([&] { return before && pictures.count() > *before; });
  std::puts("seen");
  std::fflush(stdout);
  return 0;
}

double seconds_to_first_picture() {
  QElapsedTimer clock;
  clock.start();
  QProcess process;
  process.start(QApplication::applicationFilePath(),
                {kFirstPicture, QStringLiteral(ELSIE_SOURCE_DIR "/worlds/ten_robots.xml")});
  if (!process.waitForReadyRead(kPatience_ms) ||
      !process.readAllStandardOutput().startsWith("seen")) {
    throw std::runtime_error("the world of ten robots was not drawn");
  }
  const double seconds = 1e-3 * static_cast<double>(clock.elapsed());
  process.waitForFinished();
  return seconds;
}

void measure_all(int repeats) {
  QTemporaryDir folder;
  std::printf(
      "| robots | in the window, robot-steps/s | elsie run, robot-steps/s | ratio | spread of the "
      "ratio |\n|---|---|---|---|---|\n");
  for (const int robots : {10, 100}) {
    compare(folder, robots, repeats);
  }
  std::vector<double> first;
  for (int i = 0; i < repeats; ++i) {
    first.push_back(seconds_to_first_picture());
  }
  const Moving moving = moving_pictures(folder);
  std::printf(
      "\nFrom the start of the program to the first picture of `worlds/ten_robots.xml`: %.2f s "
      "(median of %d).\n100 robots with 8 beams each at full speed, %d x %d: %.0f pictures a "
      "second, of level %zu of 0 to %zu;\n%.1f s after a pause the picture is as fine as it gets. "
      "Paused, window and\nengine together: %.2f %% of a processor. Drawn by the platform '%s'.\n",
      median(first), repeats, kSize.width(), kSize.height(), moving.pictures_per_second,
      moving.quality, elsie::desktop::Quality::kLevels.size() - 1, moving.finest_s,
      100 * share_when_paused(folder), QApplication::platformName().toUtf8().constData());
  for (const QSize& size : {QSize(320, 180), QSize(1280, 720)}) {
    std::printf("A picture of a film of them, %d x %d, takes %.0f ms of processor time.\n",
                size.width(), size.height(), film_ms(folder, size));
  }
}

}  // namespace

int main(int argc, char** argv) try {
  const QTemporaryDir settings;  // not the user's
  qputenv("XDG_CONFIG_HOME", settings.path().toUtf8());
  qputenv("XDG_DATA_HOME", settings.path().toUtf8());
  if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
      qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
  }
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  const QStringList words = QApplication::arguments();
  if (words.size() == 3 && words[1] == kFirstPicture) {
    return show_first_picture(words[2]);
  }
  const int repeats = words.size() == 3 && words[1] == "--repeats" ? words[2].toInt() : 9;
  if (repeats < 1 || (words.size() != 1 && words.size() != 3)) {
    std::fprintf(stderr, "usage: desktop [--repeats N]\n");
    return 2;
  }
  measure_all(repeats);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
