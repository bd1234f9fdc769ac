// A form for the attributes of an element, from its declaration: units, ranges, defaults, help.
#pragma once

#include <QWidget>
#include <map>
#include <vector>

#include "engine/catalog.h"

class QFormLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QToolButton;

namespace elsie::desktop {

class WarningLabel;

/// Has a row for each field. A given value is bold and can be reset to its default. committed()
/// comes with Enter, or when the row is left, with the text as in a file. Numbers have a decimal
/// point in every language.
class Form : public QWidget {
  Q_OBJECT

 public:
  explicit Form(QWidget* parent = nullptr);

  /// `values` is an object of the values that the element gives. Rows that do not change keep the
  /// keyboard focus and unfinished input.
  void show_fields(const std::vector<Field>& fields, const Json& values);
  /// Sets the folder of the world: files that are browsed for are named as seen from there.
  void set_folder(const QString& folder) { folder_ = folder; }
  /// The values that are given now.
  const std::map<QString, QString>& values() const { return values_; }
  /// Sets a value as if the user had entered it.
  void set_value(const QString& name, const QString& value);
  /// What is typed and not entered.
  std::map<QString, QString> unfinished() const;
  /// Enters unfinished input; returns false if some of it is not a value.
  bool finish();
  /// Discards invalid input and the messages about it.
  void drop_typed();
  /// Shows a sentence below the row until its next change; "" removes it.
  void show_problem(const QString& name, const QString& sentence);
  /// Shows the value in the run below the row; "" removes it.
  void show_live(const QString& name, const QString& text);
  void clear_live();
  /// The widget for the value; its object name is the field's name.
  QWidget* editor(const QString& name) const;
  /// Hides all rows whose name and meaning do not contain the text.
  void filter(const QString& text);

 Q_SIGNALS:
  void committed(const QString& name, const QString& value);
  /// The value was reset to its default.
  void taken_back(const QString& name);
  /// unfinished() may have changed.
  void typed();

 private:
  struct Row {
    Field field;
    QWidget* editor = nullptr;
    QWidget* whole = nullptr;
    QLabel* label = nullptr;
    WarningLabel* problem = nullptr;
    QLabel* live = nullptr;
    QLabel* unit = nullptr;
    QToolButton* reset = nullptr;
  };

  Row make_row(const Field& field, const QString& title);
  QWidget* make_editor(const Field& field, const QString& title);
  void add_browse(QHBoxLayout* line, const QString& name);
  void add_picker(QHBoxLayout* line, const QString& name);
  void show_value(Row& row);
  bool take_typed(const QString& name, QLineEdit* edit);
  bool commit(const QString& name, const QString& value);
  Row* row_of(const QString& name);

  QFormLayout* layout_;
  std::vector<Row> rows_;
  QString folder_;
  std::map<QString, QString> values_;
};

/// A sentence that says why a text is not a value of the field, as far as a window can tell; "" if
/// it is one. The engine decides.
QString mistake_in(const Field& field, const QString& text);

}  // namespace elsie::desktop
