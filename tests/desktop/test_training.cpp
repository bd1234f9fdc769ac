// Networks: chosen, trained with a curve, used, cleared.
#include <QCheckBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QSpinBox>
#include <QTimer>
#include <optional>

#include <catch2/catch.hpp>

#include "authoring/authoring.h"
#include "hands.h"
#include "training/learning_curve.h"
#include "world/element_dialog.h"
#include "world/form.h"

using namespace elsie::desktop;

namespace {

constexpr const char* kPupil = R"(<world format="1">
  <arena length="8" width="6"/>
  <robots>
    <robot id="r1" team="red" x="-3">
      <sensors>
        <beam_range id="left" yaw_deg="35"/>
        <beam_range id="right" yaw_deg="-35"/>
        <proximity/>
      </sensors>
      <behaviors>
        <avoid_obstacle/>
        <go_to_point x="3" y="0.5"/>
      </behaviors>
      <coordinator><fusion_vector_summation/></coordinator>
    </robot>
  </robots>
  <limits time="20"/>
</world>
)";

constexpr const char* kSamples = "1 1 0 1\n0.2 1 1 0\n1 0.2 1 0\n0.2 0.3 1 0\n";

/// A window with the robot that is to learn, and the dialog of its new network.
class School {
 public:
  School() {
    samples = window.file(kSamples, "samples.txt");
    window->findChild<Authoring*>()->select({"robot[r1]"});
  }

  ElementDialog* new_network(const QString& kind = "fusion_neural_network") {
    window.act("coordinator");
    auto* dialog = window.dialog<ElementDialog>("element_dialog");
    REQUIRE(dialog->choose(kind));
    return dialog;
  }
  ElementDialog* edited_network() {
    window.act("coordinator");
    return window.dialog<ElementDialog>("element_dialog");
  }
  static void enter(ElementDialog* dialog, const char* name, const QString& value) {
    type_over(dialog->findChild<QLineEdit*>(name), value);
  }
  /// Trains, and waits until the robot has the network: then there is only the button Close.
  void train(ElementDialog* dialog) {
    window.press(dialog, QDialogButtonBox::Ok);
    auto* buttons = dialog->findChild<QDialogButtonBox*>("buttons");
    REQUIRE(wait_for([&] { return buttons->button(QDialogButtonBox::Close) != nullptr; }));
  }
  void close(ElementDialog* dialog) {
    window.press(dialog, QDialogButtonBox::Close);
    REQUIRE(wait_for([&] { return !window->findChild<ElementDialog*>(); }));
  }
  void ok(ElementDialog* dialog) {
    train(dialog);
    close(dialog);
  }
  QStringList weight_files() const { return QDir(window.folder()).entryList({"*.weights"}); }

  Room window{kPupil};
  QString samples;
};

QString refusal(const ElementDialog* dialog) {
  const auto* label = dialog->findChild<QLabel*>("refusal");
  return label->isHidden() ? QString() : label->text();
}

}  // namespace

TEST_CASE("A network is trained with a curve before the robot has it, and loaded by one edit") {
  School school;
  Window& window = school.window;
  auto* dialog = school.new_network();
  const QString sizes = dialog->findChild<QLabel*>("network_sizes")->text();
  CHECK(sizes == "Inputs: 2 (left, right)\nOutputs: 2 (avoid_obstacle, go_to_point)");
  School::enter(dialog, "training", "samples.txt");
  School::enter(dialog, "learning_rate", "0.7");
  dialog->findChild<QSpinBox*>("hidden_count")->setValue(1);
  dialog->findChild<QSpinBox*>("hidden_size_1")->setValue(3);
  school.ok(dialog);

  CHECK(school.weight_files() == QStringList{"r1.weights"});
  CHECK(window.bench().text().contains("weights=\"r1.weights\""));
  CHECK(window.bench().text().contains("hidden=\"3\""));
  CHECK(window.bench().text().contains("training=\"samples.txt\""));
  CHECK(window.bench().undo_name() == "replace coordinator");
  window.after([&] { window.bench().undo(); });
  CHECK(window.bench().text() == QString(kPupil));
}

