// The keys of the window's actions, which each user may change.
#pragma once

#include <QDialog>
#include <QKeySequence>
#include <QList>

class QAction;
class QDialogButtonBox;
class QTableWidget;

namespace elsie::desktop {

class WarningLabel;

/// The text of a command without the marks of a menu.
QString title_of(const QAction& action);

/// Gives the actions the keys that the user has assigned, which are stored under their object
/// names. Call it once, while the actions have the program's own keys; the dialog remembers those.
void load_shortcuts(const QList<QAction*>& actions);

/// Lists all actions with their keys. OK applies the keys and stores them for this user; it refuses
/// a key that two actions would share. Keys that only the view or the time line uses, such as G and
/// R, belong to no action.
class ShortcutsDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ShortcutsDialog(QList<QAction*> actions, QWidget* parent = nullptr);

  void accept() override;

 private:
  QKeySequence key_in(int row) const;
  void set_key(int row, const QKeySequence& key);

  QList<QAction*> actions_;  // by row
  QTableWidget* table_;
  WarningLabel* refusal_;
};

}  // namespace elsie::desktop
