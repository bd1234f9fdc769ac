// Dialogs and forms of robots, sensors, behaviours and coordinators, and of plugins that change.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTreeWidget>

#include <catch2/catch.hpp>

#include "hands.h"
#include "window.h"
#include "world/form.h"
#include "world/properties.h"
#include "world/words.h"

using namespace elsie::desktop;

TEST_CASE("A robot's dialog has the defaults, a drive, and the leader flag; a run takes changes") {
  Room window;
  QDialog* dialog = window.dialog_of("add_robot");
  auto* form = dialog->findChild<Form*>("form_robot");
  REQUIRE(form);
  for (const char* name : {"max_speed", "coverage", "leader", "x", "y", "heading_deg"}) {
    INFO(name);
    REQUIRE(form->editor(name));
  }
  const auto* fastest = qobject_cast<QLineEdit*>(form->editor("max_speed"));
  REQUIRE(fastest);
  CHECK(fastest->placeholderText().contains("0.5"));
  CHECK(dialog->findChild<QComboBox*>("drive")->count() >= 10);
  Window::press(dialog, QDialogButtonBox::Cancel);

  window.bench().run();
  REQUIRE(wait_for([&] { return window.bench().time_s() > 0.1; }));
  window.bench().set_speed(0.1);  // it must not end before the change
  click_row(window.get<WorldTree>("world_tree"), "robot[r1]", Qt::RightButton);
  dialog = window.dialog("element_dialog");
  QTest::mouseClick(dialog->findChild<QAbstractButton*>("apply_immediately"), Qt::LeftButton, {},
                    QPoint(8, 8));
  window.after([&] { dialog->findChild<Form*>("form_robot")->set_value("leader", "true"); });
  CHECK(window.bench().text().contains("leader=\"true\""));
  CHECK(window.bench().run_state() == Workbench::Run::running);
  Window::press(dialog, QDialogButtonBox::Cancel);
}

TEST_CASE("A new beam or proximity sensor is offered a random heading from 0 to 90 degrees") {
  Room window;
  window.choose("robot[r1]");
  QDialog* dialog = window.dialog_of("add_sensor");
  auto* kinds = dialog->findChild<QListWidget*>("kinds");
  for (const char* kind : {"beam_range", "proximity"}) {
    INFO(kind);
    kinds->setCurrentItem(kinds->findItems(kind, Qt::MatchExactly).front());
    auto* button = dialog->findChild<QPushButton*>("random_heading");
    auto* form = dialog->findChild<Form*>(QString("form_") + kind);
    REQUIRE((button && form));
    QSet<QString> headings;
    for (int i = 0; i < 5; ++i) {
      QTest::mouseClick(button, Qt::LeftButton);
      const QString heading = form->values().at("yaw_deg");
      CHECK(heading.toDouble() >= 0.0);
      CHECK(heading.toDouble() <= 90.0);
      headings << heading;
    }
    CHECK(headings.size() > 1);
  }
  Window::press(dialog, QDialogButtonBox::Cancel);
}

