// The dialog that makes an element of the world, or edits it. element_dialog_pages.cpp has the
// pages that only some elements have.
#pragma once

#include <QDialog>
#include <functional>
#include <map>
#include <set>

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
/// For a new element, its kinds are on the left and its form is on the right; OK adds it. For an
/// existing one, with "Apply changes immediately" each entry is a separate edit, which Cancel takes
/// back; otherwise OK makes all as one edit, and Cancel makes none.
class ElementDialog : public QDialog {
  Q_OBJECT

 public:
  /// Adds to the list `list` ("sensors") of the element at `holder` ("robot[r1]"); with "" one of
  /// the elements that a plugin declares for what is there. If that already has a coordinator, the
  /// dialog edits or replaces it.
  static ElementDialog* make(Workbench& workbench, const QString& holder, const QString& list,
                             QWidget* parent);
  /// Edits the element at `path`; returns null, with a sentence, if there is nothing to edit.
  static ElementDialog* edit(Workbench& workbench, const QString& path, QWidget* parent,
                             QString& why);

  /// Sets an attribute with which a new element begins, such as where it was dropped.
  void begin_with(const QString& name, const QString& value);
  /// Whether it edits the element at that path, also as a part, or makes the coordinator there.
  bool is_editor_of(const QString& path) const;
  /// An element was renamed, perhaps the edited one.
  void rename(const QString& from, const QString& to);
  /// Shows the form of this kind. Returns false if there is no kind of that name.
  bool choose(const QString& kind);
  /// The name of the chosen kind.
  QString kind() const;

  /// After a training the dialog stays open, with the learning curve and the button Close.
  void accept() override;
  /// During a training, Cancel stops the training and the dialog stays open.
  void reject() override;
  /// Whatever closes it: what was typed in it is not kept any longer.
  void done(int result) override;

 private:
  struct Page {
    QString title;
    QString path;  // of the element that it edits; in a new one, the name of the part, or ""
    Kind kind;
    Form* form = nullptr;
    std::map<QString, QString> before = {};  // the values with which it was opened
    std::set<QString> applied = {};          // the attributes that were changed immediately
  };

  ElementDialog(Workbench& workbench, QWidget* parent);
  ElementPlace present() const;
  /// The word for what it makes, in paths.
  QString word() const;
  void show_kind(const Kind& kind);
  void add_page(const QString& title, const QString& path, const Kind& kind, const Json& values);
  /// The values in a form, and while `with_unfinished_` those that are typed and not entered.
  std::map<QString, QString> values_in(const Page& page) const;
  /// `changed`: attributes that differ from those in the form.
  QString markup(const std::map<QString, QString>& changed = {}) const;
  QStringList edits() const;
  /// Whether a new element has other values than those with which it began.
  bool is_touched() const;
  /// Keeps what is typed for the case of a crash.
  void keep_typed();
  /// A change in a form: makes it, or keeps it for OK.
  void change(const Form* form, const QString& name, const QString& value, bool taken_back);
  /// Takes back what was changed immediately.
  void take_back_applied();
  bool has_all();
  void offer_training(const Kind& kind, Form* form, const QString& coordinator);
  bool trains_first();
  void show_learned();
  void set_busy(bool is_busy);
  void add_waypoint(const Kind& kind);
  void add_first_goal(const Kind& kind);
  void add_outline(const Kind& kind);
  /// The points of the regular polygon that a new prism begins with.
  static QString points(const std::map<QString, QString>& given);
  void offer_headings(const Kind& kind);
  void offer_drives(const QString& chosen);

  Workbench& workbench_;
  bool makes_ = false;
  bool with_unfinished_ = false;
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
  QString shortcoming_;               // why the last training was not good; "" if it was
  bool has_learned_ = false;          // the robot has the network: there is only the button Close
  QCheckBox* at_once_;
  WarningLabel* refusal_;
  QDialogButtonBox* buttons_;
};

}  // namespace elsie::desktop
