#include "world/behaviors_dialog.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <algorithm>
#include <functional>

#include "engine/workbench.h"
#include "paint/warning_label.h"

namespace elsie::desktop {
namespace {

constexpr int kPath = Qt::UserRole;  // of a behaviour that the robot already has; "" for a new one
constexpr int kPlugin = Qt::UserRole + 1;
// Behaviours need a coordinator; the first one is a sum.
const QString kFirstCoordinator = QStringLiteral("<fusion_vector_summation/>");

}  // namespace

BehaviorsDialog::BehaviorsDialog(Workbench& workbench, QString holder, QWidget* parent)
    : QDialog(parent), workbench_(workbench), holder_(std::move(holder)) {
  setObjectName("behaviors_dialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Behaviours of %1").arg(title_at(workbench_.tree(), holder_)));
  auto* grid = new QGridLayout(this);
  pool_ = new QListWidget;
  pool_->setObjectName("pool");
  carried_ = new QListWidget;
  carried_->setObjectName("carried");
  auto* pool_label = new QLabel(tr("&Pool"));
  pool_label->setBuddy(pool_);
  auto* carried_label = new QLabel(tr("&Carried"));
  carried_label->setBuddy(carried_);
  add_ = new QPushButton(">>");
  add_->setObjectName("add");
  add_->setAccessibleName(tr("Add"));
  add_->setToolTip(tr("Give the robot the selected behaviour"));
  take_away_ = new QPushButton("<<");
  take_away_->setObjectName("take_away");
  take_away_->setAccessibleName(tr("Remove"));
  take_away_->setToolTip(tr("Remove the selected behaviour"));
  about_ = new QLabel;
  about_->setWordWrap(true);
  refusal_ = new WarningLabel;
  refusal_->setObjectName("refusal");
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  buttons_->setObjectName("buttons");
  add_->setAutoDefault(false);
  take_away_->setAutoDefault(false);
  buttons_->button(QDialogButtonBox::Ok)->setDefault(true);
  grid->addWidget(pool_label, 0, 0);
  grid->addWidget(carried_label, 0, 2);
  grid->addWidget(pool_, 1, 0, 4, 1);
  grid->addWidget(add_, 2, 1);
  grid->addWidget(take_away_, 3, 1);
  grid->addWidget(carried_, 1, 2, 4, 1);
  grid->addWidget(about_, 5, 0, 1, 3);
  grid->addWidget(refusal_, 6, 0, 1, 3);
  grid->addWidget(buttons_, 7, 0, 1, 3);

  for (const ElementPlace& each : members_of(workbench_.tree(), holder_, "behaviors")) {
    auto* item = new QListWidgetItem(title_of(*each.element), carried_);
    item->setData(kPath, each.path);
    item->setData(kPlugin, name_of(*each.element));
  }
  fill_pool();
  connect(add_, &QPushButton::clicked, this, &BehaviorsDialog::add);
  connect(take_away_, &QPushButton::clicked, this, &BehaviorsDialog::take_away);
  connect(pool_, &QListWidget::itemDoubleClicked, this, &BehaviorsDialog::add);
  connect(carried_, &QListWidget::itemDoubleClicked, this, &BehaviorsDialog::take_away);
  connect(pool_, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    about_->setText(item ? item->toolTip() : QString());
    enable();
  });
  connect(carried_, &QListWidget::currentItemChanged, this, &BehaviorsDialog::enable);
  connect(buttons_, &QDialogButtonBox::accepted, this, &BehaviorsDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &BehaviorsDialog::reject);
  enable();
}

void BehaviorsDialog::enable() {
  add_->setEnabled(pool_->currentItem() != nullptr);
  take_away_->setEnabled(carried_->currentItem() != nullptr);
}