TEST_CASE("No two rows of a form have the same name") {
  Window window;
  const Catalog& catalog = window.bench().catalog();
  std::size_t forms = 0;
  const auto check = [&](const Kind& kind) {
    Form form;
    form.show_fields(kind.fields, Json::object());
    QStringList labels, names;
    for (const QLabel* each : form.findChildren<QLabel*>()) {
      if (each->buddy()) labels << each->text();
    }
    for (const Field& field : kind.fields) names << form.editor(field.name)->accessibleName();
    INFO(kind.name.toStdString() << ": " << labels.join(", ").toStdString());
    CHECK(labels.removeDuplicates() == 0);
    CHECK(names.removeDuplicates() == 0);
    CHECK(labels.size() == static_cast<qsizetype>(kind.fields.size()));
    ++forms;
  };
  for (const auto& [name, element] : catalog.json()["elements"].items()) {
    check(*catalog.element(QString::fromStdString(name)));
  }
  QSet<QString> checked;  // elements in elements of a plugin
  const std::function<void(const QStringList&)> check_inside = [&](const QStringList& path) {
    const auto kind = catalog.kind_of(path);
    REQUIRE(kind);
    check(*kind);
    for (const QString& inner : kind->elements) {
      const QString where = path[1] + '/' + inner;
      if (checked.contains(where)) continue;
      checked.insert(where);
      check_inside(path + QStringList{inner});
    }
  };
  for (const auto& [list, kind] : {std::pair("sensors", "sensor"),
                                   {"behaviors", "behavior"},
                                   {"actuators", "actuator"},
                                   {"measures", "measure"},
                                   {"rules", "rule"},
                                   {"coordinator", "coordinator"},
                                   {"drive", "drive"},
                                   {"localisation", "localisation"}}) {
    for (const Kind& plugin : catalog.plugins(kind)) check_inside({list, plugin.name});
  }
  CHECK(forms > 200);

  const auto beam = catalog.kind_of(QStringList{"sensors", "beam_range"});
  REQUIRE(beam);
  Form form;
  form.show_fields(beam->fields, Json::object());
  CHECK(form.editor("error")->accessibleName() == "Error without unit");
  CHECK(form.editor("error_m")->accessibleName() == "Error, m");
}

TEST_CASE("No behaviour is carried twice: what is carried is not in the pool, and >> takes one") {
  Room window;
  window.choose("robot[r1]");
  window.act("behaviors");
  QDialog* dialog = window.dialog("behaviors_dialog");
  auto* pool = dialog->findChild<QListWidget*>("pool");
  auto* carried = dialog->findChild<QListWidget*>("carried");
  CHECK(carried->count() == 1);
  CHECK(pool->findItems("wander", Qt::MatchExactly).isEmpty());
  const int before = pool->count();
  pool->setCurrentRow(0);
  QTest::mouseClick(dialog->findChild<QPushButton*>("add"), Qt::LeftButton);
  CHECK(pool->count() == before - 1);
  CHECK(carried->count() == 2);
  Window::press(dialog, QDialogButtonBox::Cancel);
  CHECK(window.bench().text() == kRoom);
}

TEST_CASE("The priority of a behaviour is set") {
  Room window;
  window.choose("robot[r1]/behavior[wander]");
  auto* priority =
      qobject_cast<QLineEdit*>(window.get<Properties>("properties")->form().editor("priority"));
  REQUIRE(priority);
  priority->setFocus();
  window.after([&] { enter(priority, "7"); });
  CHECK(window.bench().text().contains("priority=\"7\""));
}

TEST_CASE("All coordinators that are found are offered") {
  Room window;
  window.choose("robot[r1]");
  QDialog* dialog = window.dialog_of("coordinator");
  auto* kinds = dialog->findChild<QListWidget*>("kinds");
  REQUIRE(kinds);
  CHECK(kinds->count() == static_cast<int>(window.bench().catalog().plugins("coordinator").size()));
  CHECK(kinds->count() >= 10);
  Window::press(dialog, QDialogButtonBox::Cancel);
}

TEST_CASE("Fields with units of any width end below each other, and not at their units") {
  Room window;
  window.choose("robot[r1]");
  const QWidget* x = field(window, "x");              // m
  const QWidget* speed = field(window, "max_speed");  // m/s
  REQUIRE(wait_for([&] { return speed->isVisible() && speed->width() > 0; }));
  CHECK(x->geometry().right() == speed->geometry().right());
  for (const QLabel* unit : x->parentWidget()->findChildren<QLabel*>()) {
    if (unit->text() == "m") CHECK(unit->geometry().left() > x->geometry().right() + 1);
  }
}

