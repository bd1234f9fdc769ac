#include "shortcuts.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "paint/warning_label.h"

namespace elsie::desktop {
namespace {

constexpr auto kGroup = "shortcuts/";
constexpr auto kOwn = "own_shortcut";  // the property of an action: the program's key

QKeySequence own_key(const QAction& action) { return action.property(kOwn).value<QKeySequence>(); }

}  // namespace

QString title_of(const QAction& action) { return action.text().remove('&').remove("..."); }

void load_shortcuts(const QList<QAction*>& actions) {
  const QSettings settings;
  for (QAction* each : actions) {
    each->setProperty(kOwn, QVariant::fromValue(each->shortcut()));
    if (const QVariant chosen = settings.value(kGroup + each->objectName()); chosen.isValid()) {
      each->setShortcut(QKeySequence(chosen.toString(), QKeySequence::PortableText));
    }
  }
}

ShortcutsDialog::ShortcutsDialog(QList<QAction*> actions, QWidget* parent)
    : QDialog(parent), actions_(std::move(actions)) {
  setObjectName("shortcuts_dialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Keys of the commands"));
  std::sort(actions_.begin(), actions_.end(), [](const QAction* a, const QAction* b) {
    return title_of(*a).localeAwareCompare(title_of(*b)) < 0;
  });
  auto* column = new QVBoxLayout(this);
  auto* filter = new QLineEdit;
  filter->setObjectName("filter");
  filter->setPlaceholderText(tr("Filter"));
  filter->setAccessibleName(tr("Filter of the commands"));
  filter->setClearButtonEnabled(true);
  column->addWidget(filter);
  table_ = new QTableWidget(static_cast<int>(actions_.size()), 2);
  table_->setObjectName("keys");
  table_->setAccessibleName(tr("Commands and their keys"));
  table_->setHorizontalHeaderLabels({tr("Command"), tr("Key")});
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table_->verticalHeader()->hide();
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  for (int row = 0; row < table_->rowCount(); ++row) {
    const QAction& action = *actions_[row];
    auto* title = new QTableWidgetItem(title_of(action));
    title->setFlags(Qt::ItemIsEnabled);
    table_->setItem(row, 0, title);
    auto* key = new QKeySequenceEdit(action.shortcut());
    key->setObjectName("key_" + action.objectName());
    key->setAccessibleName(tr("Key of %1").arg(title_of(action)));
    table_->setCellWidget(row, 1, key);
  }
  table_->setColumnWidth(1, 32 * fontMetrics().averageCharWidth());
  column->addWidget(table_, 1);
  refusal_ = new WarningLabel;
  refusal_->setObjectName("refusal");
  column->addWidget(refusal_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel |
                                       QDialogButtonBox::RestoreDefaults);
  buttons->setObjectName("buttons");
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &ShortcutsDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &ShortcutsDialog::reject);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this, [this] {
    for (int row = 0; row < table_->rowCount(); ++row) {
      set_key(row, own_key(*actions_[row]));
    }
  });
  connect(filter, &QLineEdit::textChanged, this, [this](const QString& text) {
    for (int row = 0; row < table_->rowCount(); ++row) {
      table_->setRowHidden(row, !table_->item(row, 0)->text().contains(text, Qt::CaseInsensitive));
    }
  });
  resize(90 * fontMetrics().averageCharWidth(), 40 * fontMetrics().height());
}

QKeySequence ShortcutsDialog::key_in(int row) const {
  return qobject_cast<QKeySequenceEdit*>(table_->cellWidget(row, 1))->keySequence();
}

void ShortcutsDialog::set_key(int row, const QKeySequence& key) {
  qobject_cast<QKeySequenceEdit*>(table_->cellWidget(row, 1))->setKeySequence(key);
}

void ShortcutsDialog::accept() {
  QHash<QKeySequence, QString> taken;
  for (int row = 0; row < table_->rowCount(); ++row) {
    const QKeySequence key = key_in(row);
    const QString title = title_of(*actions_[row]);
    if (!key.isEmpty() && taken.contains(key)) {
      refusal_->say(tr("%1 is the key of '%2' and of '%3'. Remove it from one of them.")
                        .arg(key.toString(QKeySequence::NativeText), taken[key], title));
      return;
    }
    taken.insert(key, title);
  }
  QSettings settings;
  for (int row = 0; row < table_->rowCount(); ++row) {
    QAction& action = *actions_[row];
    const QKeySequence key = key_in(row);
    action.setShortcut(key);
    if (key == own_key(action)) {
      settings.remove(kGroup + action.objectName());
    } else {
      settings.setValue(kGroup + action.objectName(), key.toString(QKeySequence::PortableText));
    }
  }
  QDialog::accept();
}

}  // namespace elsie::desktop
