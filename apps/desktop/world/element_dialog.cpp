#include "world/element_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "engine/workbench.h"
#include "paint/warning_label.h"
#include "training/training_page.h"
#include "world/fan.h"
#include "world/form.h"
#include "world/properties.h"
#include "world/words.h"

namespace elsie::desktop {
namespace {

QString attributes_text(const std::map<QString, QString>& values) {
  QString text;
  for (const auto& [name, value] : values) {
    text += ' ' + name + "=\"" + escaped(value) + '"';
  }
  return text;
}

/// The row of the kind to begin with: the first, but of sensors the first that most behaviours
/// need.
int usual_row(const std::vector<Kind>& kinds) {
  const auto ranges = std::find_if(
      kinds.begin(), kinds.end(), [](const Kind& kind) { return kind.produces.contains("range"); });
  return ranges == kinds.end() ? 0 : static_cast<int>(ranges - kinds.begin());
}

}  // namespace

ElementDialog::ElementDialog(Workbench& workbench, QWidget* parent)
    : QDialog(parent), workbench_(workbench) {
  setObjectName("element_dialog");
  setAttribute(Qt::WA_DeleteOnClose);
  auto* column = new QVBoxLayout(this);
  auto* row = new QHBoxLayout;
  column->addLayout(row, 1);

  choice_ = new QListWidget;
  choice_->setObjectName("kinds");
  choice_->setAccessibleName(tr("Kinds"));
  choice_->setMaximumWidth(24 * fontMetrics().averageCharWidth() + 40);
  row->addWidget(choice_);
  auto* right = new QVBoxLayout;
  row->addLayout(right, 1);
  about_ = new QLabel;
  about_->setWordWrap(true);
  right->addWidget(about_);
  tabs_ = new QTabWidget;
  tabs_->setObjectName("pages");
  right->addWidget(tabs_, 1);

  refusal_ = new WarningLabel;
  refusal_->setObjectName("refusal");
  column->addWidget(refusal_);
  at_once_ = new QCheckBox(tr("Apply changes &immediately"));
  at_once_->setObjectName("apply_immediately");
  column->addWidget(at_once_);
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  buttons_->setObjectName("buttons");
  connect(buttons_, &QDialogButtonBox::accepted, this, &ElementDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &ElementDialog::reject);
  column->addWidget(buttons_);
  resize(46 * fontMetrics().averageCharWidth() + 320, 34 * fontMetrics().height());
}

ElementDialog* ElementDialog::make(Workbench& workbench, const QString& holder, const QString& list,
                                   QWidget* parent) {
  auto* dialog = new ElementDialog(workbench, parent);
  dialog->makes_ = true;
  dialog->holder_ = holder;
  dialog->list_ = list;
  const QString word = list.isEmpty() ? tr("element") : member_word(list);
  dialog->setWindowTitle(holder.isEmpty()
                             ? tr("New %1").arg(word)
                             : tr("New %1 of %2").arg(word, title_at(workbench.tree(), holder)));
  dialog->kinds_ = list.isEmpty()
                       ? workbench.catalog().declared_in(place_of(workbench.tree(), holder))
                       : workbench.catalog().members(list);
  // A behaviour that holds others cannot begin without them: it is in the dialog of behaviours.
  std::erase_if(dialog->kinds_, [](const Kind& kind) { return kind.holds_behaviors; });
  for (const Kind& kind : dialog->kinds_) {
    auto* item = new QListWidgetItem(kind.name, dialog->choice_);
    item->setToolTip(kind.description);
  }
  dialog->choice_->setVisible(dialog->kinds_.size() > 1);
  connect(dialog->choice_, &QListWidget::currentRowChanged, dialog, [dialog](int row) {
    if (row >= 0) {
      dialog->show_kind(dialog->kinds_[static_cast<std::size_t>(row)]);
    }
  });
  const ElementPlace present = dialog->present();
  if (present.element) {
    dialog->setWindowTitle(
        tr("%1 of %2").arg(member_word(list), title_at(workbench.tree(), holder)));
  }
  if (!present.element || !dialog->choose(name_of(*present.element))) {
    dialog->choice_->setCurrentRow(usual_row(dialog->kinds_));
  }
  return dialog;
}

ElementDialog* ElementDialog::edit(Workbench& workbench, const QString& path, QWidget* parent,
                                   QString& why) {
  const auto found = described_at(workbench, path);
  if (!found) {
    why = tr("There is nothing to edit at '%1'.").arg(path);
    return nullptr;
  }
  const Kind& kind = found->kind;
  const bool is_robot = kind.name == "robot";
  const bool has_some = std::any_of(kind.fields.begin(), kind.fields.end(), [](const Field& field) {
    return field.name != "id";  // the id is a name, not a parameter
  });
  if (!has_some) {
    why = tr("'%1' has no parameters: there is nothing to set.").arg(found->title);
    return nullptr;
  }
  auto* dialog = new ElementDialog(workbench, parent);
  dialog->path_ = path;
  dialog->choice_->hide();
  dialog->setWindowTitle(tr("Edit %1").arg(found->title));
  dialog->about_->setText(kind.description);
  dialog->add_page(kind.name, path, kind, found->values);
  if (is_robot) {
    for (const char* part : {"body", "drive"}) {
      const QString below = path + '/' + part;
      const auto of_part = described_at(workbench, below);
      if (of_part && !of_part->kind.fields.empty()) {
        dialog->add_page(of_part->kind.name, below, of_part->kind, of_part->values);
      }
    }
  }
  return dialog;
}

void ElementDialog::begin_with(const QString& name, const QString& value) {
  begin_with_.emplace_back(name, value);
  if (!pages_.empty()) {
    pages_.front().form->set_value(name, value);
  }
}

bool ElementDialog::choose(const QString& kind) {
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    if (kinds_[i].name == kind) {
      choice_->setCurrentRow(static_cast<int>(i));
      return true;
    }
  }
  return false;
}