TEST_CASE("Every field says what it means; every number, its unit if it has one") {
  Window window;
  int units = 0;
  for (const char* kind : {"sensor", "behavior", "coordinator", "drive", "measure"}) {
    for (const Kind& plugin : window.bench().catalog().plugins(kind)) {
      INFO(plugin.name.toStdString());
      Form form;
      form.show_fields(plugin.fields, Json::object());
      for (const Field& field : plugin.fields) {
        INFO(field.name.toStdString());
        QWidget* editor = form.editor(field.name);
        REQUIRE(editor);
        CHECK_FALSE(field.meaning.isEmpty());
        CHECK(editor->toolTip().contains(field.meaning.toHtmlEscaped()));
        CHECK(editor->accessibleDescription() == field.meaning);
        if (!field.unit.isEmpty()) {
          ++units;
          CHECK(editor->toolTip().contains('(' + field.unit.toHtmlEscaped() + ')'));
          CHECK(editor->accessibleName() == in_words(field.name, field.unit) + ", " + field.unit);
          QStringList shown;
          for (QLabel* label : editor->parentWidget()->findChildren<QLabel*>()) {
            shown << label->text();
          }
          CHECK(shown.contains(unit_in_words(field.unit)));
        }
      }
    }
  }
  CHECK(units > 30);
}

TEST_CASE("A plugin that changes while the window is open has its new form, without a restart") {
  QTemporaryDir folder;
  const QString source = folder.filePath("veer.cpp");
  const auto write = [&](const char* parameters) {
    std::ofstream(source.toStdString()) << R"(#include <elsie/api/behavior.h>
namespace {
class Veer final : public elsie::Behavior {
 public:
  double rate = 3.0;
  double boldness = 1.0;
  elsie::Response respond(const elsie::Perception& now) override {
    return now.self().wheels.motion({rate, boldness * rate});
  }
};
}  // namespace
ELSIE_BEHAVIOR(Veer, "veer", "Veers",
    elsie::parameter("rate", &Veer::rate, {.unit = "rad/s", .meaning = "rate of the left wheel"}))"
                                        << parameters << ");\n";
  };
  write("");
  Window window({}, {"--plugin", source});
  window.open(window.file(kRoom));
  window.after([&] { window.bench().edit({"robot[r1]/behavior[+]=<veer/>"}, "add veer"); });
  window.choose("robot[r1]/behavior[veer]");
  auto& form = window.get<Properties>("properties")->form();
  REQUIRE(form.editor("rate"));
  CHECK_FALSE(form.editor("boldness"));
  write(", elsie::parameter(\"boldness\", &Veer::boldness, {.meaning = \"right over left\"})");
  REQUIRE(wait_for([&] { return form.editor("boldness") != nullptr; }));
  CHECK(form.editor("boldness")->toolTip().contains("right over left"));
}

TEST_CASE("A plugin that is dropped into the path while the window is open is offered") {
  QTemporaryDir folder;
  Window window({}, {"--plugin-path", folder.path()});
  window.open(window.file(kRoom));
  const auto has = [&](const char* name) {
    for (const Kind& kind : window.bench().catalog().plugins("coordinator")) {
      if (kind.name == name) return true;
    }
    return false;
  };
  CHECK_FALSE(has("body_learner"));
  REQUIRE(QFile::copy(build_file("../tests/program/plugins/body_learner.so"),
                      folder.filePath("body_learner.so")));
  CHECK(wait_for([&] { return has("body_learner"); }));
}

TEST_CASE("The weight that a coordinator gives a behaviour now is shown beside its priority") {
  Window window(world_file("learned_priorities"));
  auto* tree = window.get<WorldTree>("world_tree");
  QString behavior;
  visit(window.bench().tree(), [&](const ElementPlace& place) {
    if (behavior.isEmpty() && place.path.contains("/behavior[")) behavior = place.path;
    return behavior.isEmpty();
  });
  tree->tree()->setCurrentItem(tree->item(behavior));
  window.bench().run();
  auto* live = window.get<Properties>("properties")->form().findChild<QLabel*>("priority_live");
  REQUIRE(live);
  CHECK(wait_for([&] { return live->text().contains(" s: weight "); }));
  CHECK(wait_for([&] { return tree->note_of(behavior).startsWith("weight "); }));
}
