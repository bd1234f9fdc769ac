#include "world/properties.h"

#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <cmath>

#include "engine/workbench.h"
#include "world/form.h"
#include "world/words.h"

namespace elsie::desktop {
namespace {

constexpr int kPose_ms = 100;  // between two poses, because each change lays out the form again

}  // namespace

std::optional<Described> described_at(const Workbench& workbench, const QString& path) {
  const ElementPlace place = place_of(workbench.tree(), path);
  if (place.element) {
    if (auto kind = workbench.catalog().kind_of(place)) {
      Json values = attributes_of(*place.element);
      if (member(*place.element, "named") == true) {  // the reader named it, not the text
        for (Field& field : kind->fields) {
          if (field.name == "id") field.default_text = attribute(*place.element, "id");
        }
        values.erase("id");
      }
      return Described{title_of(*place.element), std::move(*kind), std::move(values)};
    }
    return std::nullopt;
  }
  const QString name = path.section('/', -1);
  const QString holder = holder_of(path);
  const bool is_there = holder.isEmpty() || place_of(workbench.tree(), holder).element;
  if (!name.contains('[') && is_there && workbench.tree().is_object()) {
    if (auto kind = workbench.catalog().element(name)) {
      return Described{name, std::move(*kind), Json::object()};
    }
  }
  return std::nullopt;
}

Properties::Properties(Workbench& workbench, QWidget* parent)
    : QWidget(parent), workbench_(workbench) {
  setObjectName("properties");
  auto* column = new QVBoxLayout(this);
  title_ = new QLabel;
  title_->setObjectName("title");
  QFont font = title_->font();
  font.setBold(true);
  title_->setFont(font);
  column->addWidget(title_);
  about_ = new QLabel;
  about_->setWordWrap(true);
  column->addWidget(about_);
  filter_ = new QLineEdit;
  filter_->setPlaceholderText(tr("Filter"));
  filter_->setAccessibleName(tr("Filter of the properties"));
  filter_->setClearButtonEnabled(true);
  column->addWidget(filter_);
  setFocusProxy(filter_);
  add_ = new QPushButton;
  add_->setObjectName("add_to_list");
  add_->hide();
  connect(add_, &QPushButton::clicked, this, [this] { Q_EMIT add_wished(path_, list_); });
  column->addWidget(add_, 0, Qt::AlignLeft);
  form_ = new Form;
  form_->setObjectName("form");
  scroll_ = new QScrollArea;
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setWidget(form_);
  column->addWidget(scroll_, 1);
  pose_timer_.setSingleShot(true);
  connect(&pose_timer_, &QTimer::timeout, this, &Properties::show_last_pose);
  connect(filter_, &QLineEdit::textChanged, form_, &Form::filter);
  connect(&workbench_, &Workbench::described, this, &Properties::refresh);
  connect(&workbench_, &Workbench::catalog_changed, this, &Properties::refresh);
  connect(&workbench_, &Workbench::run_changed, this, [this] {
    if (workbench_.run_state() == Workbench::Run::none ||
        workbench_.run_state() == Workbench::Run::ready) {
      form_->clear_live();  // of the run before
    }
  });
  // The change is made to the object for which it was typed, whatever is selected by then.
  connect(form_, &Form::committed, this, [this](const QString& name, const QString& value) {
    change(path_, name, attribute_path(path_, name) + '=' + value);
  });
  connect(form_, &Form::taken_back, this, [this](const QString& name) {
    change(path_, name, attribute_path(path_, name) + "/@remove=true");
  });
  connect(form_, &Form::typed, this, [this] {
    std::vector<Typed> typed;
    for (const auto& [name, text] : form_->unfinished()) {
      typed.push_back({attribute_path(path_, name), text});
    }
    workbench_.keep_typed(form_, std::move(typed));
  });
  refresh();
}

void Properties::change(const QString& path, const QString& name, const QString& edit) {
  workbench_.edit({edit}, tr("set %1 of %2").arg(name, title_at(workbench_.tree(), path)),
                  attribute_path(path, name), this, [this, path, name](const Problems& problems) {
                    if (path == path_) {
                      form_->show_problem(name,
                                          problems.empty() ? QString() : problems.front().message);
                    }
                  });
}

void Properties::show_element(const QString& path) {
  if (path != path_ || !list_.isEmpty()) {
    form_->finish();  // for the object for which it was typed
    form_->drop_typed();
    path_ = path;
    list_.clear();
    pose_timer_.stop();
    refresh();
  }
}

void Properties::show_list(const QString& holder, const QString& list) {
  show_element(holder);
  list_ = list;
  refresh();
}

void Properties::refresh_list() {
  if (!list_at(workbench_.tree(), path_, list_).element) {
    list_.clear();
    refresh();
    return;
  }
  const std::size_t count = members_of(workbench_.tree(), path_, list_).size();
  const auto kind = workbench_.catalog().element(list_);
  title_->setText(path_.isEmpty() ? list_
                                  : tr("%1 of %2").arg(list_, title_at(workbench_.tree(), path_)));
  const QString elements = count == 1 ? tr("one element") : tr("%1 elements").arg(count);
  about_->setText(kind ? tr("%1: %2").arg(kind->description, elements) : elements);
  form_->show_fields({}, Json::object());
  add_->setText(list_ == "behaviors"     ? tr("Behaviours...")
                : list_ == "coordinator" ? tr("Coordinator...")
                                         : tr("Add %1...").arg(member_word(list_)));
  add_->setVisible(list_ == "behaviors" || !workbench_.catalog().members(list_).empty());
}

void Properties::rename(const QString& from, const QString& to) {
  if (path_ == from) {
    path_ = to;
  }
}

void Properties::show_state(const Json& state) {
  if (path_.contains("/behavior[")) {
    visit_weights(state, [this](const QString& path, double weight) {
      if (path == path_) {
        show_live("priority", tr("weight"), QString::number(weight, 'g', 3));
      }
    });
  }
  for (const Json& robot : member(state, "robots")) {
    if ("robot[" + text_of(robot, "id") + ']' == robot_path(path_)) {
      show_number("max_speed", tr("speed"), number_of(robot, "speed"), 2, tr("m/s"));
      show_number("energy", tr("energy"), number_of(robot, "energy"), 0, {});
    }
  }
}

void Properties::show_pose(double x, double y, double heading_deg) {
  pose_ = {x, y, heading_deg};
  if (!pose_timer_.isActive()) {
    pose_timer_.start(kPose_ms);
  }
}

void Properties::show_last_pose() {
  show_number("x", QStringLiteral("x"), pose_[0], 2, tr("m"));
  show_number("y", QStringLiteral("y"), pose_[1], 2, tr("m"));
  show_number("heading_deg", tr("heading"), pose_[2], 0, unit_in_words("deg"));
}

// Unknown values are not shown.
void Properties::show_number(const QString& name, const QString& title, double value, int digits,
                             const QString& unit) {
  const QString text = QString::number(value, 'f', digits);
  const QString gap = unit.startsWith(QChar(0x00b0)) || unit.isEmpty() ? QString() : " ";
  show_live(name, title, std::isfinite(value) ? text + gap + unit : QString());
}

void Properties::show_live(const QString& name, const QString& title, const QString& value) {
  const bool is_past = workbench_.time_s() < workbench_.latest_s();
  const QString time = QString::number(workbench_.time_s(), 'f', is_past ? 2 : 1);
  const QString words = is_past ? tr("at %1 s: %2 %3") : tr("now at %1 s: %2 %3");
  form_->show_live(name, value.isEmpty() ? QString() : words.arg(time, title, value));
}

void Properties::refresh() {
  filter_->setVisible(list_.isEmpty());
  add_->hide();
  if (!list_.isEmpty()) {
    refresh_list();
    return;
  }
  const auto described = described_at(workbench_, path_);
  if (!described) {
    title_->setText(workbench_.tree().is_object() ? tr("Nothing is selected") : tr("No world"));
    about_->clear();
    form_->show_fields({}, Json::object());
    filter_->hide();
    return;
  }
  title_->setText(path_.isEmpty() ? tr("World") : described->title);
  about_->setText(described->kind.description);
  form_->set_folder(QFileInfo(workbench_.file()).absolutePath());
  form_->show_fields(described->kind.fields, described->values);
  form_->filter(filter_->text());
  // A narrow window takes its width from other panels: the form cannot be scrolled to the side.
  scroll_->setMinimumWidth(form_->minimumSizeHint().width() +
                           scroll_->verticalScrollBar()->sizeHint().width());
}

}  // namespace elsie::desktop
