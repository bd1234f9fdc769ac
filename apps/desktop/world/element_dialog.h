// The dialog of one thing in the world: to make it and to edit it. element_dialog_pages.cpp has the
// pages that only some things have.
#pragma once

#include <QDialog>
#include <functional>

#include "engine/catalog.h"

class QCheckBox;
class QDialogButtonBox;
class QLabel;
class QListWidget;
class QTabWidget;

namespace elsie::desktop {

class Fan;
class Form;
class TrainingPage;
class WarningLabel;
class Workbench;

/// Makes an element of a list, such as a sensor or a robot, or edits one.
///
/// To make one: its kinds on the left, its form on the right, OK adds it. To edit one: with "Apply
/// changes immediately" each entry is an edit of its own; otherwise OK makes them as one, and
/// Cancel none.
class ElementDialog : public QDialog {
  Q_OBJECT

 public:
  /// Adds to the list `list` ("sensors") of the element at `holder` ("robot[r1]"). Where that has a
  /// coordinator, the dialog edits it, or puts another in its place.
  static ElementDialog* make(Workbench& workbench, const QString& holder, const QString& list,
                             QWidget* parent);
  /// Edits the element at `path`; null, with a sentence, if it has nothing to edit.
  static ElementDialog* edit(Workbench& workbench, const QString& path, QWidget* parent,
                             QString& why);

  /// Attributes that a new element begins with: where it was dropped.
  void begin_with(const QString& name, const QString& value);
  /// Shows the form of this kind. False if there is none of that name.
  bool choose(const QString& kind);

  /// After a training it stays open, with the learning curve and the button Close.
  void accept() override;
  /// While a network is trained: ends that, and stays open.
  void reject() override;

 private:
  struct Page {
    QString title;
    QString path;  // of the element that it edits; of a new one: the element's name in it, or ""
    Kind kind;
    Form* form = nullptr;
  };

  ElementDialog(Workbench& workbench, QWidget* parent);
  ElementPlace present() const;
  void show_kind(const Kind& kind);
  void add_page(const QString& title, const QString& path, const Kind& kind, const Json& values);
  /// `changed`: attributes that are not those of the form.
  QString markup(const std::map<QString, QString>& changed = {}) const;
  QStringList edits() const;
  bool has_all();
  void offer_training(const Kind& kind, Form* form, const QString& coordinator);
  bool trains_first();
  void show_learned();
  void set_busy(bool is_busy);
  void add_waypoint(const Kind& kind);
  void add_outline(const Kind& kind);
  /// The points of the regular polygon that a new prism begins with.
  static QString points(const std::map<QString, QString>& given);
  void offer_headings(const Kind& kind);
  void offer_drives(const QString& chosen);

  Workbench& workbench_;
  bool makes_ = false;
  QString path_;  // edited
  QString holder_, list_;
  std::vector<Kind> kinds_;
  std::vector<std::pair<QString, QString>> begin_with_;
  std::vector<Page> pages_;
  std::map<QString, std::map<QString, QString>> changes_;  // by the path of the element
  QListWidget* choice_;
  QLabel* about_;
  QTabWidget* tabs_;
  Fan* fan_ = nullptr;                // of a new sensor with a heading
  TrainingPage* training_ = nullptr;  // of a coordinator that learns
  QString shortcoming_;               // a sentence on the last training; "": it is good
  bool has_learned_ = false;          // the robot has the network: there is only Close
  QCheckBox* at_once_;
  WarningLabel* refusal_;
  QDialogButtonBox* buttons_;
};

}  // namespace elsie::desktop
