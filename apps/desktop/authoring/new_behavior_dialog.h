// Asks for a new behaviour, and writes its project.
#pragma once

#include <QDialog>
#include <QProcess>

class QComboBox;
class QLineEdit;
class QPushButton;

namespace elsie::desktop {

class WarningLabel;

/// `elsie new` writes the project; what it refuses is said in the dialog.
class NewBehaviorDialog : public QDialog {
  Q_OBJECT

 public:
  /// `options` are those for plugins; the project's folder is made in `folder`.
  NewBehaviorDialog(const QString& elsie, const QStringList& options, const QString& folder,
                    QWidget* parent);
  ~NewBehaviorDialog() override;

 Q_SIGNALS:
  void written(const QString& source, const QString& name);

 private:
  void write();
  void finish();
  QString source() const;
  bool is_in_python() const;

  QString elsie_;
  QStringList options_;
  QLineEdit* name_;
  QComboBox* language_;
  QLineEdit* folder_;
  WarningLabel* warning_;
  QPushButton* ok_;
  QProcess process_;
};

}  // namespace elsie::desktop