TEST_CASE("After a training its curve and figures stay until Close, and the saved file runs so") {
  School school;
  auto* dialog = school.new_network();
  School::enter(dialog, "training", "samples.txt");
  School::enter(dialog, "threshold", "0.01");
  school.train(dialog);
  CHECK(school.window.bench().text().contains("weights=\"r1.weights\""));  // it is loaded
  CHECK(dialog->isVisible());
  auto* curve = dialog->findChild<LearningCurve*>();
  CHECK(curve->isVisible());
  CHECK(curve->points().size() > 2);
  CHECK(curve->points().back().y() < 0.01);
  const auto* progress = dialog->findChild<QLabel*>("training_progress");
  CHECK(progress->text().startsWith("The network is loaded. Mean error 0.00"));
  CHECK(progress->text().endsWith(" samples."));
  CHECK(refusal(dialog).isEmpty());
  auto* buttons = dialog->findChild<QDialogButtonBox*>("buttons");
  CHECK(buttons->buttons().size() == 1);
  CHECK_FALSE(dialog->findChild<QLineEdit*>("training")->isEnabled());
  CHECK_FALSE(dialog->findChild<QSpinBox*>("hidden_count")->isEnabled());

  QTest::keyClick(dialog, Qt::Key_Escape);  // closes, and takes nothing back
  REQUIRE(wait_for([&] { return !school.window->findChild<ElementDialog*>(); }));
  CHECK(school.window.bench().text().contains("weights=\"r1.weights\""));
  CHECK(school.weight_files() == QStringList{"r1.weights"});
  const QString file = school.window.bench().file();
  REQUIRE(school.window.saved_as(file).isEmpty());
  CHECK(school.window.hash_at_the_end() == headless_hash({file}));
}

TEST_CASE("A training that stops short of its goal says so") {
  School school;
  auto* dialog = school.new_network();
  School::enter(dialog, "training", "samples.txt");
  School::enter(dialog, "threshold", "0.000001");
  School::enter(dialog, "presentations", "20000");
  school.train(dialog);
  const QString said = dialog->findChild<QLabel*>("training_progress")->text();
  CHECK(said.contains("after 20000 samples."));
  CHECK(said.contains("without reaching its goal, a mean error below 0.000001"));
  CHECK(school.window.bench().text().contains("weights=\"r1.weights\""));
}

TEST_CASE("A network is trained again while its robot drives; the old weights stay for undo") {
  School school;
  Window& window = school.window;
  auto* dialog = school.new_network("arbiter_neural_network");
  School::enter(dialog, "training", "samples.txt");
  school.ok(dialog);
  window.bench().run();
  REQUIRE(wait_for([&] { return window.bench().time_s() > 0.2; }));
  window.bench().set_speed(0.1);  // it must not end before the training
  auto* again = school.edited_network();
  School::enter(again, "momentum", "0.5");
  school.ok(again);
  CHECK(school.weight_files() == QStringList{"r1-2.weights", "r1.weights"});
  CHECK(window.bench().text().contains("weights=\"r1-2.weights\""));
  CHECK(window.bench().run_state() == Workbench::Run::running);
}

TEST_CASE("Cancel ends a training, keeps the dialog and writes nothing") {
  School school;
  Window& window = school.window;
  auto* dialog = school.new_network();
  School::enter(dialog, "training", "samples.txt");
  School::enter(dialog, "threshold", "0");
  School::enter(dialog, "presentations", "2000000000");
  auto* curve = dialog->findChild<LearningCurve*>();
  window.press(dialog, QDialogButtonBox::Ok);
  REQUIRE(wait_for([&] { return curve->points().size() > 2; }));  // it is drawn as it learns
  CHECK(window.bench().engine().waiting_ms() == 0);
  Window::press(dialog, QDialogButtonBox::Cancel);
  CHECK(dialog->isVisible());
  CHECK(dialog->findChild<QLabel*>("training_progress")->text().startsWith("Stopped"));
  Window::press(dialog, QDialogButtonBox::Cancel);
  CHECK(!dialog->isVisible());
  CHECK(school.weight_files().isEmpty());
  CHECK(window.bench().text() == QString(kPupil));
}

TEST_CASE("A training that cannot be is refused in the dialog") {
  School school;
  auto* dialog = school.new_network();
  const auto refused = [&] {
    school.window.press(dialog, QDialogButtonBox::Ok);
    REQUIRE(wait_for([&] { return !refusal(dialog).isEmpty(); }));
    return refusal(dialog);
  };
  CHECK(refused().contains("there is nothing that its network could learn from"));
  school.window.file("1 1 0\n", "short.txt");
  School::enter(dialog, "training", "short.txt");
  CHECK(refused().contains("short.txt"));
  CHECK(school.weight_files().isEmpty());
  CHECK(school.window.bench().text() == QString(kPupil));
}

