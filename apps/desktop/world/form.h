// A form for what an element may be given, from its declaration: units, ranges, defaults, help.
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

/// A row for each field. A value that is given is bold and can be taken back, to its default;
/// committed() comes with Enter or when the row is left, with a text as it stands in a file.
/// Numbers are written with a point, whatever the language.
class Form : public QWidget {
  Q_OBJECT

 public:
  explicit Form(QWidget* parent = nullptr);

  /// `values`: an object of those that are given, from the element. Rows that are the same as
  /// before stay, with the keyboard focus and what is being typed.
  void show_fields(const std::vector<Field>& fields, const Json& values);
  /// Files that are browsed for are named as a world in this folder would name them.
  void set_folder(const QString& folder) { folder_ = folder; }
  /// What is given now.
  const std::map<QString, QString>& values() const { return values_; }
  /// As if the user had entered it.
  void set_value(const QString& name, const QString& value);
  /// What is being typed is entered. False if some of it is no value.
  bool finish();
  /// What is no value goes, and with it all that is said about values.
  void drop_typed();
  /// A sentence below the row, until its next change; "" takes it away.
  void show_problem(const QString& name, const QString& sentence);
  /// What the value is in the run, below the row; "" takes it away.
  void show_live(const QString& name, const QString& text);
  void clear_live();
  /// The widget that the value is entered in: its object name is the field's.
  QWidget* editor(const QString& name) const;
  /// Hides all rows whose name and meaning have none of it.
  void filter(const QString& text);

 Q_SIGNALS:
  void committed(const QString& name, const QString& value);
  /// Its default holds again.
  void taken_back(const QString& name);

 private:
  struct Row {
    Field field;
    QWidget* editor = nullptr;
    QWidget* whole = nullptr;
    QLabel* label = nullptr;
    WarningLabel* problem = nullptr;
    QLabel* live = nullptr;
    QToolButton* reset = nullptr;
  };

  Row make_row(const Field& field);
  QWidget* make_editor(const Field& field);
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

/// "" or a sentence why a text is no value of the field: for what a window can see by itself. The
/// engine has the last word.
QString mistake_in(const Field& field, const QString& text);

}  // namespace elsie::desktop
