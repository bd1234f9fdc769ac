// The end of a run as a card over the view, and robots that are stuck while it goes on.
#include <QClipboard>
#include <QLabel>
#include <QToolButton>

#include "authoring/authoring.h"
#include "hands.h"
#include "watch/run_card.h"

using namespace elsie::desktop;

namespace {

/// A robot between two places that pull it alike.
constexpr const char* kTorn = R"(<world format="1">
  <arena length="8" width="8"/>
  <resources><resource id="far" x="3" y="3"/></resources>
  <robots>
    <robot id="torn" x="-0.02">
      <behaviors><go_to_point id="upper" x="0" y="2"/><go_to_point id="lower" x="0" y="-2"/></behaviors>
      <coordinator><fusion_vector_summation/></coordinator>
    </robot>
  </robots>
  <goals><collect/></goals>
  <limits time="30"/>
</world>
)";

/// A robot that is where it wants to be, and another that is not.
QString waiting(const QString& goals) {
  return QString(R"(<world format="1">
  <arena length="8" width="8"/>
  <resources><resource id="far" x="3" y="3"/></resources>
  <robots>
    <robot id="waits" x="-2">
      <behaviors><go_to_point x="-2" y="0"/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
    <robot id="roams" x="2">
      <behaviors><wander/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
  </robots>
  %1
  <limits time="30"/>
</world>
)")
      .arg(goals);
}

QString text_in(Window& window, const char* label) { return window.get<QLabel>(label)->text(); }

}  // namespace

TEST_CASE("The end of a run lies over the view, with its hash to copy, and runs again from there") {
  Room window(QString(kRoom).replace("\"60\"", "\"2\""));
  auto* card = window.get<RunCard>("run_card");
  CHECK_FALSE(card->isVisible());
  const Json end = window.run_to_the_end();
  REQUIRE(wait_for([&] { return card->isVisible(); }));
  CHECK(window->scene().rect().contains(card->geometry()));
  CHECK(text_in(window, "run_card_title") == QString("\u2717 Time is up after 2.0 s"));
  CHECK_FALSE(window.get<QLabel>("run_card_why")->isVisible());
  CHECK(text_in(window, "run_card_collisions") == "0");
  CHECK(text_in(window, "run_card_distance").endsWith(" m"));
  const QString hash = text_of(end, "state_hash");
  CHECK(text_in(window, "run_card_hash") == hash);
  CHECK(card->accessibleName().contains("Time is up after 2.0 s"));
  CHECK(card->accessibleDescription().contains(hash));
  click_on(window.get<QToolButton>("copy_hash"));
  CHECK(QApplication::clipboard()->text() == hash);

  window.bench().set_speed(0.5);
  click_on(window.get<QPushButton>("run_again"));
  REQUIRE(wait_for([&] { return window.bench().run_state() == Workbench::Run::running; }));
  CHECK_FALSE(card->isVisible());
  window.bench().set_speed(0.0);
  REQUIRE(wait_for([&] { return card->isVisible(); }));
  CHECK(text_in(window, "run_card_hash") == hash);
  click_on(window.get<QPushButton>("next_seed"));
  REQUIRE(wait_for([&] { return text_in(window, "run_card_seed") == "2" && card->isVisible(); }));
  CHECK(window.bench().seed() == 2);
}

TEST_CASE("The card of a run is reached and closed by keys, and comes back") {
  Room window(QString(kRoom).replace("\"60\"", "\"1\""));
  auto* card = window.get<RunCard>("run_card");
  window.run_to_the_end();
  REQUIRE(wait_for([&] { return card->isVisible(); }));
  window->scene().setFocus();
  REQUIRE(wait_for([&] { return window->scene().hasFocus(); }));
  press_key(&window->scene(), Qt::Key_Tab);
  CHECK(card->isAncestorOf(QApplication::focusWidget()));
  press_key(card, Qt::Key_Escape);
  CHECK_FALSE(card->isVisible());
  CHECK(window->scene().hasFocus());
  window.act("show_end");
  CHECK(card->isVisible());
  CHECK(card->isAncestorOf(QApplication::focusWidget()));
}

