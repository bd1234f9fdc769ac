// What can be read on small screens, at 200 %, on dark windows and in other languages. These run in
// all of them: see CMakeLists.txt.
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <cmath>

#include <catch2/catch.hpp>

#include "hands.h"
#include "look/language.h"
#include "messages.h"
#include "paint/axes.h"
#include "paint/warning_label.h"
#include "watch/run_card.h"
#include "world/form.h"
#include "world/properties.h"

using namespace elsie::desktop;

namespace {

constexpr QSize kScreen(1280, 720);  // of 2560 x 1440 at 200 %

/// WCAG 2.1, "relative luminance" and "contrast ratio".
double luminance(const QColor& colour) {
  const auto part = [](double value) {
    return value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * part(colour.redF()) + 0.7152 * part(colour.greenF()) +
         0.0722 * part(colour.blueF());
}
double contrast(const QColor& a, const QColor& b) {
  const double first = luminance(a), second = luminance(b);
  return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

/// Labels and buttons whose text has less room than it needs: they are cut off, or behind others.
QStringList cut_off(const QWidget& whole) {
  QStringList texts;
  for (const QWidget* each : whole.findChildren<QWidget*>()) {
    const auto* label = qobject_cast<const QLabel*>(each);
    const auto* button = qobject_cast<const QAbstractButton*>(each);
    if (!each->isVisible() || (!label && !button)) {
      continue;
    }
    const QString text = label ? label->text() : button->text();
    if (label && label->wordWrap()) {
      if (each->height() < each->heightForWidth(each->width())) texts << text;
      continue;
    }
    const int needed = each->fontMetrics().size(Qt::TextShowMnemonic, text).width();
    if (!text.isEmpty() && each->width() + 1 < needed) {
      texts << text;
    }
  }
  return texts;
}

/// The texts that a user reads in a window.
QStringList texts_in(const QWidget& window) {
  QStringList texts{window.windowTitle()};
  for (const QWidget* each : window.findChildren<QWidget*>()) {
    texts << each->windowTitle() << each->toolTip() << each->accessibleName();
    if (const auto* label = qobject_cast<const QLabel*>(each)) texts << label->text();
    if (const auto* button = qobject_cast<const QAbstractButton*>(each)) texts << button->text();
    if (const auto* edit = qobject_cast<const QLineEdit*>(each)) texts << edit->placeholderText();
  }
  for (const QAction* each : window.findChildren<QAction*>()) {
    texts << each->text() << each->toolTip() << each->iconText();
  }
  return texts;
}

}  // namespace

TEST_CASE("Readable: the window fits on a small screen, and no word of a dialog is cut off",
          "[readable]") {
  Room window;
  window->resize(kScreen);
  window.act("layout_author");
  CHECK(window->minimumSizeHint().width() <= kScreen.width());
  CHECK(window->minimumSizeHint().height() <= kScreen.height());
  click_row(window.get<WorldTree>("world_tree"), "robot[r1]");
  for (const char* action :
       {"add_robot", "add_sensor", "coordinator", "behaviors", "physics", "shortcuts"}) {
    INFO(action);
    window.act(action);
    QDialog* dialog = window.any_dialog();
    CHECK(dialog->width() <= kScreen.width());
    CHECK(dialog->height() <= kScreen.height());
    CHECK(cut_off(*dialog).join(" | ").toStdString().empty());
    dialog->reject();
    REQUIRE(wait_for([&] { return window->findChildren<QDialog*>().isEmpty(); }));
  }
}

TEST_CASE("Readable: no word of a card over the view is cut off", "[readable]") {
  Room window(QString(kRoom).replace("\"60\"", "\"1\""));
  window->resize(kScreen);
  auto* notice = window.get<StuckNotice>("stuck_notice");
  const auto stuck = [](const char* why) {
    return Json{{"time_s", 12.0},
                {"stuck",
                 {{{"robot", "r1"},
                   {"why", why},
                   {"since_s", 1.0},
                   {"behaviors", {"avoid_obstacle", "find_resource"}}}}}};
  };
  for (const char* why : {"cancel", "empty", "cancel"}) {
    notice->take(stuck(why));
    QApplication::processEvents();  // the layout
    CHECK(cut_off(*notice).join(" | ").toStdString().empty());
  }
  window.run_to_the_end();
  auto* card = window.get<RunCard>("run_card");
  REQUIRE(wait_for([&] { return card->isVisible(); }));
  QApplication::processEvents();
  CHECK(cut_off(*card).join(" | ").toStdString().empty());
}

TEST_CASE("Readable: the list of keys fits on a small screen", "[readable]") {
  Room window;
  QSize size;
  auto* waiting = new QTimer(qApp);
  QObject::connect(waiting, &QTimer::timeout, waiting, [&] {
    if (auto* box = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
      waiting->deleteLater();
      size = box->size();
      box->reject();
    }
  });
  waiting->start(20);
  window.act("keys");
  CHECK(size.height() <= kScreen.height() - 40);  // the frame
}

TEST_CASE("Readable: a box that is not checked is seen", "[readable]") {
  QCheckBox box;
  box.resize(box.sizeHint());
  const QImage picture = box.grab().toImage();
  double most = 0.0;
  for (int x = 0; x < picture.width(); ++x) {
    for (int y = 0; y < picture.height(); ++y) {
      most =
          std::max(most, contrast(picture.pixelColor(x, y), box.palette().color(QPalette::Window)));
    }
  }
  CHECK(most >= 3.0);
}

TEST_CASE("Readable: words, warnings and curves stand out from what is behind them", "[readable]") {
  Window window;
  window->resize(kScreen);
  window.open(window.file(kRoom));
  const QPalette palette = window->palette();
  const QColor behind = palette.color(QPalette::Window);
  CHECK(contrast(palette.color(QPalette::WindowText), behind) >= 4.5);
  CHECK(contrast(palette.color(QPalette::Text), palette.color(QPalette::Base)) >= 4.5);
  for (int i = 0; i < 7; ++i) {
    CHECK(contrast(curve_colour(i, palette), palette.color(QPalette::Base)) >= 3.0);
  }
  click_row(window.get<WorldTree>("world_tree"), "robot[r1]");
  auto& form = window.get<Properties>("properties")->form();
  QWidget* x = form.editor("x");
  click_on(x);
  press_key(x, Qt::Key_A, Qt::ControlModifier);
  type_text(x, "1,5");
  press_key(x, Qt::Key_Return);
  auto* problem = form.findChild<WarningLabel*>("x_problem");
  REQUIRE(problem->isVisible());
  CHECK(contrast(problem->palette().color(problem->foregroundRole()), behind) >= 4.5);
}

TEST_CASE("Readable: a window in German has no English text", "[readable]") {
  if (language() != "de") {
    return;
  }
  QHash<QString, QString> german;
  for (const Message& each :
       messages_of(ELSIE_SOURCE_DIR "/apps/desktop/translations/elsie_de.ts")) {
    german[each.source] = each.translations.front();
  }
  const auto english_in = [&](const QWidget& window) {
    QStringList found;
    for (const QString& text : texts_in(window)) {
      if (german.contains(text) && german[text] != text) found << text;
    }
    return found.join(" | ").toStdString();
  };
  Room window;
  click_row(window.get<WorldTree>("world_tree"), "robot[r1]");
  CHECK(english_in(window.window()).empty());
  for (const char* action :
       {"add_robot", "add_sensor", "coordinator", "behaviors", "physics", "shortcuts"}) {
    INFO(action);
    window.act(action);
    QDialog* dialog = window.any_dialog();
    CHECK(english_in(*dialog).empty());
    const auto* buttons = dialog->findChild<QDialogButtonBox*>("buttons");
    REQUIRE(buttons);
    CHECK(buttons->button(QDialogButtonBox::Cancel)->text().remove('&') == "Abbrechen");
    dialog->reject();
    REQUIRE(wait_for([&] { return window->findChildren<QDialog*>().isEmpty(); }));
  }
}

TEST_CASE("Readable: numbers have a point in every language", "[readable]") {
  Window window;
  window->resize(kScreen);
  window.open(window.file(kRoom));
  click_row(window.get<WorldTree>("world_tree"), "robot[r1]");
  QWidget* x = window.get<Properties>("properties")->form().editor("x");
  click_on(x);
  press_key(x, Qt::Key_A, Qt::ControlModifier);
  type_text(x, "1.5");
  window.after([&] { press_key(x, Qt::Key_Return); });
  CHECK(window.bench().text().contains("x=\"1.5\""));
  QDialog* dialog = window.dialog_of("add_sensor");
  auto* spread = dialog->findChild<QDoubleSpinBox*>("spread_deg");
  REQUIRE(spread);
  CHECK(spread->cleanText() == "120.0");
  Window::press(dialog, QDialogButtonBox::Cancel);
  CHECK(wait_for([&] { return window.get<QLabel>("time_s")->text() == "0.00 s"; }));
}