QString ElementDialog::kind() const {
  return pages_.empty() ? QString() : pages_.front().kind.name;
}

QString ElementDialog::word() const { return list_.isEmpty() ? kind() : member_word(list_); }

// The coordinator that is already there.
ElementPlace ElementDialog::present() const {
  return list_ == "coordinator"
             ? place_of(workbench_.tree(), (holder_.isEmpty() ? "" : holder_ + '/') + list_)
             : ElementPlace();
}

void ElementDialog::show_kind(const Kind& kind) {
  while (tabs_->count() > 0) {
    delete tabs_->widget(0);
  }
  pages_.clear();
  fan_ = nullptr;
  training_ = nullptr;
  refusal_->say({});
  about_->setText(kind.description);
  changes_.clear();
  const ElementPlace there = present();
  makes_ = !there.element || name_of(*there.element) != kind.name;
  path_ = makes_ ? QString() : there.path;
  at_once_->setVisible(!makes_);
  if (list_ == "obstacles") setWindowTitle(tr("New %1").arg(kind.name));
  add_page(kind.name, path_, kind, makes_ ? Json::object() : attributes_of(*there.element));
  for (const auto& [name, value] : begin_with_) {
    pages_.front().form->set_value(name, value);
  }
  if (list_ == "obstacles") {
    add_outline(kind);
    add_waypoint(kind);
  }
  if (list_ == "goals") add_first_goal(kind);
  if (list_ == "robots") {
    if (const auto body = workbench_.catalog().element("body")) {
      add_page("body", "body", *body, Json::object());
    }
    offer_drives("differential");
  }
  if (list_ == "sensors" || list_ == "actuators") {
    offer_headings(kind);
  }
  keep_typed();
}