TEST_CASE("A network on the plateau is said") {
  School school;
  auto* dialog = school.new_network();
  school.window.file("1 1 0 1\n1 1 1 0\n", "same.txt");  // nobody can tell these apart
  School::enter(dialog, "training", "same.txt");
  School::enter(dialog, "presentations", "1000");
  school.window.press(dialog, QDialogButtonBox::Ok);
  REQUIRE(wait_for([&] { return !refusal(dialog).isEmpty(); }));
  CHECK(refusal(dialog).contains("untrained"));
  CHECK(school.window.bench().text() == QString(kPupil));
  REQUIRE(school.weight_files() == QStringList{"r1.weights"});
  SECTION("and is used when OK is pressed again") {
    school.ok(dialog);
    CHECK(school.window.bench().text().contains("weights=\"r1.weights\""));
  }
  SECTION("and its weights go with the dialog") {
    Window::press(dialog, QDialogButtonBox::Cancel);
    REQUIRE(wait_for([&] { return !school.window->findChild<ElementDialog*>(); }));
    CHECK(school.weight_files().isEmpty());
    CHECK(school.window.bench().text() == QString(kPupil));
  }
}

TEST_CASE("A right click on a trained network clears it") {
  School school;
  auto* dialog = school.new_network();
  School::enter(dialog, "training", "samples.txt");
  school.ok(dialog);
  auto* tree = school.window.get<WorldTree>("world_tree");
  const Offered menu = offered_by(
      [&] { school.window->findChild<Authoring*>()->open_menu("robot[r1]/coordinator", {}); });
  CHECK(menu.entries.front() == "Edit...");
  CHECK_FALSE(menu.has_active);  // a destructive action is not one Enter away
  const auto is_picked = pick_when_open("element_menu", "Clear the network");
  school.window.after([&] { click_row(tree, "robot[r1]/coordinator", Qt::RightButton); });
  CHECK(*is_picked);
  CHECK(school.window.bench().undo_name() == "clear the network");
  CHECK(!school.window.bench().text().contains("weights="));
}

TEST_CASE("A training file is browsed for, and named as the world would name it") {
  School school;
  auto* dialog = school.new_network();
  at_dialog("browse_dialog", [&](QDialog* browse) {
    auto* name = browse->findChild<QLineEdit*>("fileNameEdit");
    name->setText(school.samples);
    auto* open = browse->findChild<QDialogButtonBox*>("buttonBox")->button(QDialogButtonBox::Open);
    REQUIRE(wait_for([&] { return open->isEnabled(); }));  // the folder is read
    QTest::mouseClick(open, Qt::LeftButton);
  });
  QTest::mouseClick(dialog->findChild<QToolButton*>("training_browse"), Qt::LeftButton);
  CHECK(dialog->findChild<QLineEdit*>("training")->text() == "samples.txt");
}

TEST_CASE("A network is trained once its world has a file of its own") {
  School school;
  Window& window = school.window;
  const QString recording = window.folder() + "/run.mcap";
  run_elsie({"run", window.bench().file(), "--duration", "1", "--record", recording});
  window.open(recording);
  REQUIRE(wait_for([&] { return window.bench().is_borrowed() && window.bench().is_right(); }));
  click_row(window.get<WorldTree>("world_tree"), "robot[r1]");
  auto* dialog = school.new_network();
  School::enter(dialog, "training", school.samples);
  const auto* box = dialog->findChild<QCheckBox*>("train");
  CHECK_FALSE(box->isEnabled());
  CHECK_FALSE(box->isChecked());
  CHECK(box->toolTip().contains("save it first"));
  SECTION("which may be saved while the dialog is open") {
    REQUIRE(window.saved_as(window.folder() + "/mine.xml").isEmpty());
    CHECK(box->isEnabled());
    CHECK(box->isChecked());
    CHECK(dialog->findChild<QLabel*>("where_weights_go")->isHidden());
    school.ok(dialog);
    CHECK(school.weight_files() == QStringList{"r1.weights"});
  }
  SECTION("and until then OK takes what was entered, untrained") {
    window.press(dialog, QDialogButtonBox::Ok);
    REQUIRE(wait_for([&] { return !window->findChild<ElementDialog*>(); }));
    CHECK(window.bench().text().contains("training=\"" + school.samples + '"'));
    CHECK_FALSE(window.bench().text().contains("weights="));
    CHECK(school.weight_files().isEmpty());
  }
}

TEST_CASE("A learning curve shows an error of 0, which has no logarithm, as 1e-12") {
  const auto picture = [](std::optional<double> last) {
    LearningCurve curve;
    curve.resize(400, 300);
    curve.add(1.0, 100.0, 0.5);
    if (last) curve.add(100.0, 100.0, *last);
    return curve.grab().toImage();
  };
  CHECK(picture(0.0) == picture(1e-12));
  CHECK(picture(0.0) != picture({}));
}
