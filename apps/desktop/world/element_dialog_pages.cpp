// The pages of the dialog that only some elements have: a first waypoint, headings, drives, and
// training.
#include <QComboBox>
#include <QDialogButtonBox>
#include <QListWidget>
#include <QPushButton>
#include <QRandomGenerator>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/workbench.h"
#include "paint/boxes.h"
#include "paint/warning_label.h"
#include "training/training_page.h"
#include "world/element_dialog.h"
#include "world/fan.h"
#include "world/form.h"

namespace elsie::desktop {
namespace {

constexpr int kMostRandomHeading_deg = 90;  // the limit that the original uses for a new sensor
constexpr const char* kCorners = "6";       // of a new prism
constexpr const char* kOutline_m = "0.2";
constexpr int kFirstFan = 5;  // number of range sensors offered for a robot without any

QString default_of(const Kind& kind, const QString& name) {
  const auto field = std::find_if(kind.fields.begin(), kind.fields.end(),
                                  [&name](const Field& each) { return each.name == name; });
  return field == kind.fields.end() ? QString() : field->default_text;
}

}  // namespace

// A moving box needs a place to go to: the middle, or a point near the middle.
void ElementDialog::add_waypoint(const Kind& kind) {
  const auto waypoint = workbench_.catalog().element("waypoint");
  if (waypoint && kind.elements.contains("waypoint")) {
    const auto& given = pages_.front().form->values();
    const bool is_aside = given.contains("x") || given.contains("y");
    add_page("waypoint", "waypoint", *waypoint, {{"x", is_aside ? "0" : "0.5"}, {"y", "0"}});
  }
}

// A group of goals begins with one, to which others can be pasted.
void ElementDialog::add_first_goal(const Kind& kind) {
  const QString first = "endure";
  const auto goal = workbench_.catalog().element(first);
  if (goal && kind.elements.contains(first))
    add_page(tr("goal in it"), first, *goal, Json::object());
}

// A prism begins as a regular polygon, whose points can be moved later.
void ElementDialog::add_outline(const Kind& kind) {
  if (!kind.elements.contains("point")) {
    return;
  }
  Kind outline;
  outline.name = "outline";
  Field corners;
  corners.name = "corners";
  corners.type = "integer";
  corners.default_text = kCorners;
  corners.meaning = tr("of a regular polygon, whose points can be moved later");
  corners.range = tr("at least 3 and at most 16");
  corners.least = 3;
  corners.most = 16;
  Field radius;
  radius.name = "radius";
  radius.type = "number";
  radius.unit = "m";
  radius.default_text = kOutline_m;
  radius.meaning = tr("of the circle through its corners");
  radius.least = 0.001;
  radius.most = 1000.0;
  outline.fields = {corners, radius};
  add_page(tr("outline"), "outline", outline, Json::object());
}

QString ElementDialog::points(const std::map<QString, QString>& given) {
  const auto value = [&](const char* name, const char* otherwise) {
    const auto found = given.find(name);
    return found == given.end() ? QString(otherwise) : found->second;
  };
  const int corners = std::clamp(value("corners", kCorners).toInt(), 3, 16);
  const double radius = value("radius", kOutline_m).toDouble();
  QString text;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    text += QString("<point x=\"%1\" y=\"%2\"/>")
                .arg(radius * std::cos(angle), 0, 'f', 4)
                .arg(radius * std::sin(angle), 0, 'f', 4);
  }
  return text;
}

// The original gives a new beam or proximity sensor a heading drawn from 0 to 90 degrees. A robot
// without distance sensors is offered several sensors: with one of them, it sees no walls at its
// sides.
void ElementDialog::offer_headings(const Kind& kind) {
  Form* form = pages_.front().form;
  if (!form->editor("yaw_deg")) {
    return;
  }
  auto* button = new QPushButton(tr("&Random heading"), tabs_->widget(0));
  button->setObjectName("random_heading");
  button->setToolTip(tr("Draws the heading from 0 to %1 degrees").arg(kMostRandomHeading_deg));
  connect(button, &QPushButton::clicked, form, [form] {
    form->set_value(
        "yaw_deg",
        QString::number(QRandomGenerator::global()->bounded(kMostRandomHeading_deg + 1)));
  });
  tabs_->widget(0)->layout()->addWidget(button);
  const std::vector<ElementPlace> sensors = members_of(workbench_.tree(), holder_, "sensors");
  const bool has_some = !kind.produces.contains("range") ||
                        std::any_of(sensors.begin(), sensors.end(), [&](const ElementPlace& each) {
                          const auto other = workbench_.catalog().kind_of(each);
                          return other && other->produces.contains("range");
                        });
  fan_ = new Fan(has_some ? 1 : kFirstFan);
  tabs_->widget(0)->layout()->addWidget(fan_);
  connect(form, &Form::committed, fan_, [fan = fan_](const QString& name) {
    if (name == "id" || name == "yaw_deg") fan->become_one();
  });
}