void ElementDialog::add_page(const QString& title, const QString& path, const Kind& kind,
                             const Json& values) {
  auto* form = new Form;
  form->setObjectName("form_" + kind.name);
  if (!workbench_.file().isEmpty()) {
    form->set_folder(QFileInfo(workbench_.file()).absolutePath());
  }
  form->show_fields(kind.fields, values);
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->addWidget(form);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(page);
  // The scroll area contains the page; rows that are added to a page go into the page's column.
  auto* holder = new QWidget;
  auto* whole = new QVBoxLayout(holder);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(scroll);
  tabs_->setTabToolTip(tabs_->addTab(holder, in_words(title)), title);
  pages_.push_back({title, path, kind, form, form->values()});
  if (TrainingPage::learns(kind)) {
    offer_training(kind, form, makes_ ? holder_ + "/coordinator" : path);
  }
  if (!makes_) {
    connect(form, &Form::committed, this, [this, form](const QString& name, const QString& value) {
      change(form, name, value, false);
    });
    connect(form, &Form::taken_back, this,
            [this, form](const QString& name) { change(form, name, {}, true); });
  }
  connect(form, &Form::committed, this, &ElementDialog::keep_typed);
  connect(form, &Form::taken_back, this, &ElementDialog::keep_typed);
  connect(form, &Form::typed, this, &ElementDialog::keep_typed);
}

void ElementDialog::change(const Form* form, const QString& name, const QString& value,
                           bool taken_back) {
  const auto page = std::find_if(pages_.begin(), pages_.end(),
                                 [form](const Page& each) { return each.form == form; });
  if (!at_once_->isChecked()) {
    changes_[page->path][name] = taken_back ? QString() : value;
    return;
  }
  page->applied.insert(name);
  const QString attribute = attribute_path(page->path, name);
  workbench_.edit({attribute + (taken_back ? "/@remove=true" : '=' + value)},
                  tr("set %1 of %2").arg(name, title_at(workbench_.tree(), page->path)), attribute,
                  page->form, [form = page->form, name](const Problems& problems) {
                    form->show_problem(name,
                                       problems.empty() ? QString() : problems.front().message);
                  });
}

void ElementDialog::take_back_applied() {
  QStringList edits, last;  // a name is last: the paths of the others have it
  for (Page& page : pages_) {
    for (const QString& name : std::exchange(page.applied, {})) {
      const auto value = page.before.find(name);
      const ElementPlace place = place_of(workbench_.tree(), page.path);
      const bool is_set =
          place.element && attributes_of(*place.element).contains(name.toStdString());
      if (value != page.before.end()) {
        (name == "id" ? last : edits) << attribute_path(page.path, name) + '=' + value->second;
      } else if (is_set) {
        edits << attribute_path(page.path, name) + "/@remove=true";
      }
    }
  }
  edits += last;
  if (!edits.isEmpty()) {
    workbench_.edit(edits, tr("cancel the edit of %1").arg(title_at(workbench_.tree(), path_)));
  }
}

bool ElementDialog::is_editor_of(const QString& path) const {
  if (list_ == "coordinator") {
    return path == holder_ + "/coordinator";
  }
  return !makes_ && std::any_of(pages_.begin(), pages_.end(),
                                [&](const Page& each) { return each.path == path; });
}

void ElementDialog::rename(const QString& from, const QString& to) {
  const auto follow = [&](QString& path) { path = renamed_path(path, from, to); };
  follow(path_);
  follow(holder_);
  std::map<QString, std::map<QString, QString>> changes;
  for (auto& [path, values] : changes_) {
    QString now = path;
    follow(now);
    changes[now] = std::move(values);
  }
  changes_ = std::move(changes);
  for (Page& page : pages_) follow(page.path);
  keep_typed();
}

std::map<QString, QString> ElementDialog::values_in(const Page& page) const {
  std::map<QString, QString> values = page.form->values();
  if (with_unfinished_) {
    for (const auto& [name, text] : page.form->unfinished()) values[name] = text;
  }
  return values;
}

bool ElementDialog::is_touched() const {
  return std::any_of(pages_.begin(), pages_.end(), [this](const Page& page) {
    std::map<QString, QString> values = values_in(page);
    if (&page == &pages_.front()) {
      for (const auto& [name, value] : begin_with_) {
        if (const auto found = values.find(name); found != values.end() && found->second == value) {
          values.erase(found);
        }
      }
    }
    return values != page.before;
  });
}

void ElementDialog::keep_typed() {
  const QScopedValueRollback<bool> all(with_unfinished_, true);
  std::vector<Typed> typed;
  if (!makes_ || is_touched()) {
    for (const QString& edit : edits()) {
      typed.push_back({edit.section('=', 0, 0), edit.section('=', 1)});
    }
  }
  for (const Page& page : pages_) {
    if (makes_) continue;  // the element has them
    for (const auto& [name, text] : page.form->unfinished()) {
      typed.push_back({attribute_path(page.path, name), text});
    }
  }
  workbench_.keep_typed(this, std::move(typed));
}

