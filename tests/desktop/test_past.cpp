// The past of a run, which the time line shows.
#include <QDockWidget>
#include <QLabel>
#include <QLineF>
#include <QToolButton>

#include <catch2/catch.hpp>

#include "control_bar.h"
#include "hands.h"
#include "paint/axes.h"
#include "watch/coordination_panel.h"
#include "watch/fuzzy_instant.h"
#include "watch/fuzzy_panel.h"
#include "watch/plots_panel.h"
#include "watch/vision_panel.h"

using namespace elsie::desktop;

namespace {

/// A table of numbers by its columns.
struct Table {
  explicit Table(const QString& file) {
    QFile opened(file);
    REQUIRE(opened.open(QIODevice::ReadOnly));
    const QStringList names = QString::fromUtf8(opened.readLine()).trimmed().split(',');
    while (!opened.atEnd()) {
      const QStringList cells = QString::fromUtf8(opened.readLine()).trimmed().split(',');
      for (int i = 0; i < names.size(); ++i) {
        columns[names[i]].push_back(cells.value(i).toFloat());
      }
    }
  }
  const std::vector<float>& operator[](const QString& name) const {
    REQUIRE(columns.contains(name));
    return columns.find(name)->second;
  }
  std::map<QString, std::vector<float>> columns;
};

/// A recording of the world with this seed by `elsie run`.
Table recorded(Window& window, const QString& world, double duration_s) {
  const QString table = window.folder() + "/recorded.csv";
  run_elsie(
      {"run", world, "--duration", QString::number(duration_s), "--record", table, "--quiet"});
  return Table(table);
}

/// Whether every second sample of the trail of r1, until the time of a row, is a row of the
/// recording, and none is missing.
bool is_driven(const SceneView& scene, const Table& table, std::size_t rows, double until_s) {
  const auto pieces = scene.trails().pieces("r1", until_s);
  if (pieces.size() != 1 || pieces[0].size() != 2 * rows - 1) {
    return false;
  }
  for (std::size_t row = 0; row < rows; ++row) {
    if (pieces[0][2 * row] != QPointF(table["x_m"][row], table["y_m"][row])) {
      return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("At greatest speed, trails and plots are those of a recording") {
  Room window;
  const QString room = window.bench().file();
  window.get<QDockWidget>("dock_plots")->raise();
  auto* plots = window->findChild<PlotsPanel*>();
  window.run_to_the_end();
  const Table table = recorded(window, room, 60.0);
  const std::size_t rows = table["x_m"].size();
  REQUIRE(rows == 601);
  const SceneView& scene = window->scene();
  CHECK(wait_for([&] { return is_driven(scene, table, rows, 60.0); }));

  REQUIRE(plots->names().contains("r1/speed"));
  plots->choose("r1/speed", true);  // late: it has its past
  plots->choose("r1/ahead/distance_m", true);
  const QString csv = window.folder() + "/plot.csv";
  REQUIRE(wait_for([&] {
    return plots->sampling() == "1201 samples, up to 0.05 s apart" && plots->save(csv).isEmpty();
  }));
  const Table plot(csv);
  for (std::size_t row = 0; row < rows; ++row) {
    CAPTURE(row);
    REQUIRE(plot["time_s"][2 * row] == table["time_s"][row]);
    REQUIRE(plot["r1/speed"][2 * row] == table["forward_m_s"][row]);
    REQUIRE(plot["r1/ahead/distance_m"][2 * row] == table["sensor[ahead].distance_m"][row]);
  }
  plots->choose("r1/speed", false);
  plots->choose("r1/ahead/distance_m", false);
}

TEST_CASE("After seeking, the trail leads to the shown time, and Coordination shows that time") {
  Room window;
  const QString room = window.bench().file();
  window.get<QDockWidget>("dock_coordination")->raise();
  auto* panel = window->findChild<CoordinationPanel*>();
  const SceneView& scene = window->scene();
  const auto shows = [&](const Table& table, double time_s) {
    return wait_for([&] {
      return std::abs(scene.stage().time_s() - time_s) < 1e-6 &&
             is_driven(scene, table, static_cast<std::size_t>(10.0 * time_s + 1.5),
                       scene.stage().time_s());
    });
  };
  const Table table = recorded(window, room, 30.0);
  auto* line = window->findChild<TimeLine*>();
  line->expect({}, 30.0);
  line->go_to(20.0);  // forward: it runs there as fast as possible
  CHECK(shows(table, 20.0));
  line->go_to(5.0);
  CHECK(shows(table, 5.0));
  const auto has_activation = [&](std::size_t row) {
    return panel->rows() == 1 &&
           panel->row_text(0).contains(
               QString("weight %1, ").arg(table["behavior[wander].weight"][row])) &&
           panel->row_text(0).contains(number_text(table["behavior[wander].turn_rad_s"][row]));
  };
  CHECK(wait_for([&] { return has_activation(50); }));
  line->go_to(12.0);
  CHECK(shows(table, 12.0));
  CHECK(wait_for([&] { return has_activation(120); }));
  line->go_to_now();
  CHECK(shows(table, 20.0));
  CHECK(panel->share_at(0, 3.0) == table["behavior[wander].share"][30]);
  line->go_to(30.0);
  CHECK(shows(table, 30.0));
}

TEST_CASE("A recording that is opened has its own paths, wherever the time line is") {
  Window window;
  const QString room = window.file(kRoom);
  const QString recording = window.folder() + "/run.mcap";
  run_elsie({"run", room, "--duration", "20", "--seed", "3", "--record", recording, "--record",
             window.folder() + "/run.csv", "--quiet"});
  const Table table(window.folder() + "/run.csv");
  REQUIRE(window->open(recording));
  auto* line = window->findChild<TimeLine*>();
  const auto* label = window.get<QLabel>("shown_time");
  REQUIRE(wait_for([&] { return window.bench().is_right() && window.bench().seed() == 3; }));
  const SceneView& scene = window->scene();
  for (const double time_s : {15.0, 4.0, 9.0}) {
    CAPTURE(time_s);
    REQUIRE(wait_for([&] { return label->text().endsWith("of 20.00 s"); }));
    line->go_to(time_s);
    CHECK(wait_for([&] {
      return std::abs(scene.stage().time_s() - time_s) < 1e-6 &&
             is_driven(scene, table, static_cast<std::size_t>(10.0 * time_s + 1.5), time_s);
    }));
  }
}

TEST_CASE("A trail has a gap where a hand put the robot somewhere else, and begins where cleared") {
  Room window;
  run_until(window, 1.0);
  window.after([&] { window.bench().edit({"robot[r1]/@x=0", "robot[r1]/@y=-1"}, "move"); });
  run_until(window, 2.0);
  const Trails& trails = window->scene().trails();
  CHECK(wait_for([&] {
    const auto pieces = trails.pieces("r1", 2.0);
    return pieces.size() == 2 && pieces[0].size() == 21 && pieces[1].size() == 20;
  }));
  window.act("clear_trails");
  CHECK(trails.pieces("r1", 1.9).empty());
  CHECK(trails.pieces("r1", 2.0).size() == 1);
}

TEST_CASE("A run that starts again keeps what is chosen, without its past") {
  Room window;
  window.get<QDockWidget>("dock_plots")->raise();
  auto* plots = window->findChild<PlotsPanel*>();
  auto* panel = window->findChild<CoordinationPanel*>();
  REQUIRE(wait_for([&] { return plots->names().contains("r1/speed"); }));
  plots->choose("r1/speed", true);
  window.get<QDockWidget>("dock_coordination")->raise();
  const Trails& trails = window->scene().trails();
  const auto has_samples = [&](int count) {
    const auto pieces = trails.pieces("r1", 60.0);
    return pieces.size() == 1 && static_cast<int>(pieces[0].size()) == count &&
           plots->sampling().startsWith(QString("%1 samples").arg(count));
  };
  run_until(window, 1.0);
  CHECK(wait_for([&] { return has_samples(21) && panel->rows() == 1; }));
  CHECK(wait_for([&] { return panel->share_at(0, 0.5) == 1.0; }));
  window.after([&] { window.act("reset"); });
  CHECK(wait_for([&] { return has_samples(1); }));
  CHECK(plots->chosen() == QStringList{"r1/speed"});
  REQUIRE(wait_for([&] { return panel->rows() == 1; }));
  CHECK(std::isnan(panel->share_at(0, 0.5)));
  run_until(window, 0.5);
  CHECK(wait_for([&] { return has_samples(11) && panel->share_at(0, 0.4) == 1.0; }));
  plots->choose("r1/speed", false);
}

TEST_CASE("A trail is painted through points a centimetre apart, and a robot that stands has one") {
  Window window;
  window.open(window.file(R"(<world format="1">
  <arena length="4" width="4"/>
  <robots>
    <robot id="stands" x="1"/>
    <robot id="turns" x="1" y="1" max_speed="0.1">
      <behaviors><wander/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
  </robots>
</world>
)"));
  run_until(window, 2.0);
  const Trails& trails = window->scene().trails();
  REQUIRE(wait_for([&] {
    const auto pieces = trails.pieces("turns", 60.0);
    return pieces.size() == 1 && pieces[0].size() == 41;
  }));
  CHECK(trails.pieces("stands", 60.0)[0].size() == 41);
  CHECK(trails.points("stands").size() == 1);
  const std::vector<Trails::Point>& points = trails.points("turns");
  REQUIRE(points.size() > 5);
  CHECK(points.size() < 41);
  for (std::size_t i = 1; i < points.size(); ++i) {
    CHECK(QLineF(points[i - 1].at, points[i].at).length() >= 0.01);
  }
}

TEST_CASE("A step while the view shows the past is one of the present, and the time line says so") {
  Room window;
  run_until(window, 1.0);
  auto* line = window->findChild<TimeLine*>();
  auto* label = window.get<QLabel>("shown_time");
  const double now_s = window.bench().time_s();
  line->setFocus();
  QTest::keyClick(line, Qt::Key_Home);
  REQUIRE(wait_for([&] { return label->text().startsWith("0.00 of"); }));
  QTest::mouseClick(window.get<QToolButton>("step"), Qt::LeftButton);
  REQUIRE(wait_for([&] { return window.bench().time_s() > now_s; }));
  CHECK_FALSE(line->is_in_the_past());
  CHECK(label->text() == QString("%1 s").arg(window.bench().time_s(), 0, 'f', 2));
}

TEST_CASE("Looking back in a run that goes on shows how far it came") {
  Room window;
  window.bench().set_speed(0.0);
  window.bench().run();
  auto* line = window->findChild<TimeLine*>();
  REQUIRE(wait_for([&] { return window.bench().time_s() > 0.5; }));
  line->setFocus();
  QTest::keyClick(line, Qt::Key_Home);
  REQUIRE(wait_for([&] { return window->scene().stage().time_s() == 0.0; }));
  Json span;
  window.bench().ask({{"do", "at"}, {"time_s", 0.0}}, [&](const Json& answer) { span = answer; });
  REQUIRE(wait_for([&] { return !span.is_null(); }));
  const QString shown = QString("0.00 of %1 s").arg(span["to_s"].get<double>(), 0, 'f', 2);
  CHECK(wait_for([&] { return window.get<QLabel>("shown_time")->text() == shown; }));
}

TEST_CASE("An edit while the past is shown is one of the present, which all windows then show") {
  Room window;
  run_until(window, 1.0);
  window.choose("robot[r1]");
  auto* line = window->findChild<TimeLine*>();
  line->go_to(0.5);
  REQUIRE(wait_for([&] { return line->instant() != nullptr; }));
  window.after([&] { enter(field(window, "max_speed"), "0.3"); });
  CHECK_FALSE(line->is_in_the_past());
  CHECK(line->instant() == nullptr);
  CHECK(wait_for([&] {
    return window.get<QLabel>("x_live")->text().startsWith("now at 1.0 s") &&
           window.get<QLabel>("shown_time")->text() == "1.00 s";
  }));
}

TEST_CASE("What is dragged in the past does not change the present") {
  Room window;
  run_until(window, 1.0);
  SceneView& scene = window->scene();
  window.choose("obstacle[crate]");
  auto* line = window->findChild<TimeLine*>();
  line->setFocus();
  QTest::keyClick(line, Qt::Key_Home);
  REQUIRE(wait_for([&] { return scene.stage().time_s() == 0.0; }));
  const auto foot = scene.handle(SceneView::Tool::move);
  const auto goal = scene.pixel_of({-1.0, 1.0, 0.0});
  REQUIRE((foot && goal));
  drag_by_hand(&scene, Qt::LeftButton, foot->toPoint(), goal->toPoint());
  CHECK_FALSE(line->is_in_the_past());
  REQUIRE(wait_for([&] { return scene.stage().time_s() > 0.5; }));
  CHECK(window.bench().text() == kRoom);
  CHECK(window.said().contains("past"));
}

namespace {

/// A robot with all that the windows of a run show.
constexpr const char* kLooking = R"(<world format="1">
  <arena length="4" width="4"/>
  <obstacles><static_box id="crate" x="-0.2" y="0.1"/></obstacles>
  <robots>
    <robot id="r1" team="red" x="-1">
      <sensors><beam_range id="ahead"/><vision id="eye"/></sensors>
      <behaviors><wander/><avoid_obstacle/></behaviors>
      <coordinator><fusion_vector_summation/></coordinator>
    </robot>
  </robots>
  <limits time="60"/>
</world>
)";

/// The value in the row of a sensor's reading.
QString reading(Window& window, const QString& sensor) {
  auto* table = window.get<QTreeWidget>("sensors_table");
  const auto found = table->findItems(sensor, Qt::MatchExactly, 0);
  return found.isEmpty() ? QString() : found.front()->text(3);
}

/// Whether a line of the highlight's colour goes through the middle of the widget at x.
bool has_line(QWidget* widget, double x) {
  const QImage image = widget->grab().toImage();
  const QColor wanted = widget->palette().color(QPalette::Highlight);
  for (int dx = -1; dx <= 1; ++dx) {
    const QPoint at =
        (QPointF(x + dx, widget->height() / 3.0) * image.devicePixelRatio()).toPoint();
    if (image.rect().contains(at) && image.pixelColor(at) == wanted) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("One time is shown by all windows: those of the robot show the values of then") {
  Room window(kLooking);
  window->arrange("watch");
  window.choose("robot[r1]");
  auto* line = window->findChild<TimeLine*>();
  auto* vision = window->findChild<VisionPanel*>();
  auto* fuzzy = window->findChild<FuzzyPanel*>();
  auto* coordination = window->findChild<CoordinationPanel*>();
  const auto raise = [&](const char* name) {
    auto* dock = window.get<QDockWidget>(name);
    dock->show();
    dock->raise();
    REQUIRE(wait_for([&] { return !dock->widget()->visibleRegion().isEmpty(); }));  // and watched
  };
  const auto look = [&](double time_s) {
    line->go_to(time_s);
    REQUIRE(wait_for(
        [&] { return line->instant() && std::abs(line->instant()->time_s - time_s) < 1e-6; }));
  };
  raise("dock_coordination");
  raise("dock_vision");
  run_until(window, 0.5);
  const auto shows = [&](const QString& now) {
    return wait_for([&] { return window.get<QLabel>("x_live")->text().startsWith(now); });
  };
  REQUIRE(shows("now at 0.5 s: x "));
  REQUIRE(wait_for([&] { return !vision->picture("r1/eye raw").isNull(); }));
  const QImage picture = vision->picture("r1/eye raw");
  const QString decision = coordination->row_text(0);
  run_until(window, 1.0);
  REQUIRE(wait_for([&] { return vision->picture("r1/eye raw") != picture; }));
  raise("dock_fuzzy");
  run_until(window, 1.5);
  REQUIRE(wait_for([&] { return fuzzy->now().inputs.size() == 2; }));
  const std::vector<double> inputs = fuzzy->now().inputs;
  run_until(window, 2.0);
  raise("dock_sensors");
  run_until(window, 2.5);
  CHECK(shows("now at 2.5 s: x "));
  REQUIRE(wait_for([&] { return !reading(window, "ahead").isEmpty(); }));
  const QString present = reading(window, "ahead");

  const Table table = recorded(window, window.bench().file(), 2.0);
  look(0.5);
  CHECK(vision->picture("r1/eye raw") == picture);
  CHECK(vision->notice().isEmpty());
  CHECK(reading(window, "ahead") == number_text(table["sensor[ahead].distance_m"][5]) + " m");
  CHECK(wait_for([&] { return coordination->row_text(0) == decision; }));
  const QString x = QString::number(table["x_m"][5], 'f', 2);
  CHECK(
      wait_for([&] { return window.get<QLabel>("x_live")->text() == "at 0.50 s: x " + x + " m"; }));
  const QString speed = QString::number(table["forward_m_s"][5], 'f', 2);
  CHECK(window.get<QLabel>("max_speed_live")->text() == "at 0.50 s: speed " + speed + " m/s");

  look(1.5);
  CHECK(fuzzy->notice().isEmpty());
  REQUIRE(fuzzy->now().inputs.size() == 2);
  CHECK(fuzzy->now().inputs[0] == Approx(inputs[0]));
  CHECK(fuzzy->now().inputs[1] == Approx(inputs[1]).margin(1e-6));
  CHECK(vision->picture("r1/eye raw").isNull());
  CHECK(vision->notice().contains("1.50 s"));

  look(2.3);  // the sensors were shown, and no model
  CHECK(fuzzy->notice().contains("2.30 s"));
  CHECK(fuzzy->now().inputs.empty());

  click_on(window.get<QToolButton>("now"));
  CHECK(shows("now at 2.5 s: x "));
  CHECK(reading(window, "ahead") == present);
  CHECK_FALSE(vision->picture("r1/eye raw").isNull());
  CHECK(fuzzy->notice().isEmpty());
}

TEST_CASE(
    "The time line moves a line in the plots and in Coordination, and a click there moves it") {
  Room window;
  window.get<QDockWidget>("dock_plots")->raise();
  auto* plots = window->findChild<PlotsPanel*>();
  auto* coordination = window->findChild<CoordinationPanel*>();
  auto* plot = window.get<QWidget>("plot");
  const SceneView& scene = window->scene();
  run_until(window, 3.0);
  REQUIRE(wait_for([&] { return plots->names().contains("r1/speed"); }));
  plots->choose("r1/speed", true);
  REQUIRE(wait_for([&] { return plots->sampling().startsWith("61 samples"); }));
  auto* line = window->findChild<TimeLine*>();
  line->go_to(1.0);
  REQUIRE(wait_for([&] { return std::abs(scene.stage().time_s() - 1.0) < 1e-6; }));
  const auto in_plot = plots->place_of(1.0, plot->size());
  REQUIRE(in_plot);
  CHECK(has_line(plot, *in_plot));
  CHECK(plots->figures().columns[1] == "at 1.00 s");
  const auto later = plots->place_of(2.0, plot->size());
  REQUIRE(later);
  click_at(plot, QPoint(static_cast<int>(*later), plot->height() / 3));
  REQUIRE(wait_for([&] { return std::abs(scene.stage().time_s() - 2.0) < 0.06; }));
  CHECK(line->is_in_the_past());

  window.get<QDockWidget>("dock_coordination")->raise();
  REQUIRE(wait_for([&] { return coordination->rows() == 1; }));
  const auto band = coordination->place_of(0.5);
  REQUIRE(band);
  click_at(coordination->viewport(), QPoint(static_cast<int>(*band), 10));
  REQUIRE(wait_for([&] { return std::abs(scene.stage().time_s() - 0.5) < 0.06; }));
  CHECK(coordination->place_of(0.5) == band);  // the bands stay where they are
  CHECK(has_line(coordination->viewport(), *coordination->place_of(scene.stage().time_s())));
  plots->choose("r1/speed", false);
}