// No behaviour is offered twice: the pool lacks those that the robot has.
void BehaviorsDialog::fill_pool() {
  // A button that is disabled for an instant loses the focus to the next one.
  const QSignalBlocker blocker(pool_);
  const int row = pool_->currentRow();
  QStringList taken;
  for (int i = 0; i < carried_->count(); ++i) {
    taken << carried_->item(i)->data(kPlugin).toString();
  }
  pool_->clear();
  for (const Kind& kind : workbench_.catalog().plugins("behavior")) {
    if (!taken.contains(kind.name)) {
      (new QListWidgetItem(kind.name, pool_))->setToolTip(kind.description);
    }
  }
  // It begins with what most robots need.
  const auto usual = pool_->findItems("avoid_obstacle", Qt::MatchExactly);
  if (row < 0 && !usual.isEmpty()) {
    pool_->setCurrentItem(usual.front());
  } else {
    pool_->setCurrentRow(std::clamp(row, 0, std::max(0, pool_->count() - 1)));
  }
  about_->setText(pool_->currentItem() ? pool_->currentItem()->toolTip() : QString());
  enable();
}

// A behaviour that holds others is refused without any: it begins with the first that needs
// nothing.
QString BehaviorsDialog::beginning_of(const QString& plugin) const {
  const std::vector<Kind> all = workbench_.catalog().plugins("behavior");
  const auto holds = [&](const Kind& each) { return each.name == plugin && each.holds_behaviors; };
  const auto is_simple = [](const Kind& each) {
    return !each.holds_behaviors && each.needs.isEmpty() &&
           std::none_of(each.fields.begin(), each.fields.end(), std::mem_fn(&Field::is_required));
  };
  const auto usual = std::find_if(all.begin(), all.end(), [&](const Kind& each) {
    return each.name == "wander" && is_simple(each);
  });
  const auto first = usual != all.end() ? usual : std::find_if(all.begin(), all.end(), is_simple);
  if (first == all.end() || std::none_of(all.begin(), all.end(), holds)) {
    return '<' + plugin + "/>";
  }
  return QString("<%1><behaviors><%2/></behaviors><coordinator>%3</coordinator></%1>")
      .arg(plugin, first->name, kFirstCoordinator);
}

void BehaviorsDialog::add() {
  if (const QListWidgetItem* chosen = pool_->currentItem()) {
    auto* item = new QListWidgetItem(chosen->text(), carried_);
    item->setData(kPlugin, chosen->text());
    carried_->setCurrentItem(item);
    fill_pool();
  }
}

void BehaviorsDialog::take_away() {
  delete carried_->currentItem();
  fill_pool();
}

void BehaviorsDialog::rename(const QString& from, const QString& to) {
  holder_ = renamed_path(holder_, from, to);
  for (int i = 0; i < carried_->count(); ++i) {
    QListWidgetItem* item = carried_->item(i);
    item->setData(kPath, renamed_path(item->data(kPath).toString(), from, to));
  }
}

void BehaviorsDialog::accept() {
  QStringList edits, kept;
  for (int i = 0; i < carried_->count(); ++i) {
    const QListWidgetItem* item = carried_->item(i);
    const QString path = item->data(kPath).toString();
    if (path.isEmpty()) {
      edits << holder_ + "/behavior[+]=" + beginning_of(item->text());
    } else {
      kept << path;
    }
  }
  QStringList removals;
  for (const ElementPlace& each : members_of(workbench_.tree(), holder_, "behaviors")) {
    if (!kept.contains(each.path)) removals << each.path + "/@remove=true";
  }
  edits = removals + edits;
  if (edits.isEmpty()) {
    QDialog::accept();
    return;
  }
  const bool has_some = carried_->count() > 0;
  const bool has_coordinator =
      place_of(workbench_.tree(), holder_ + "/coordinator").element != nullptr;
  if (has_some && !has_coordinator) {
    edits << holder_ + "/coordinator[+]=" + kFirstCoordinator;
  } else if (!has_some && has_coordinator) {
    edits << holder_ + "/coordinator/@remove=true";
  }
  refusal_->say({});
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(false);
  workbench_.edit(edits, tr("change behaviours of %1").arg(title_at(workbench_.tree(), holder_)),
                  {}, this, [this](const Problems& problems) {
                    buttons_->button(QDialogButtonBox::Ok)->setEnabled(true);
                    if (problems.empty()) {
                      QDialog::accept();
                    } else {
                      refusal_->say(problems.front().message);
                    }
                  });
}

}  // namespace elsie::desktop