void ElementDialog::done(int result) {
  workbench_.keep_typed(this, {});
  QDialog::done(result);
}

QString ElementDialog::markup(const std::map<QString, QString>& changed) const {
  const Page& main = pages_.front();
  std::map<QString, QString> values = values_in(main);
  for (const auto& [name, value] : changed) values[name] = value;
  QString content;
  for (std::size_t i = 1; i < pages_.size(); ++i) {
    const Page& page = pages_[i];
    const QString attributes = attributes_text(values_in(page));
    if (page.path == "drive") {
      if (page.kind.name != "differential" || !attributes.isEmpty()) {
        content += "<drive><" + page.kind.name + attributes + "/></drive>";
      }
    } else if (page.path == "outline") {
      content += points(values_in(page));
    } else if (!attributes.isEmpty() || list_ == "goals") {
      content += '<' + page.path + attributes + "/>";
    }
  }
  return '<' + main.kind.name + attributes_text(values) +
         (content.isEmpty() ? "/>" : '>' + content + "</" + main.kind.name + '>');
}

QStringList ElementDialog::edits() const {
  QStringList edits;
  if (makes_) {
    const QString place = (holder_.isEmpty() ? QString() : holder_ + '/') + word() +
                          (present().element ? "=" : "[+]=");
    const std::map<QString, QString> values = values_in(pages_.front());
    const auto given = [&](const char* name) {
      const auto found = values.find(name);
      return found == values.end() ? QString() : found->second;
    };
    const std::vector<double> headings =
        fan_ ? fan_->headings_deg(given("yaw_deg").toDouble()) : std::vector<double>();
    if (headings.size() < 2) {
      edits << place + markup();
    }
    for (std::size_t i = 0; headings.size() > 1 && i < headings.size(); ++i) {
      std::map<QString, QString> own{{"yaw_deg", QString::number(headings[i], 'g', 9)}};
      if (!given("id").isEmpty()) own["id"] = given("id") + QString::number(i + 1);
      edits << place + markup(own);
    }
  }
  for (const auto& [path, values] : changes_) {
    for (const auto& [attribute, value] : values) {
      edits << attribute_path(path, attribute) + (value.isNull() ? "/@remove=true" : '=' + value);
    }
  }
  return edits;
}

void ElementDialog::reject() {
  if (has_learned_) {
    QDialog::accept();  // there is nothing left to cancel
    return;
  }
  if (training_ && training_->cancel()) {
    set_busy(false);
    return;
  }
  take_back_applied();
  QDialog::reject();
}

// A new element must have all that its declaration requires.
bool ElementDialog::has_all() {
  for (const Page& page : pages_) {
    for (const Field& field : page.kind.fields) {
      if (field.is_required && !page.form->values().contains(field.name) && field.name != "id") {
        refusal_->say(tr("'%1' is required: %2.").arg(field.name, field.meaning));
        return false;
      }
    }
  }
  return true;
}

void ElementDialog::accept() {
  if (pages_.empty()) {
    reject();
    return;
  }
  bool is_right = true;
  for (const Page& page : pages_) {
    is_right = page.form->finish() && is_right;
  }
  if (!is_right || (makes_ && !has_all()) || trains_first()) {
    return;
  }
  const QStringList made = edits();
  if (made.isEmpty()) {
    QDialog::accept();
    return;
  }
  const QString name = !makes_ ? tr("edit %1").arg(title_at(workbench_.tree(), path_))
                       : made.front().section('=', 0, 0).endsWith("[+]")
                           ? tr("add %1").arg(word())
                           : tr("replace %1").arg(word());
  buttons_->setEnabled(false);
  workbench_.edit(made, name, {}, this, [this](const Problems& problems) {
    buttons_->setEnabled(true);
    if (problems.empty() && training_ && training_->is_wished()) {
      show_learned();
    } else if (problems.empty()) {
      QDialog::accept();
    } else {
      refusal_->say(problems.front().message);
    }
  });
}

}  // namespace elsie::desktop
