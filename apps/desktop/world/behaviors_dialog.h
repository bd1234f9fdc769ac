// Chooses the behaviours of a robot, or of a behaviour that holds others.
#pragma once

#include <QDialog>

#include "engine/catalog.h"

class QDialogButtonBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace elsie::desktop {

class WarningLabel;
class Workbench;

/// The pool of all behaviours is on the left, the chosen ones are on the right; ">>" and "<<" move
/// one at a time. OK makes all changes as one edit, Cancel makes none.
class BehaviorsDialog : public QDialog {
  Q_OBJECT

 public:
  BehaviorsDialog(Workbench& workbench, QString holder, QWidget* parent);

  const QString& holder() const { return holder_; }
  /// An element was renamed, perhaps the holder.
  void rename(const QString& from, const QString& to);

  void accept() override;

 private:
  /// The element with which a behaviour of this plugin begins, as XML.
  QString beginning_of(const QString& plugin) const;
  void fill_pool();
  void add();
  void take_away();
  void enable();

  Workbench& workbench_;
  QString holder_;
  QListWidget* pool_;
  QListWidget* carried_;
  QPushButton* add_;
  QPushButton* take_away_;
  QLabel* about_;
  WarningLabel* refusal_;
  QDialogButtonBox* buttons_;
};

}  // namespace elsie::desktop
