#include "watch/run_card.h"

#include <QApplication>
#include <QClipboard>
#include <QFontDatabase>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "paint/axes.h"
#include "watch/reasons.h"

namespace elsie::desktop {
namespace {

constexpr std::size_t kMostRobots = 3;  // in the notice

QLabel* wrapped(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(name));
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QColor band_of(const QString& outcome, const QPalette& palette) {
  return outcome == "success"      ? QColor(0x2e9e5b)
         : outcome == "no_goals"   ? palette.color(QPalette::Mid)
         : outcome == "time_limit" ? QColor(0xd9901a)
                                   : QColor(0xc8372d);
}

/// In addition to the colour.
QString sign_of(const QString& outcome) {
  return outcome == "success"    ? QStringLiteral("✓ ")
         : outcome == "no_goals" ? QString()
                                 : QStringLiteral("✗ ");
}

}  // namespace

RunCard::RunCard(QWidget* parent)
    : Card(Corner::bottom_right, parent),
      title_(wrapped("run_card_title")),
      why_(wrapped("run_card_why")) {
  setObjectName(QStringLiteral("run_card"));
  QFont large = title_->font();
  large.setPointSizeF(1.25 * large.pointSizeF());
  large.setBold(true);
  title_->setFont(large);
  column()->addWidget(title_);
  column()->addWidget(why_);

  facts_ = new QFormLayout;
  facts_->setHorizontalSpacing(fontMetrics().height());
  facts_->setVerticalSpacing(fontMetrics().height() / 6);
  const auto fact = [this](const char* name, const QString& label) {
    auto* value = new QLabel;
    value->setObjectName(QLatin1String(name));
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    facts_->addRow(label, value);
    return value;
  };
  collected_ = fact("run_card_collected", tr("Collected"));
  distance_ = fact("run_card_distance", tr("Distance"));
  collisions_ = fact("run_card_collisions", tr("Collisions"));
  seed_ = fact("run_card_seed", tr("Seed"));
  auto* hash_row = new QHBoxLayout;
  hash_row->setSpacing(fontMetrics().averageCharWidth());
  hash_ = new QLabel;
  hash_->setObjectName(QStringLiteral("run_card_hash"));
  hash_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  hash_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* copy = new QToolButton;
  copy->setObjectName(QStringLiteral("copy_hash"));
  copy->setText(tr("Copy"));
  copy->setToolTip(tr("Copies the state hash: two runs with the same hash are the same run"));
  hash_row->addWidget(hash_);
  hash_row->addWidget(copy);
  hash_row->addStretch(1);
  facts_->addRow(tr("State hash"), hash_row);
  column()->addLayout(facts_);

  auto* buttons = new QHBoxLayout;
  auto* again = new QPushButton(tr("Run &again"));
  again->setObjectName(QStringLiteral("run_again"));
  again->setToolTip(tr("The same run again: the same world and seed"));
  auto* next = new QPushButton(tr("Ne&xt seed"));
  next->setObjectName(QStringLiteral("next_seed"));
  next->setToolTip(tr("The same world with other random numbers"));
  buttons->addWidget(again);
  buttons->addWidget(next);
  buttons->addStretch(1);
  column()->addLayout(buttons);
  setFocusProxy(again);
  connect(again, &QPushButton::clicked, this, &RunCard::again_wished);
  connect(next, &QPushButton::clicked, this, &RunCard::next_wished);
  connect(copy, &QToolButton::clicked, this, [this] {
    QApplication::clipboard()->setText(hash_->text());
    Q_EMIT said(tr("Copied: %1").arg(hash_->text()));
  });
}

void RunCard::show_end(const Json& end) {
  const QString outcome = text_of(end, "outcome");
  const QStringList why = why_failed(end);
  title_->setText(sign_of(outcome) + outcome_words(end));
  why_->setText(why.join(QLatin1Char('\n')));
  why_->setVisible(!why.isEmpty());
  const Json& measures = member(end, "measures");
  const auto show = [&](QLabel* value, const char* name, const QString& text) {
    const bool is_known = std::isfinite(number_of(measures, name));
    value->setText(is_known ? text : QString());
    value->setVisible(is_known);
    facts_->labelForField(value)->setVisible(is_known);
  };
  const auto count = [&](const char* name) { return number_text(number_of(measures, name)); };
  show(collected_, "collected", count("collected"));
  show(distance_, "path_length_m", tr("%1 m").arg(number_of(measures, "path_length_m"), 0, 'f', 2));
  show(collisions_, "collisions", count("collisions"));
  seed_->setText(written(member(end, "seed")));
  hash_->setText(text_of(end, "state_hash"));
  set_band(band_of(outcome, palette()));
  setAccessibleName(tr("The end of the run: %1").arg(outcome_words(end)));
  setAccessibleDescription(
      (why + QStringList{tr("Collected: %1, distance: %2, collisions: %3, state hash: %4")
                             .arg(collected_->text(), distance_->text(), collisions_->text(),
                                  hash_->text())})
          .join(QLatin1Char(' ')));
  open();
}

StuckNotice::StuckNotice(QWidget* parent)
    : Card(Corner::top_left, parent), text_(wrapped("stuck_text")), select_(new QPushButton) {
  setObjectName(QStringLiteral("stuck_notice"));
  select_->setObjectName(QStringLiteral("stuck_select"));
  select_->setToolTip(tr("Selects the robot, so that the windows show its behaviours"));
  column()->addWidget(text_);
  column()->addWidget(select_, 0, Qt::AlignLeft);
  setFocusProxy(select_);
  connect(select_, &QPushButton::clicked, this, [this] { Q_EMIT robot_wished(robot_); });
}

void StuckNotice::clear() {
  stuck_ = Json::array();
  known_.clear();
  hide();
}

void StuckNotice::take(const Json& event) {
  Json stuck = Json::array();
  QStringList known;
  const int awaited = integer_of(event, "awaited_count", 0);
  bool has_trouble = false;
  int idle = 0;
  for (const Json& robot : member(event, "stuck")) {  // those that are awaited before others
    has_trouble = has_trouble || is_trouble(robot);
    if (is_trouble(robot) || ++idle <= awaited) {
      stuck.push_back(robot);
      known << text_of(robot, "robot") + QLatin1Char(' ') + written(member(robot, "behaviors"));
    }
  }
  stuck_ = std::move(stuck);
  count_ = integer_of(event, "troubled_count", 0) + awaited;
  if (stuck_.empty()) {
    clear();
    return;
  }
  set_band(has_trouble ? QColor(0xd9901a) : palette().color(QPalette::Mid));
  robot_ = text_of(stuck_.front(), "robot");
  second_ = static_cast<int>(number_of(event, "time_s"));
  show_text();
  if (std::exchange(known_, known) != known) {
    open();
  }
}

void StuckNotice::show_time(double time_s) {
  if (!isHidden() && static_cast<int>(time_s) != second_) {
    second_ = static_cast<int>(time_s);
    show_text();
  }
}

void StuckNotice::show_text() {
  QStringList sentences;
  for (std::size_t i = 0; i < stuck_.size() && i < kMostRobots; ++i) {
    sentences << why_stuck(stuck_[i], second_);
  }
  if (const int more = count_ - static_cast<int>(kMostRobots); more > 0) {
    sentences << tr("Other robots: %1.").arg(more);
  }
  text_->setText(sentences.join(QLatin1Char('\n')));
  select_->setText(tr("Select %1").arg(robot_));
  setAccessibleName(text_->text());
  settle();
}

}  // namespace elsie::desktop