TEST_CASE("A notice names a robot that is stuck; the card of the end says why the run failed") {
  Room window{QString(kTorn)};
  auto* notice = window.get<StuckNotice>("stuck_notice");
  run_until(window, 9.0);
  CHECK_FALSE(notice->isVisible());
  run_until(window, 15.0);
  REQUIRE(wait_for([&] { return notice->isVisible(); }));
  const QString said = text_in(window, "stuck_text");
  CHECK(said.startsWith("torn has been stuck for 1"));
  CHECK(said.contains("upper"));
  CHECK(said.contains("lower"));
  CHECK(said.endsWith(" cancel each other."));
  CHECK(notice->accessibleName() == said);
  click_on(window.get<QPushButton>("stuck_select"));
  CHECK(window->findChild<Authoring*>()->selection() == QStringList{"robot[torn]"});
  click_on(notice->findChild<QToolButton*>("close_card"));
  run_until(window, 22.0);
  CHECK_FALSE(notice->isVisible());

  window.run_to_the_end();
  auto* card = window.get<RunCard>("run_card");
  REQUIRE(wait_for([&] { return card->isVisible(); }));
  CHECK(text_in(window, "run_card_title").contains("Time is up after 30.0 s"));
  const QString why = text_in(window, "run_card_why");
  CHECK(why.contains("Resources that were not collected: 1 of 1."));
  CHECK(why.contains("cancel each other."));
  window.after([&] { window.bench().reset(1); });
  CHECK_FALSE(card->isVisible());
}

TEST_CASE("A run that fails by a collision says who touched what, and when") {
  Room window(QString(kRoom)
                  .replace("x=\"-1\"", "x=\"0\" y=\"1\"")
                  .replace("<wander/>", "<wander turn=\"0\" restlessness=\"0\"/>")
                  .replace("<limits", "<goals><no_collision/></goals><limits"));
  window.run_to_the_end();
  REQUIRE(wait_for([&] { return window.get<RunCard>("run_card")->isVisible(); }));
  CHECK(text_in(window, "run_card_title").contains("Failed after"));
  CHECK(text_in(window, "run_card_why").contains("r1 touched 'crate' at "));
}

TEST_CASE("A notice names a robot that nobody asks to move while a goal waits for it") {
  const auto runs_to_15_s = [](Window& window) {
    bool is_said = false;
    QObject::connect(&window.bench(), &Workbench::stuck, [&](const Json&) { is_said = true; });
    run_until(window, 15.0);
    REQUIRE(wait_for([&] { return is_said; }));
    QApplication::processEvents();
    return window.get<StuckNotice>("stuck_notice")->isVisible();
  };
  for (const char* goals :
       {"<goals><collect/></goals>", "<goals><reach robot=\"waits\" x=\"3\" y=\"0\"/></goals>"}) {
    INFO(goals);
    Room window(waiting(goals));
    REQUIRE(runs_to_15_s(window));
    const QString said = text_in(window, "stuck_text");
    CHECK(said.startsWith("waits has stood still for 1"));
    CHECK(said.endsWith(" s: no behaviour asks it to move."));
  }
  for (const char* goals :
       {"", "<goals><reach robot=\"roams\" x=\"3.9\" y=\"3.9\" radius=\"0.01\"/></goals>",
        "<goals><reach robot=\"waits\" x=\"-2\" y=\"0\" radius=\"0.5\"/>"
        "<travel robot=\"roams\" distance=\"1000\"/></goals>"}) {
    INFO(goals);
    Room window{waiting(goals)};
    CHECK_FALSE(runs_to_15_s(window));
  }
}

TEST_CASE("The buttons of the card stay where they are, however much it says") {
  Room window;
  auto* card = window.get<RunCard>("run_card");
  const auto places = [&](const Json& more) {
    Json end{{"time_s", 12.0}, {"seed", 1}, {"state_hash", "0123456789abcdef"}};
    end.update(more);
    card->show_end(end);
    QApplication::processEvents();  // the layout
    std::vector<QPoint> all;
    for (const char* name : {"run_again", "next_seed", "copy_hash"}) {
      all.push_back(window.get<QWidget>(name)->mapTo(&window.window(), QPoint()));
    }
    return all;
  };
  const auto after_success = places({{"outcome", "success"}});
  const int height = card->height();
  const Json goal{{"goal", "collect"}, {"missing", 1}, {"of", 2}};
  CHECK(places({{"outcome", "time_limit"}, {"open_goals", {goal, goal, goal}}}) == after_success);
  CHECK(card->height() > height);
  CHECK(window->scene().rect().contains(card->geometry()));
}
