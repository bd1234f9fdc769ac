// The panels that show a run.
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QDir>
#include <QLineEdit>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>
#include <cmath>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "model_file.h"
#include "paint/axes.h"
#include "stored.h"
#include "waiting.h"
#include "watch/control_surface.h"
#include "watch/coordination_panel.h"
#include "watch/fuzzy_instant.h"
#include "watch/fuzzy_panel.h"
#include "watch/plots_panel.h"
#include "watch/sensors_panel.h"
#include "watch/state.h"
#include "watch/vision_panel.h"

using namespace elsie::desktop;

namespace {

Json state(double time, double share) {
  const QByteArray raw(3 * 8 * 6, static_cast<char>(0x80));
  Json member = {{"path", "explore/avoid"},
                 {"depth", 1},
                 {"parent", 0},
                 {"priority", 2.0},
                 {"weight", 0.5},
                 {"activation", 0.75},
                 {"share", share},
                 {"asked", true},
                 {"command", {0.2, 0.0, -1.5}},
                 {"inhibited_by", -1},
                 {"reason", "box 0.3 m ahead"}};
  Json outer = member;
  outer["path"] = "explore";
  outer["depth"] = 0;
  outer["parent"] = -1;
  outer["reason"] = "";
  Json idle = outer;
  idle["path"] = "charge";
  idle["asked"] = false;
  idle["activation"] = nullptr;
  idle["inhibited_by"] = 0;
  return {
      {"event", "state"},
      {"epoch", 1},
      {"time_s", time},
      {"robots",
       {{{"id", "r1"},
         {"members", {outer, member, idle}},
         {"sensors",
          {{{"id", "left"},
            {"plugin", "beam_range"},
            {"fields", {{{"name", "range"}, {"unit", "m"}, {"values", {0.25}}}}}},
           {{"id", "gps"},
            {"plugin", "gps"},
            {"fields", {{{"name", "at"}, {"unit", ""}, {"size", 2}, {"values", {1.5, nullptr}}}}}},
           {{"id", "scan"},
            {"plugin", "lidar"},
            {"fields",
             {{{"name", "ranges"},
               {"unit", "m"},
               {"size", 9},
               {"values", {1, 2, 3, 4, 5, 6, 7, 8, 9}}}}}}}},
         {"cameras",
          {{{"id", "eye"},
            {"pictures",
             {{{"name", "raw"},
               {"width", 8},
               {"height", 6},
               {"pixels", raw.toBase64().toStdString()}}}}}}}}}}};
}

/// Members of one decision with these weights and shares.
Json decision(const std::vector<std::pair<double, double>>& weights_and_shares) {
  Json now = state(0.1, 0.0);
  Json members = Json::array();
  for (const auto& [weight, share] : weights_and_shares) {
    Json member = now["robots"][0]["members"][0];
    member.update({{"path", "b" + std::to_string(members.size())},
                   {"priority", 1.0},
                   {"weight", weight},
                   {"share", share}});
    members.push_back(member);
  }
  now["robots"][0]["members"] = members;
  return now;
}

const QString kShare = QStringLiteral("r1/explore/avoid/share");

}  // namespace

TEST_CASE("ticks are round numbers inside the span") {
  CHECK(ticks({0.0, 1.0}, 5) == std::vector<double>{0.0, 0.2, 0.4, 0.6000000000000001, 0.8, 1.0});
  CHECK(ticks({1.0, 1.0}, 5).empty());
}

TEST_CASE("coordination: a row for each behaviour, with figures and the reason") {
  CoordinationPanel panel;
  panel.set_robot(QStringLiteral("r1"));
  panel.add(state(0.1, 0.5));
  REQUIRE(panel.rows() == 3);
  const QString text = panel.row_text(1);
  CHECK(text.contains(QStringLiteral("explore/avoid")));
  CHECK(text.contains(QStringLiteral("share 50 %")));
  CHECK(text.contains(QStringLiteral("0.2, 0, -1.5")));
  CHECK(text.contains(QStringLiteral("box 0.3 m ahead")));
  CHECK(panel.row_text(2).contains(QStringLiteral("not asked")));
  CHECK(panel.row_text(2).contains(QStringLiteral("inhibited by explore")));
}

