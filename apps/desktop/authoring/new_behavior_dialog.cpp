#include "authoring/new_behavior_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "engine/workbench.h"
#include "paint/warning_label.h"

namespace elsie::desktop {

NewBehaviorDialog::NewBehaviorDialog(const QString& elsie, const QStringList& options,
                                     const QString& folder, QWidget* parent)
    : QDialog(parent), elsie_(elsie), options_(options) {
  setObjectName(QStringLiteral("new_behavior_dialog"));
  setWindowTitle(tr("New behaviour"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* form = new QFormLayout(this);
  auto* what = new QLabel(
      tr("Writes a small behaviour that works, loads it, and adds it to the selected robot. You "
         "change it in the window Source; whenever you save, the robot goes on with the new one."));
  what->setWordWrap(true);
  form->addRow(what);
  name_ = new QLineEdit;
  name_->setObjectName(QStringLiteral("behavior_name"));
  name_->setPlaceholderText(QStringLiteral("follow_wall"));
  name_->setMinimumWidth(64 * fontMetrics().averageCharWidth());
  form->addRow(tr("&Name"), name_);
  language_ = new QComboBox;
  language_->setObjectName(QStringLiteral("behavior_language"));
  language_->addItem(tr("C++, compiled: fastest"));
  language_->addItem(tr("Python: loaded at once"));
  form->addRow(tr("&Language"), language_);
  folder_ = new QLineEdit(QDir::toNativeSeparators(folder));
  folder_->setObjectName(QStringLiteral("behavior_folder"));
  auto* browse = new QPushButton(tr("&Browse..."));
  auto* row = new QHBoxLayout;
  row->addWidget(folder_, 1);
  row->addWidget(browse);
  auto* label = new QLabel(tr("In the &folder"));
  label->setBuddy(folder_);
  form->addRow(label, row);
  warning_ = new WarningLabel;
  warning_->setObjectName(QStringLiteral("behavior_warning"));
  form->addRow(warning_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  buttons->setObjectName(QStringLiteral("buttons"));
  ok_ = buttons->button(QDialogButtonBox::Ok);
  ok_->setText(tr("&Write and load"));
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &NewBehaviorDialog::write);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(browse, &QPushButton::clicked, this, [this] {
    const QString chosen = QFileDialog::getExistingDirectory(
        this, tr("The folder of the new folder"), folder_->text());
    if (!chosen.isEmpty()) folder_->setText(QDir::toNativeSeparators(chosen));
  });
  connect(&process_, &QProcess::finished, this, &NewBehaviorDialog::finish);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) {
      warning_->say(tr("The program '%1' does not start: %2").arg(elsie_, process_.errorString()));
      ok_->setEnabled(true);
    }
  });
}

NewBehaviorDialog::~NewBehaviorDialog() {
  process_.disconnect(this);
  process_.kill();
  process_.waitForFinished(1000);
}

bool NewBehaviorDialog::is_in_python() const { return language_->currentIndex() == 1; }

QString NewBehaviorDialog::source() const {
  const QString name = name_->text().trimmed();
  return QDir(QDir(folder_->text()).absoluteFilePath(name))
      .filePath(name + (is_in_python() ? QStringLiteral(".py") : QStringLiteral(".cpp")));
}

void NewBehaviorDialog::write() {
  const QString name = name_->text().trimmed();
  if (name.isEmpty()) {
    warning_->say(
        tr("The behaviour needs a name: small letters, digits and underscores, such as "
           "'follow_wall'."));
    name_->setFocus();
    return;
  }
  const QString project = QFileInfo(source()).absolutePath();
  if (QFileInfo::exists(project)) {
    warning_->say(tr("'%1' exists already; choose another name, or another folder.").arg(project));
    return;
  }
  warning_->say({});
  ok_->setEnabled(false);
  QStringList words{QStringLiteral("new"), QStringLiteral("behavior")};
  if (is_in_python()) words << QStringLiteral("--python");
  words << QStringLiteral("--folder") << project << options_ << QStringLiteral("--") << name;
  process_.start(elsie_, words);
}

void NewBehaviorDialog::finish() {
  ok_->setEnabled(true);
  if (process_.exitStatus() == QProcess::NormalExit && process_.exitCode() == 0) {
    Q_EMIT written(source(), name_->text().trimmed());
    accept();
    return;
  }
  QString why = cause_in(QString::fromUtf8(process_.readAllStandardError()));
  if (!why.isEmpty()) why[0] = why[0].toUpper();
  warning_->say(why);
  name_->setFocus();
}

}  // namespace elsie::desktop
