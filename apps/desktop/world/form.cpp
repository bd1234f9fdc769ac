#include "world/form.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

#include "look/icons.h"
#include "paint/boxes.h"
#include "paint/warning_label.h"
#include "world/words.h"

namespace elsie::desktop {
namespace {

constexpr int kFewest_letters = 9;  // that a field has room for

bool is_number(const Field& field) { return field.type == "number" || field.type == "integer"; }

/// Leaves Ctrl+Z to the window while nothing is typed; QLineEdit would take it.
class FieldEdit : public QLineEdit {
 protected:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::ShortcutOverride && !isModified()) {
      const auto* key = static_cast<QKeyEvent*>(event);
      if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
        event->ignore();
        return false;
      }
    }
    return QLineEdit::event(event);
  }
};

/// Steps a number by the arrow keys: whole numbers by one, others by one in their second digit.
class NumberEdit : public FieldEdit {
 public:
  explicit NumberEdit(bool is_integer) : is_integer_(is_integer) {}

 protected:
  void keyPressEvent(QKeyEvent* event) override {
    const int way = event->key() == Qt::Key_Up ? 1 : event->key() == Qt::Key_Down ? -1 : 0;
    if (way == 0) {
      QLineEdit::keyPressEvent(event);
      return;
    }
    const QString next = stepped(text().isEmpty() ? placeholderText() : text(), way);
    if (!next.isEmpty()) {
      setText(next);
      setModified(true);
      Q_EMIT editingFinished();
    }
  }

 private:
  /// "" if the text is not a number, or if the next number is not allowed.
  QString stepped(const QString& from, int way) const {
    bool is_right = false;
    if (is_integer_) {
      const qint64 value = QLocale::c().toLongLong(from, &is_right);
      const qint64 last =
          way > 0 ? std::numeric_limits<qint64>::max() : std::numeric_limits<qint64>::min();
      return is_right && value != last ? QString::number(value + way) : QString();
    }
    const double value = QLocale::c().toDouble(from, &is_right);
    const double size =
        value == 0.0 ? 1.0 : std::pow(10.0, std::floor(std::log10(std::abs(value))));
    const double next = value + way * 0.1 * size;
    return is_right && std::isfinite(next) ? QLocale::c().toString(next, 'g', kDigits) : QString();
  }

  static constexpr int kDigits = 15;  // the digits that a double always has
  bool is_integer_;
};

/// The usual kind of file for a field of that name.
QStringList kinds_of_file(const QString& name) {
  const QString all = Form::tr("All files (*)");
  const QHash<QString, QString> kinds{{"model", Form::tr("Fuzzy models (*.fcl)")},
                                      {"weights", Form::tr("Weights of networks (*.weights)")},
                                      {"template", Form::tr("Robots (*.xml)")}};
  return kinds.contains(name) ? QStringList{kinds[name], all} : QStringList{all};
}

QString tip_of(const Field& field) {
  QString tip = "<p><b>" + field.name.toHtmlEscaped() + "</b>";
  if (!field.unit.isEmpty()) tip += " (" + field.unit.toHtmlEscaped() + ')';
  tip += "</p><p>" + field.meaning.toHtmlEscaped() + "</p>";
  if (!field.range.isEmpty()) tip += "<p>" + field.range.toHtmlEscaped() + "</p>";
  if (!field.default_text.isEmpty())
    tip += "<p>" + Form::tr("default: %1").arg(field.default_text.toHtmlEscaped()) + "</p>";
  return tip;
}

/// The name in words. Without their units, two may be alike: error and error_m.
QString row_title(const Field& field, const std::vector<Field>& among) {
  const QString words = in_words(field.name, field.unit);
  const auto alike = std::count_if(among.begin(), among.end(), [&](const Field& each) {
    return in_words(each.name, each.unit) == words;
  });
  return alike < 2              ? words
         : field.unit.isEmpty() ? Form::tr("%1 without unit").arg(words)
                                : Form::tr("%1 in %2").arg(words, unit_in_words(field.unit));
}

}  // namespace

QString mistake_in(const Field& field, const QString& text) {
  if (text.isEmpty() && field.is_required) {
    return Form::tr("'%1' is required.").arg(field.name);
  }
  if (!is_number(field) || text.isEmpty()) {
    return {};
  }
  bool is_right = false;
  const double value = QLocale::c().toDouble(text, &is_right);
  const bool is_whole = field.type != "integer" || value == std::round(value);
  if (!is_right || !std::isfinite(value) || !is_whole || text.contains(',')) {
    return Form::tr("'%1' is not a %2; write it with a point, as in 1.5.")
        .arg(text, field.type == "integer" ? Form::tr("whole number") : Form::tr("number"));
  }
  if ((field.least && value < *field.least) || (field.most && value > *field.most)) {
    return Form::tr("%1 is out of range: expected a number %2 %3")
               .arg(text, field.range, field.unit)
               .trimmed() +
           '.';
  }
  return {};
}