TEST_CASE("painted widgets have their figures for screen readers, and as a table for all") {
  CoordinationPanel panel;
  panel.resize(400, 200);
  panel.set_robot(QStringLiteral("r1"));
  panel.add(state(0.1, 0.5));
  panel.show();
  QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(&panel);
  REQUIRE(accessible);
  CHECK(accessible->text(QAccessible::Name) == QStringLiteral("Coordination"));
  const QString said = accessible->text(QAccessible::Value);
  CHECK(said.contains(QStringLiteral("behaviour explore/avoid")));
  CHECK(said.contains(QStringLiteral("share [%] 50")));
  CHECK(said.contains(QStringLiteral("reason box 0.3 m ahead")));
  CHECK(said.contains(QStringLiteral("inhibited by explore")));

  // By the key for menus, as a table.
  QTimer::singleShot(0, &panel, [&] {
    QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Down);
    QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Return);
  });
  QContextMenuEvent wish(QContextMenuEvent::Keyboard, QPoint(5, 5),
                         panel.mapToGlobal(QPoint(5, 5)));
  QApplication::sendEvent(panel.viewport(), &wish);
  REQUIRE(QTest::qWaitFor([&] { return panel.findChild<QTableWidget*>() != nullptr; }, 60'000));
  auto* table = panel.findChild<QTableWidget*>();
  CHECK(table->rowCount() == 3);
  CHECK(table->item(1, 0)->text() == QStringLiteral("explore/avoid"));
  CHECK(table->item(2, 3)->text() == QStringLiteral("not asked"));

  PlotsPanel plots;
  Samples samples;
  samples.add(stored({0.1, 0.2}, {{kShare.toStdString(), {0.25F, 0.75F}}}));
  plots.set_names({kShare});
  plots.set_samples(samples);
  plots.choose(kShare, true);
  auto* plot = plots.findChild<QWidget*>(QStringLiteral("plot"));
  REQUIRE(plot);
  const QString plotted = QAccessible::queryAccessibleInterface(plot)->text(QAccessible::Value);
  CHECK(plotted.contains(QStringLiteral("now 0.75, least 0.25, most 0.75")));

  VisionPanel vision;
  vision.add(state(0.1, 0.5));
  CHECK(vision.figures().rows ==
        std::vector<QStringList>{{QStringLiteral("r1/eye raw"), QStringLiteral("8"),
                                  QStringLiteral("6"), QStringLiteral("#808080")}});
}

TEST_CASE("coordination: the bands are the stored shares, and the rows those of the shown time") {
  CoordinationPanel panel;
  panel.set_robot(QStringLiteral("r1"));
  panel.add(state(0.2, 0.75));
  Samples samples;
  const QStringList names = panel.numbers(true);
  CHECK(names.contains(kShare));
  CHECK_FALSE(panel.numbers(false).contains(QStringLiteral("r1/explore/avoid/weight")));
  samples.add(stored({0.1, 0.15, 0.2}, {{"r1/explore/avoid/share", {0.25F, 0.3F, 0.75F}},
                                        {"r1/explore/avoid/asked", {1.0F, 1.0F, 1.0F}},
                                        {"r1/explore/avoid/weight", {0.125F, 0.2F, 0.5F}},
                                        {"r1/charge/share", {0.0F, 0.0F, 0.0F}},
                                        {"r1/charge/asked", {0.0F, 0.0F, 0.0F}}}));
  panel.set_samples(samples);
  CHECK(panel.share_at(1, 0.12) == 0.25);
  CHECK(panel.share_at(1, 0.2) == 0.75);
  CHECK(std::isnan(panel.share_at(2, 0.2)));
  CHECK(std::isnan(panel.share_at(1, 0.05)));
  panel.look_back(0.1);
  CHECK(panel.row_text(1).contains(QStringLiteral("weight 0.125, share 25 %")));
  CHECK_FALSE(panel.row_text(1).contains(QStringLiteral("box")));  // the reason is not stored
  panel.look_back(std::nullopt);
  CHECK(panel.row_text(1).contains(QStringLiteral("weight 0.5, share 75 %")));
  panel.set_robot(QStringLiteral("r2"));
  CHECK(panel.rows() == 0);
}

TEST_CASE("coordination: a behaviour has the weight of the run, not the world's priority") {
  CoordinationPanel panel;
  panel.set_robot(QStringLiteral("r1"));
  panel.add(decision({{0.999, 0.998}, {0.002, 0.002}}));
  CHECK(panel.row_text(0).contains(QStringLiteral("weight 0.999")));
  CHECK(panel.row_text(1).contains(QStringLiteral("weight 0.002")));
  CHECK_FALSE(panel.row_text(0).contains(QStringLiteral("priority")));
  CHECK(panel.figures().rows[0][2] == QStringLiteral("0.999"));
  panel.add(decision({{3e-7, 1e-6}, {0.3, 0.999999}}));
  CHECK(panel.row_text(0).contains(QStringLiteral("weight 3e-07, share 0 %")));
  CHECK(panel.row_text(1).contains(QStringLiteral("weight 0.3, share 100 %")));
}

TEST_CASE("coordination: the shares of a decision add up to 100 %") {
  CHECK(whole_percents({0.335, 0.335, 0.33}) == std::vector{34, 33, 33});
  CHECK(whole_percents({0.005, 0.995}) == std::vector{1, 99});
  CHECK(whole_percents({0.25, 0.25}) == std::vector{25, 25});  // part of the command
  CHECK(whole_percents({0.0, std::nan("")}) == std::vector{0, 0});
  CHECK(whole_percents({}).empty());
  CoordinationPanel panel;
  panel.set_robot(QStringLiteral("r1"));
  panel.add(decision({{1.0, 0.155}, {1.0, 0.255}, {1.0, 0.59}}));
  int sum = 0;
  for (const QStringList& row : panel.figures().rows) {
    sum += row[3].toInt();
  }
  CHECK(sum == 100);
}

TEST_CASE("samples: those that the engine has dropped are dropped here, too") {
  Samples samples;
  samples.add(stored({0.0, 0.05, 0.1, 0.15}, {{"a", {0.0F, 1.0F, 2.0F, 3.0F}}}));
  const int revision = samples.revision();
  samples.add(stored({0.2}, {{"a", {4.0F}}, {"b", {5.0F}}}));
  CHECK(samples.revision() == revision);
  samples.add(stored({0.3}, {{"a", {6.0F}}, {"b", {7.0F}}}, 0.1));
  CHECK(samples.revision() != revision);
  CHECK(samples.times() == std::vector{0.0, 0.1, 0.2, 0.3});
  CHECK(*samples.curve(QStringLiteral("a")) == std::vector{0.0F, 2.0F, 4.0F, 6.0F});
  CHECK(std::isnan(samples.at(QStringLiteral("b"), 0.15)));
  CHECK(samples.at(QStringLiteral("b"), 0.25) == 5.0F);
  CHECK_FALSE(samples.curve(QStringLiteral("c")));
  CHECK_THROWS(samples.add(stored({0.2}, {{"a", {1.0F}}}, 0.1)));  // an earlier time
  CHECK_THROWS(samples.add(stored({0.4}, {{"a", {1.0F, 2.0F}}}, 0.1)));
  Json damaged = stored({0.4}, {});
  damaged["times"] = "what?";
  CHECK_THROWS(samples.add(damaged));
}

TEST_CASE("sensors: readings, and a filter") {
  SensorsPanel panel;
  panel.set_robot(QStringLiteral("r1"));
  panel.add(state(0.1, 0.5));
  auto* table = panel.findChild<QTreeWidget*>(QStringLiteral("sensors_table"));
  REQUIRE(table->topLevelItemCount() == 4);
  CHECK(table->topLevelItem(0)->text(3) == QStringLiteral("0.25 m"));
  CHECK(table->topLevelItem(1)->text(2) == QStringLiteral("at.0"));
  CHECK(table->topLevelItem(2)->text(3) == QStringLiteral("-"));
  QTest::keyClicks(panel.findChild<QLineEdit*>(QStringLiteral("sensors_filter")),
                   QStringLiteral("GPS"));
  CHECK(table->topLevelItem(0)->isHidden());
  CHECK(!table->topLevelItem(1)->isHidden());
}

TEST_CASE("sensors: what the robot hears, from whom") {
  SensorsPanel panel;
  panel.set_robot(QStringLiteral("r1"));
  Json now = state(0.1, 0.5);
  now["robots"][0]["heard"] = {
      {{"by", "radio"},
       {"from", "r2"},
       {"kind", "offer"},
       {"fields", {{{"name", "x"}, {"unit", "m"}, {"values", {1.5}}}}}},
      {{"by", "radio"}, {"from", ""}, {"kind", "hello"}, {"fields", Json::array()}}};
  panel.add(now);
  auto* table = panel.findChild<QTreeWidget*>(QStringLiteral("sensors_table"));
  REQUIRE(table->topLevelItemCount() == 6);
  CHECK(table->topLevelItem(4)->text(0) == QStringLiteral("radio"));
  CHECK(table->topLevelItem(4)->text(1) == QStringLiteral("heard from r2"));
  CHECK(table->topLevelItem(4)->text(2) == QStringLiteral("offer.x"));
  CHECK(table->topLevelItem(4)->text(3) == QStringLiteral("1.5 m"));
  CHECK(table->topLevelItem(5)->text(1) == QStringLiteral("heard"));
  CHECK(table->topLevelItem(5)->text(2) == QStringLiteral("hello"));
  panel.add(state(0.2, 0.5));
  CHECK(table->topLevelItemCount() == 4);
}

TEST_CASE("sensors: a long array is a strip of bars with its range") {
  SensorsPanel panel;
  panel.set_robot(QStringLiteral("r1"));
  panel.add(state(0.1, 0.5));
  auto* table = panel.findChild<QTreeWidget*>(QStringLiteral("sensors_table"));
  const QTreeWidgetItem* scan = table->topLevelItem(3);
  CHECK(scan->text(2) == QStringLiteral("ranges (9)"));
  CHECK(scan->text(3) == QStringLiteral("1 to 9 m"));
  const QImage strip = scan->data(3, Qt::DecorationRole).value<QPixmap>().toImage();
  REQUIRE(strip.width() > 20);
  CHECK(qAlpha(strip.pixel(1, 1)) == 0);                 // the first number is small
  CHECK(qAlpha(strip.pixel(strip.width() - 2, 1)) > 0);  // the last one is not
}

TEST_CASE("plots: numbers of one unit share an axis, whatever they are called") {
  PlotsPanel panel;
  const QString near = QStringLiteral("r1/scan/ranges.0"), far = QStringLiteral("r1/gps/y");
  panel.set_names({near, far}, {{near, QStringLiteral("m")}, {far, QStringLiteral("m")}});
  panel.choose(near, true);
  panel.choose(far, true);
  const Figures figures = panel.figures();
  REQUIRE(figures.rows.size() == 2);
  CHECK(figures.rows[0][0] == QStringLiteral("r1/gps/y [m]"));
  CHECK(figures.rows[1][0] == QStringLiteral("r1/scan/ranges.0 [m]"));
}

TEST_CASE("vision: pictures as they come, chosen by name") {
  VisionPanel panel;
  panel.resize(300, 200);
  panel.add(state(0.1, 0.5));
  REQUIRE(panel.pictures() == QStringList{QStringLiteral("r1/eye raw")});
  CHECK(panel.picture(QStringLiteral("r1/eye raw")).size() == QSize(8, 6));
  const auto is_drawn = [&] {
    return panel.grab().toImage().pixelColor(150, 120) == QColor(0x80, 0x80, 0x80);
  };
  CHECK(is_drawn());
  panel.set_shown(QStringLiteral("r1/eye raw"), false);
  CHECK(!is_drawn());
}

TEST_CASE("plots: the chosen numbers, saved as a table and as a picture") {
  PlotsPanel panel;
  panel.resize(500, 300);
  const QString far = QStringLiteral("r1/gps/y");
  Samples samples;
  samples.add(stored({0.1, 0.2}, {{kShare.toStdString(), {0.25F, 0.7F}},
                                  {far.toStdString(), {std::nanf(""), std::nanf("")}}}));
  panel.set_names({kShare, far, QStringLiteral("r1/left/range")});
  panel.set_samples(samples);
  panel.choose(kShare, true);
  panel.choose(far, true);
  CHECK(panel.sampling() == QStringLiteral("2 samples, up to 0.1 s apart"));
  QTemporaryDir folder;
  REQUIRE(panel.save(folder.filePath(QStringLiteral("a.csv"))).isEmpty());
  QFile table(folder.filePath(QStringLiteral("a.csv")));
  REQUIRE(table.open(QIODevice::ReadOnly));
  CHECK(table.readAll() ==
        QByteArray("time_s,r1/explore/avoid/share,r1/gps/y\n0.1,0.25,\n0.2,0.7,\n"));
  CHECK(panel.save(folder.filePath(QStringLiteral("a.png"))).isEmpty());
  CHECK(panel.save(folder.filePath(QStringLiteral("a.svg"))).isEmpty());
  CHECK(panel.save(folder.filePath(QStringLiteral("a.doc"))).contains(QStringLiteral(".svg")));
  CHECK(!panel.save(folder.filePath(QStringLiteral("no/a.csv"))).isEmpty());
  CHECK(PlotsPanel()
            .save(folder.filePath(QStringLiteral("b.csv")))
            .contains(QStringLiteral("chosen")));
}

TEST_CASE("plots: the choice stays for numbers of the same names") {
  PlotsPanel panel;
  panel.set_names({kShare});
  panel.choose(kShare, true);
  panel.set_names({QStringLiteral("r2/speed")});
  CHECK(panel.chosen().isEmpty());
  CHECK(panel.choice() == QStringList{kShare});
  panel.set_names({QStringLiteral("r2/speed"), kShare});
  CHECK(panel.chosen() == QStringList{kShare});
}

TEST_CASE("plots: a long curve keeps its peaks") {
  constexpr int kCount = 100'000;
  std::vector<double> times;
  std::vector<float> values(kCount, 0.0F);
  for (int i = 0; i < kCount; ++i) {
    times.push_back(0.05 * i);
  }
  values[kCount / 2] = 1.0F;  // one of hundreds in its column of pixels
  Samples samples;
  samples.add(stored(times, {{kShare.toStdString(), values}}));
  PlotsPanel panel;
  panel.set_names({kShare});
  panel.set_samples(samples);
  panel.choose(kShare, true);
  const QPolygonF points = panel.polygon(kShare, {0.0, times.back()}, 400.0);
  CHECK(points.size() < 4 * 402);
  CHECK(points.contains(QPointF(times[kCount / 2], 1.0)));
  CHECK(points.front().x() == 0.0);
  CHECK(points.back().x() == times.back());
}

TEST_CASE("fuzzy: how far each rule fires now, and a file that cannot be read") {
  const ModelFile model(R"(FUNCTION_BLOCK m
VAR_INPUT range : REAL; END_VAR
VAR_OUTPUT speed : REAL; END_VAR
FUZZIFY range TERM near := (0, 1) (1, 0); TERM far := (0, 0) (1, 1); END_FUZZIFY
DEFUZZIFY speed TERM slow := (0, 1) (1, 0); TERM fast := (0, 0) (1, 1); METHOD : COG; DEFAULT := 0;
END_DEFUZZIFY
RULEBLOCK r
RULE 1 : IF range IS near THEN speed IS slow;
RULE 2 : IF range IS far THEN speed IS fast;
END_RULEBLOCK
END_FUNCTION_BLOCK
)");
  Json now = state(0.1, 0.5);
  now["robots"][0]["fuzzy"] = {{{"path", "avoid"},
                                {"file", model.name()},
                                {"inputs", {{"range", 0.25}}},
                                {"outputs", {{"speed", 0.4}}}}};
  FuzzyPanel panel;
  panel.resize(500, 700);
  panel.set_robot(QStringLiteral("r1"));
  panel.add(now);
  CHECK(panel.problem() == QString());
  CHECK(panel.now().degrees == std::vector<double>{0.75, 0.25});
  const auto* surface = panel.findChild<ControlSurface*>();
  REQUIRE(surface);
  REQUIRE(surface->grid().values.size() == FuzzyGrid::kAcross);
  REQUIRE(panel.now().centres.size() == 1);
  REQUIRE(panel.now().centres[0]);
  CHECK(*panel.now().centres[0] == Approx(0.1927083 / 0.5));  // moment / area, by hand
  CHECK(surface->grid().values[10] == Approx(0.1927083 / 0.5));
  CHECK(surface->figures().columns.size() == 10);
  CHECK(surface->figures().rows.size() == 1);
  const auto* page =
      dynamic_cast<const ShowsFigures*>(panel.findChild<QWidget*>(QStringLiteral("fuzzy_page")));
  REQUIRE(page);
  CHECK(page->figures().rows.size() == 4);  // an input, two rules, an output
  now["robots"][0]["fuzzy"][0]["file"] = "/nowhere.fcl";
  panel.add(now);
  CHECK(panel.problem().contains(QStringLiteral("/nowhere.fcl")));
  CHECK(panel.now().degrees.empty());
  CHECK(surface->grid().values.size() == FuzzyGrid::kAcross);
  CHECK_FALSE(surface->isVisibleTo(&panel));
}