void ElementDialog::offer_drives(const QString& chosen) {
  const std::vector<Kind> drives = workbench_.catalog().plugins("drive");
  if (drives.empty()) {
    return;
  }
  add_page("drive", "drive", drives.front(), Json::object());
  const std::size_t place = pages_.size() - 1;
  auto* choice = new QComboBox;
  choice->setObjectName("drive");
  choice->setAccessibleName(tr("Drive"));
  quiet_wheel(choice);
  for (const Kind& drive : drives) {
    choice->addItem(drive.name);
    choice->setItemData(choice->count() - 1, drive.description, Qt::ToolTipRole);
  }
  connect(choice, &QComboBox::currentIndexChanged, this, [this, drives, place](int index) {
    pages_[place].kind = drives[static_cast<std::size_t>(index)];
    pages_[place].form->show_fields(pages_[place].kind.fields, Json::object());
  });
  QWidget* page = pages_[place].form->parentWidget();
  qobject_cast<QVBoxLayout*>(page->layout())->insertWidget(0, choice);
  choice->setCurrentText(chosen);
}

// A coordinator that learns has a page for that, and OK trains it first.
void ElementDialog::offer_training(const Kind& kind, Form* form, const QString& coordinator) {
  training_ = new TrainingPage(workbench_, kind, coordinator);
  tabs_->addTab(training_, tr("Training"));
  const auto value = [form](const QString& name) {
    const auto given = form->values().find(name);
    return given == form->values().end() ? QString() : given->second;
  };
  const auto show = [this, value](const QString& changed) {
    training_->show_hidden(value("hidden"));
    if (changed == "weights") {
      training_->wish(value("weights").isEmpty());
    } else if (changed != "id" && changed != "weighted") {
      training_->wish(true);
    }
  };
  training_->show_hidden(value("hidden"));
  training_->wish(value("weights").isEmpty());
  connect(form, &Form::committed, training_, show);
  connect(form, &Form::taken_back, training_, show);
  connect(training_, &TrainingPage::hidden_wished, form,
          [form](const QString& hidden) { form->set_value("hidden", hidden); });
  connect(training_, &TrainingPage::failed, this, [this](const QString& sentence) {
    set_busy(false);
    refusal_->say(sentence);
  });
  connect(training_, &TrainingPage::trained, this,
          [this, value, kind](const QString& warning, bool has_reached_goal) {
            set_busy(false);
            const QString goal = value("threshold");
            shortcoming_ = warning;
            if (!has_reached_goal) {
              training_->say_more(tr("The training has used up its presentations without reaching "
                                     "its goal, a mean error below %1.")
                                      .arg(goal.isEmpty() ? default_of(kind, "threshold") : goal));
            }
            if (warning.isEmpty()) {
              accept();
            } else {
              refusal_->say(tr("%1 OK uses it anyway.").arg(warning));
            }
          });
}

// True while the network must be trained before this dialog can close.
bool ElementDialog::trains_first() {
  if (!training_ || !training_->is_wished()) {
    return false;
  }
  Form* form = pages_.front().form;
  const auto seed = form->values().find("seed");
  const bool has_seed = seed != form->values().end() && seed->second.toLongLong() >= 0;
  const QStringList before = edits();
  if (!training_->has_trained(before, has_seed)) {
    refusal_->say({});
    tabs_->setCurrentWidget(training_);
    set_busy(true);
    training_->train(before, has_seed);
    return true;
  }
  const QSignalBlocker blocker(form);
  form->set_value("weights", training_->weights());
  if (!makes_) {
    changes_[path_]["weights"] = training_->weights();
  }
  return false;
}

// The dialog stays open to show the curve; only the user closes it.
void ElementDialog::show_learned() {
  has_learned_ = true;
  training_->keep_weights();
  set_busy(true);
  at_once_->hide();
  buttons_->setStandardButtons(QDialogButtonBox::Close);
  buttons_->button(QDialogButtonBox::Close)->setDefault(true);
  buttons_->button(QDialogButtonBox::Close)->setFocus();
  refusal_->say(shortcoming_);
}

void ElementDialog::set_busy(bool is_busy) {
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(!is_busy);
  for (int i = 0; i < tabs_->count(); ++i) {
    if (tabs_->widget(i) != training_) {
      tabs_->widget(i)->setEnabled(!is_busy);
    }
  }
  choice_->setEnabled(!is_busy);
}

}  // namespace elsie::desktop
