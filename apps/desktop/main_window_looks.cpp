#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QFileInfo>
#include <QLayout>
#include <QMenu>
#include <QRegularExpression>
#include <QSettings>
#include <QToolBar>
#include <QToolButton>

#include "authoring/authoring.h"
#include "command_palette.h"
#include "control_bar.h"
#include "look/icons.h"
#include "look/language.h"
#include "look/theme.h"
#include "main_window.h"
#include "scene/scene_view.h"
#include "shortcuts.h"

// The bars, the theme, the language and the palette of commands.

namespace elsie::desktop {

// The tool bars

void MainWindow::fill_tool_bars() {
  tools_->addActions({actions_.new_world, actions_.open, actions_.save});
  tools_->addSeparator();
  tools_->addActions({actions_.undo, actions_.redo});
  tools_->addSeparator();
  control_bar_ = new ControlBar(workbench_);
  connect(control_bar_, &ControlBar::run_wished, this, &MainWindow::run_or_pause);
  connect(control_bar_, &ControlBar::seed_wished, this, &MainWindow::begin_anew);
  tools_->addWidget(control_bar_);

  environment_->addActions(
      {actions_.add_robot, actions_.add_sensor, actions_.behaviors, actions_.coordinator});
  environment_->addSeparator();
  boxes_ = new QToolButton;
  boxes_->setObjectName("boxes");
  boxes_->setText(tr("Box"));
  boxes_->setIcon(icon("box"));
  boxes_->setToolTip(tr("Add a static, dynamic or moving box, or another obstacle"));
  boxes_->setPopupMode(QToolButton::InstantPopup);
  boxes_->addActions(actions_.obstacles);
  environment_->addWidget(boxes_);
  environment_->addActions({actions_.add_resource, actions_.add_charger});
  environment_->addSeparator();
  environment_->addAction(actions_.measure);
  connect(environment_, &QToolBar::toolButtonStyleChanged, boxes_,
          &QToolButton::setToolButtonStyle);
  tools_->setToolButtonStyle(Qt::ToolButtonIconOnly);
  connect(environment_, &QToolBar::topLevelChanged, this, &MainWindow::fit_tool_bars);
}

void MainWindow::fit_tool_bars() {
  if (worded_px_ == 0) {
    environment_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    for (QAction* each : environment_->actions()) {
      environment_->widgetForAction(each)->ensurePolished();
    }
    environment_->layout()->invalidate();
    worded_px_ = environment_->sizeHint().width();
  }
  const bool is_below = toolBarBreak(environment_) || environment_->isFloating() ||
                        toolBarArea(environment_) != toolBarArea(tools_);
  const int others = is_below ? 0 : tools_->sizeHint().width();
  const int room = width() - others - 2 * fontMetrics().height();  // for the handles
  environment_->setToolButtonStyle(worded_px_ <= room ? Qt::ToolButtonTextBesideIcon
                                                      : Qt::ToolButtonIconOnly);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  fit_tool_bars();
}

// Theme and language

void MainWindow::fill_looks_menus(QMenu* menu) {
  const auto choice = [this](QMenu* in, QActionGroup* among, const QString& name,
                             const QString& text, bool is_chosen, std::function<void()> does) {
    QAction* made = command(in, nullptr, name.toLatin1().constData(), text, {}, std::move(does));
    made->setCheckable(true);
    made->setChecked(is_chosen);
    among->addAction(made);
    return made;
  };
  QMenu* themes = menu->addMenu(tr("Theme"));
  auto* theme_group = new QActionGroup(this);
  for (const auto& [name, text] : {std::pair(QString("system"), tr("Theme: as the s&ystem")),
                                   {QString("light"), tr("Theme: &light")},
                                   {QString("dark"), tr("Theme: &dark")}}) {
    choice(themes, theme_group, "theme_" + name, text, theme() == name,
           [name = name] { choose_theme(name); });
  }
  QMenu* tongues = menu->addMenu(tr("Language"));
  auto* language_group = new QActionGroup(this);
  const auto tongue = [&](const QString& code, const QString& text) {
    return choice(tongues, language_group, "language_" + code, text, language() == code,
                  [this, code] {
                    choose_language(code);
                    say(tr("The next window that you open has this language."));
                  });
  };
  tongue("system", tr("Language: as the s&ystem"));
  const QString of = tr("Language: %1");
  for (const QString& code : languages()) {
    const QStringList names = names_of_language(code);
    tongue(code, of.arg(names[0]))
        ->setData(QStringList{of.arg(names[1]), english_of(of).arg(names[2])});
  }
}

// The palette of commands

void MainWindow::ask_for_command() {
  std::vector<Offer> offers;
  for (QAction* each : std::as_const(commands_)) {
    if (each->isEnabled()) {
      QStringList also{english_of(each->text()), english_of(each->iconText())};
      for (QString& name : also) name.remove('&');
      offers.push_back({title_of(*each), each->shortcut().toString(QKeySequence::NativeText),
                        each->icon(), [each] { each->trigger(); },
                        also + each->data().toStringList()});
    }
  }
  const QString show = tr("Show the window %1"), go = tr("Go to %1 (%2)"), read = tr("Open %1");
  for (QDockWidget* each : docks()) {
    const QString title = each->windowTitle();
    offers.push_back({show.arg(title),
                      {},
                      icon("window"),
                      [each] {
                        each->show();
                        each->raise();
                      },
                      {english_of(show).arg(english_of(title))}});
  }
  visit(workbench_.tree(), [&](const ElementPlace& place) {
    const QString name = name_of(*place.element);
    if (place.list.isEmpty() && !place.path.isEmpty() &&
        !attribute(*place.element, "id").isEmpty()) {
      const QString title = title_of(*place.element);
      offers.push_back({go.arg(title, name),
                        {},
                        icon(name),
                        [this, path = place.path] {
                          authoring_->select({path});
                          scene_->frame_selection();
                        },
                        {english_of(go).arg(title, name)}});
    }
    return name != "robot";
  });
  for (const QString& file : QSettings().value("recent").toStringList()) {
    const QString name = QFileInfo(file).fileName();
    offers.push_back({read.arg(name),
                      {},
                      icon("recent"),
                      [this, file] { open(file); },
                      {english_of(read).arg(name)}});
  }
  const auto typed_offers = [this](const QString& typed) { return typed_commands(typed); };
  CommandPalette(std::move(offers), typed_offers, this).exec();
}

/// "speed 2", "seed 7", "time 12.5": what a number at the end may mean.
std::vector<Offer> MainWindow::typed_commands(const QString& typed) {
  static const QRegularExpression number_at_end("^(.*\\S)\\s+([0-9]+(\\.[0-9]+)?)$");
  const auto match = number_at_end.match(typed);
  std::vector<Offer> offers;
  if (!match.hasMatch() || !workbench_.tree().is_object()) {
    return offers;
  }
  const QString words = match.captured(1);
  const QString number = match.captured(2);
  const auto offer = [&](const QString& what, const QString& title, std::function<void()> does) {
    if (fit(words, what) || fit(words, english_of(what))) {
      offers.push_back({title.arg(number), {}, {}, std::move(does)});
    }
  };
  const double value = number.toDouble();
  if (value > 0.0) {
    offer(tr("set the speed"), tr("Set the speed to %1"),
          [this, value] { workbench_.set_speed(value); });
  }
  if (bool is_whole = false; number.toULongLong(&is_whole), is_whole) {
    offer(tr("set the seed"), tr("Set the seed to %1"),
          [this, seed = number.toULongLong()] { begin_anew(seed); });
  }
  offer(tr("go to the time"), tr("Go to the time %1 s"),
        [this, value] { time_line_->go_to(value); });
  return offers;
}

}  // namespace elsie::desktop
