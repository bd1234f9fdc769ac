#include "world/fan.h"

#include <QHBoxLayout>
#include <QLabel>
#include <cmath>

#include "paint/boxes.h"

namespace elsie::desktop {
namespace {

constexpr int kMost = 72;
constexpr double kSpread_deg = 120.0;
constexpr double kCircle_deg = 360.0;

}  // namespace

Fan::Fan(int count, QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  count_ = new CountBox;
  count_->setObjectName("count");
  count_->setRange(1, kMost);
  count_->setToolTip(tr("How many sensors of this kind are added at once"));
  auto* count_label = new QLabel(tr("Ho&w many"));
  count_label->setBuddy(count_);
  spread_deg_ = new NumberBox;
  spread_deg_->setObjectName("spread_deg");
  spread_deg_->setRange(0.0, kCircle_deg);
  spread_deg_->setDecimals(1);
  spread_deg_->setValue(kSpread_deg);
  spread_deg_->setSuffix(QStringLiteral("\u00b0"));
  spread_deg_->setToolTip(tr("The angle between the first and the last; 360: a ring"));
  auto* spread_label = new QLabel(tr("&over"));
  spread_label->setBuddy(spread_deg_);
  for (QWidget* each :
       std::initializer_list<QWidget*>{count_label, count_, spread_label, spread_deg_}) {
    row->addWidget(each);
  }
  row->addStretch(1);
  connect(count_, &QSpinBox::valueChanged, spread_deg_,
          [this](int value) { spread_deg_->setEnabled(value > 1); });
  count_->setValue(count);
  spread_deg_->setEnabled(count > 1);
  connect(count_, &QSpinBox::valueChanged, this, [this] { is_chosen_ = true; });
}

void Fan::become_one() {
  if (!is_chosen_) {
    count_->setValue(1);
  }
}

std::vector<double> Fan::headings_deg(double middle_deg) const {
  const int count = count_->value();
  const double spread = count > 1 ? spread_deg_->value() : 0.0;
  const double step = spread / (spread < kCircle_deg ? std::max(1, count - 1) : count);
  std::vector<double> headings;
  for (int i = 0; i < count; ++i) {
    const double heading = middle_deg + step * (0.5 * (count - 1) - i);  // the leftmost first
    headings.push_back(std::round(1e6 * heading) / 1e6);
  }
  return headings;
}

}  // namespace elsie::desktop