Form::Form(QWidget* parent) : QWidget(parent), layout_(new QFormLayout(this)) {
  layout_->setRowWrapPolicy(QFormLayout::WrapLongRows);
  layout_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

Form::Row* Form::row_of(const QString& name) {
  const auto found = std::find_if(rows_.begin(), rows_.end(),
                                  [&](const Row& row) { return row.field.name == name; });
  return found == rows_.end() ? nullptr : &*found;
}

QWidget* Form::editor(const QString& name) const {
  for (const Row& row : rows_) {
    if (row.field.name == name) {
      return row.editor;
    }
  }
  return nullptr;
}

void Form::show_fields(const std::vector<Field>& fields, const Json& values) {
  const bool same = std::equal(fields.begin(), fields.end(), rows_.begin(), rows_.end(),
                               [](const Field& field, const Row& row) {
                                 return field.name == row.field.name &&
                                        field.type == row.field.type &&
                                        field.choices == row.field.choices &&
                                        field.default_text == row.field.default_text;
                               });
  if (!same) {
    while (layout_->rowCount() > 0) {
      layout_->removeRow(0);
    }
    rows_.clear();
    int widest = 0;  // unit, so that the fields end below each other
    for (const Field& field : fields) {
      rows_.push_back(make_row(field, row_title(field, fields)));
      if (rows_.back().unit) widest = std::max(widest, rows_.back().unit->sizeHint().width());
    }
    for (const Row& row : rows_) {
      if (row.unit) row.unit->setMinimumWidth(widest);
    }
  }
  values_.clear();
  if (values.is_object()) {
    for (const auto& [name, value] : values.items()) {
      values_[QString::fromStdString(name)] = written(value);
    }
  }
  for (Row& row : rows_) {
    show_value(row);
    row.problem->say({});
  }
}

QWidget* Form::make_editor(const Field& field, const QString& title) {
  const QString name = field.name;
  QWidget* editor = nullptr;
  if (!field.choices.isEmpty() || field.type == "boolean") {
    auto* box = new QComboBox;
    box->addItems(field.choices.isEmpty() ? QStringList{"true", "false"} : field.choices);
    quiet_wheel(box);
    connect(box, &QComboBox::textActivated, this,
            [this, name](const QString& text) { commit(name, text); });
    editor = box;
  } else {
    QLineEdit* edit = is_number(field) ? new NumberEdit(field.type == "integer") : new FieldEdit;
    edit->setPlaceholderText(field.default_text);
    connect(edit, &QLineEdit::editingFinished, this,
            [this, edit, name] { take_typed(name, edit); });
    connect(edit, &QLineEdit::textEdited, this, &Form::typed);
    editor = edit;
  }
  editor->setObjectName(name);
  editor->setAccessibleName(field.unit.isEmpty() ? title
                                                 : in_words(name, field.unit) + ", " + field.unit);
  editor->setAccessibleDescription(field.meaning);
  editor->setToolTip(tip_of(field));
  return editor;
}

void Form::add_browse(QHBoxLayout* line, const QString& name) {
  auto* browse = new QToolButton;
  browse->setText(tr("..."));
  browse->setToolTip(tr("Browse for the file"));
  browse->setAccessibleName(browse->toolTip());
  browse->setObjectName(name + "_browse");
  connect(browse, &QToolButton::clicked, this, [this, name] {
    QFileDialog dialog(this, tr("File for '%1'").arg(name), folder_);
    dialog.setObjectName("browse_dialog");
    dialog.setFileMode(QFileDialog::ExistingFile);
    dialog.setNameFilters(kinds_of_file(name));
    if (dialog.exec() == QDialog::Accepted) {
      const QString file = dialog.selectedFiles().front();
      set_value(name, folder_.isEmpty() ? file : QDir(folder_).relativeFilePath(file));
    }
  });
  line->addWidget(browse);
}

void Form::add_picker(QHBoxLayout* line, const QString& name) {
  auto* pick = new QPushButton(tr("Pick..."));
  connect(pick, &QPushButton::clicked, this, [this, name] {
    const auto given = values_.find(name);
    const QColor colour =
        QColorDialog::getColor(QColor(given == values_.end() ? "#808080" : given->second), this);
    if (colour.isValid()) {
      set_value(name, colour.name());
    }
  });
  line->addWidget(pick);
}

Form::Row Form::make_row(const Field& field, const QString& title) {
  Row row;
  row.field = field;
  const QString name = field.name;
  row.whole = new QWidget(this);
  auto* column = new QVBoxLayout(row.whole);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(1);
  auto* line = new QHBoxLayout;
  line->setSpacing(fontMetrics().averageCharWidth() / 2);
  column->addLayout(line);

  row.editor = make_editor(field, title);
  row.editor->setMinimumWidth(kFewest_letters * fontMetrics().averageCharWidth());
  line->addWidget(row.editor, 1);
  if (!field.unit.isEmpty()) {
    row.unit = new QLabel(unit_in_words(field.unit));
    line->addWidget(row.unit);
  }
  if (field.type == "file") {
    add_browse(line, name);
  }
  if (field.type == "colour" || name == "colour") {
    add_picker(line, name);
  }
  row.live = new QLabel;
  row.live->setObjectName(name + "_live");
  row.live->setWordWrap(true);
  row.live->hide();
  row.reset = new QToolButton;
  row.reset->setIcon(icon("reset"));
  row.reset->setAutoRaise(true);
  row.reset->setObjectName(name + "_reset");
  row.reset->setAccessibleName(tr("Default of %1").arg(title));
  row.reset->setToolTip(field.default_text.isEmpty()
                            ? tr("Remove the value")
                            : tr("Back to the default, %1").arg(field.default_text));
  connect(row.reset, &QToolButton::clicked, this, [this, name] {
    values_.erase(name);
    show_value(*row_of(name));
    show_problem(name, {});
    Q_EMIT taken_back(name);
  });
  line->addWidget(row.reset);

  column->addWidget(row.live);  // below: beside, it takes the field's room

  row.problem = new WarningLabel;
  row.problem->setObjectName(name + "_problem");
  column->addWidget(row.problem);

  row.label = new QLabel(title + (field.is_required ? " *" : ""));
  row.label->setBuddy(row.editor);
  row.label->setToolTip(tip_of(field));
  layout_->addRow(row.label, row.whole);
  return row;
}

void Form::show_value(Row& row) {
  const auto given = values_.find(row.field.name);
  const QString value = given == values_.end() ? QString() : given->second;
  if (auto* box = qobject_cast<QComboBox*>(row.editor)) {
    const QString shown = value.isEmpty() ? row.field.default_text : value;
    box->setCurrentIndex(box->findText(shown));
  } else if (auto* edit = qobject_cast<QLineEdit*>(row.editor)) {
    if (!(edit->hasFocus() && edit->isModified())) {
      edit->setText(value);
      edit->setCursorPosition(0);  // a long text shows its beginning
      edit->setModified(false);
    }
  }
  QFont font = row.label->font();
  font.setBold(given != values_.end());
  row.label->setFont(font);
  row.reset->setEnabled(given != values_.end() && !row.field.is_required);
}

void Form::set_value(const QString& name, const QString& value) {
  if (row_of(name)) {
    commit(name, value);
    show_value(*row_of(name));
  }
}

// A text that is refused stays in the field as unfinished input.
bool Form::take_typed(const QString& name, QLineEdit* edit) {
  const auto given = values_.find(name);
  if (!edit->isModified() || edit->text() == (given == values_.end() ? QString() : given->second)) {
    return true;
  }
  edit->setModified(false);
  const bool is_right = commit(name, edit->text());
  edit->setModified(!is_right);
  Q_EMIT typed();
  return is_right;
}

std::map<QString, QString> Form::unfinished() const {
  std::map<QString, QString> texts;
  for (const Row& row : rows_) {
    const auto* edit = qobject_cast<QLineEdit*>(row.editor);
    if (edit && edit->isModified()) texts[row.field.name] = edit->text();
  }
  return texts;
}

bool Form::finish() {
  bool is_right = true;
  for (const Row& row : rows_) {
    if (auto* edit = qobject_cast<QLineEdit*>(row.editor)) {
      is_right = take_typed(row.field.name, edit) && is_right;
    }
  }
  return is_right;
}

void Form::drop_typed() {
  for (Row& row : rows_) {
    if (auto* edit = qobject_cast<QLineEdit*>(row.editor)) {
      edit->setModified(false);
      show_value(row);
    }
    row.problem->say({});
    row.live->hide();
  }
  Q_EMIT typed();
}

bool Form::commit(const QString& name, const QString& value) {
  Row* row = row_of(name);
  const QString mistake = mistake_in(row->field, value);
  show_problem(name, mistake);
  if (!mistake.isEmpty()) {
    return false;
  }
  if (value.isEmpty() && row->field.type != "text") {
    values_.erase(name);
    show_value(*row);
    Q_EMIT taken_back(name);
    return true;
  }
  values_[name] = value;
  show_value(*row);
  Q_EMIT committed(name, value);
  return true;
}

void Form::show_problem(const QString& name, const QString& sentence) {
  if (Row* row = row_of(name)) {
    row->problem->say(sentence);
  }
}

void Form::show_live(const QString& name, const QString& text) {
  if (Row* row = row_of(name)) {
    row->live->setText(text);
    row->live->setVisible(!text.isEmpty());
  }
}

void Form::clear_live() {
  for (const Row& row : rows_) {
    show_live(row.field.name, {});
  }
}

void Form::filter(const QString& text) {
  for (Row& row : rows_) {
    const bool fits = row.field.name.contains(text, Qt::CaseInsensitive) ||
                      row.label->text().contains(text, Qt::CaseInsensitive) ||
                      row.field.meaning.contains(text, Qt::CaseInsensitive);
    layout_->setRowVisible(row.whole, fits);
  }
}

}  // namespace elsie::desktop
