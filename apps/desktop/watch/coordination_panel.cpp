#include "watch/coordination_panel.h"

#include <QHelpEvent>
#include <QPainter>
#include <QScrollBar>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "paint/axes.h"
#include "watch/state.h"

namespace elsie::desktop {

struct CoordinationPanel::Row {
  QString path;
  QString name;
  QString reason;
  QString inhibited_by;
  int depth = 0;
  double activation = 0.0;
  double priority = 0.0;
  double share = 0.0;
  bool asked = false;
  QString command;
};

namespace {

constexpr double kSpan = 30.0;          // s on the time axis
constexpr std::size_t kMost = 30 * 60;  // instants kept

}  // namespace

CoordinationPanel::CoordinationPanel(QWidget* parent) : QAbstractScrollArea(parent) {
  setObjectName(QStringLiteral("coordination"));
  setAccessibleName(tr("Coordination"));
  viewport()->setBackgroundRole(QPalette::Base);
  offer_figures(this);
}

CoordinationPanel::~CoordinationPanel() = default;

void CoordinationPanel::set_robot(const QString& id) {
  if (id != robot_) {
    robot_ = id;
    clear();
  }
}

void CoordinationPanel::clear() {
  rows_.clear();
  past_.clear();
  lay_out();
}

void CoordinationPanel::add(const Json& state) {
  const Json& robot = robot_of(state, robot_);
  const double time = number_of(state, "time_s");
  if (robot.is_null() || !robot.contains("members") || !std::isfinite(time)) {
    return;
  }
  const Json& members = member(robot, "members");
  std::vector<Row> rows;
  Instant now{time, {}};
  for (const Json& one : members) {
    Row row;
    row.path = text_of(one, "path");
    row.name = row.path.section(u'/', -1);
    row.reason = text_of(one, "reason");
    const Json& depth = member(one, "depth");
    row.depth = depth.is_number() ? depth.get<int>() : 0;
    row.activation = number_of(one, "activation");
    row.priority = number_of(one, "priority");
    row.share = number_of(one, "share");
    row.asked = member(one, "asked").is_boolean() && member(one, "asked").get<bool>();
    const double inhibitor = number_of(one, "inhibited_by");
    if (inhibitor >= 0.0 && inhibitor < static_cast<double>(members.size())) {
      row.inhibited_by = text_of(members[static_cast<std::size_t>(inhibitor)], "path");
    }
    QStringList command;
    for (const Json& value : member(one, "command")) {
      command << (value.is_number() ? number_text(value.get<double>()) : QStringLiteral("-"));
    }
    row.command = command.join(QStringLiteral(", "));
    now.shares.push_back(row.asked ? static_cast<float>(row.share)
                                   : std::numeric_limits<float>::quiet_NaN());
    rows.push_back(std::move(row));
  }
  const bool same_rows = std::equal(rows.begin(), rows.end(), rows_.begin(), rows_.end(),
                                    [](const Row& a, const Row& b) { return a.path == b.path; });
  if (!same_rows || (!past_.empty() && time < past_.back().time_s)) {
    past_.clear();
  }
  rows_ = std::move(rows);
  if (!past_.empty() && past_.back().time_s == time) {
    past_.back() = std::move(now);
  } else {
    past_.push_back(std::move(now));
  }
  while (past_.size() > kMost || past_.front().time_s < time - kSpan) {
    past_.pop_front();
  }
  lay_out();
}

Figures CoordinationPanel::figures() const {
  Figures figures{{tr("behaviour"), tr("activation"), tr("priority"), tr("share [%]"),
                   tr("command [m/s, m/s, rad/s]"), tr("inhibited by"), tr("reason")},
                  {}};
  for (const Row& row : rows_) {
    figures.rows.push_back({row.path, number_text(row.activation), number_text(row.priority),
                            row.asked ? number_text(100.0 * row.share) : tr("not asked"),
                            row.command, row.inhibited_by, row.reason});
  }
  return figures;
}

int CoordinationPanel::rows() const { return static_cast<int>(rows_.size()); }

QString CoordinationPanel::row_text(int index) const {
  const Row& row = rows_.at(static_cast<std::size_t>(index));
  QString text = tr("%1: activation %2, priority %3, share %4 %")
                     .arg(row.path, number_text(row.activation), number_text(row.priority),
                          number_text(100.0 * row.share));
  text += row.asked ? tr("\ncommand (forward m/s, lateral m/s, turn rad/s): %1").arg(row.command)
                    : tr("\nnot asked");
  if (!row.inhibited_by.isEmpty()) {
    text += tr("\ninhibited by %1").arg(row.inhibited_by);
  }
  return row.reason.isEmpty() ? text : text + QStringLiteral("\n") + row.reason;
}

double CoordinationPanel::share_at(int row, double time_s) const {
  const auto after = std::upper_bound(past_.begin(), past_.end(), time_s,
                                      [](double t, const Instant& i) { return t < i.time_s; });
  return after == past_.begin() ? std::numeric_limits<double>::quiet_NaN()
                                : std::prev(after)->shares.at(static_cast<std::size_t>(row));
}

int CoordinationPanel::row_height() const { return fontMetrics().height() * 5 / 2; }

void CoordinationPanel::lay_out() {
  const int all = row_height() * rows() + fontMetrics().height() * 2;
  verticalScrollBar()->setRange(0, std::max(0, all - viewport()->height()));
  verticalScrollBar()->setPageStep(viewport()->height());
  verticalScrollBar()->setSingleStep(row_height());
  viewport()->update();
}

void CoordinationPanel::resizeEvent(QResizeEvent* event) {
  QAbstractScrollArea::resizeEvent(event);
  lay_out();
}

bool CoordinationPanel::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const int row = (help->pos().y() + verticalScrollBar()->value()) / row_height();
    QToolTip::showText(help->globalPos(), row < rows() ? row_text(row) : QString(), this);
    return true;
  }
  return QAbstractScrollArea::viewportEvent(event);
}

void CoordinationPanel::paintEvent(QPaintEvent*) {
  QPainter painter(viewport());
  const QFontMetrics font = fontMetrics();
  const int line = font.height();
  const int em = font.horizontalAdvance(u'm');
  const QColor ink = palette().color(QPalette::Text);
  if (rows_.empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(viewport()->rect(), Qt::AlignCenter | Qt::TextWordWrap,
                     robot_.isEmpty()
                         ? tr("Select a robot to see which behaviour decides")
                         : tr("Nothing from %1 yet: this panel is updated only while it is visible")
                               .arg(robot_));
    return;
  }
  int names = em * 8;
  for (const Row& row : rows_) {
    names = std::max(names, font.horizontalAdvance(row.name) + (2 * row.depth + 2) * em);
  }
  names = std::min(names, viewport()->width() / 3);
  const int figures = std::min(em * 42, viewport()->width() / 2);
  const QRect bands(names, 0, viewport()->width() - names - figures - em, viewport()->height());
  const double end = past_.back().time_s;
  const double start = std::max(0.0, end - kSpan);
  const double length = std::max(end - start, 1.0);
  const auto x_of = [&](double t) { return bands.left() + (t - start) / length * bands.width(); };
  const int axis = viewport()->height() - line * 3 / 2;

  painter.setClipRect(0, 0, viewport()->width(), axis);
  for (int n = 0; n < rows(); ++n) {
    const Row& row = rows_[static_cast<std::size_t>(n)];
    const int top = n * row_height() - verticalScrollBar()->value();
    const QRect lane(bands.left(), top + 3, bands.width(), row_height() - 6);
    const QColor colour = curve_colour(n, palette());
    QColor grey = ink;
    grey.setAlphaF(0.10F);

    painter.setPen(row.asked ? ink : palette().color(QPalette::PlaceholderText));
    const int indent = em / 2 + row.depth * 2 * em;
    painter.drawText(QRect(indent, top, names - indent, row_height()), Qt::AlignVCenter,
                     font.elidedText(row.name, Qt::ElideMiddle, names - indent));
    for (std::size_t i = 0; i < past_.size(); ++i) {
      const float share = past_[i].shares[static_cast<std::size_t>(n)];
      std::size_t last = i;  // one rectangle for a stretch of the same share
      while (last + 1 < past_.size()) {
        const float next = past_[last + 1].shares[static_cast<std::size_t>(n)];
        if (next != share && !(std::isnan(next) && std::isnan(share))) {
          break;
        }
        ++last;
      }
      const double from = x_of(past_[i].time_s);
      const double to = x_of(last + 1 < past_.size() ? past_[last + 1].time_s : end);
      if (std::isnan(share)) {
        painter.fillRect(QRectF(from, lane.top(), to - from, lane.height()), grey);
      } else {
        const double high = std::clamp(static_cast<double>(share), 0.0, 1.0) * lane.height();
        const QRectF part(from, lane.center().y() - high / 2, to - from, high);
        painter.fillRect(part, colour);
        painter.fillRect(part, QBrush(palette().color(QPalette::Base), hatch(n)));
      }
      i = last;
    }
    painter.setPen(grey);
    painter.drawLine(0, top + row_height() - 1, viewport()->width(), top + row_height() - 1);

    const QRect text(bands.right() + em, top, figures - em / 2, row_height());
    const QRectF bar(text.left(), text.top() + 4, em * 4, line - 4);
    painter.fillRect(
        QRectF(bar.topLeft(),
               QSizeF(bar.width() * (row.activation > 0.0 ? std::min(row.activation, 1.0) : 0.0),
                      bar.height())),
        row.asked ? colour : grey);
    painter.setPen(ink);
    painter.drawRect(bar);
    const QString activation = tr("activation %1  ")  // the bar is this
                                   .arg(number_text(std::round(100.0 * row.activation) / 100.0));
    const QString numbers =
        (row.asked ? activation : QString()) +
        (row.asked ? tr("priority %1  share %2 %  (%3)")
                         .arg(number_text(row.priority), number_text(std::round(100.0 * row.share)),
                              row.command)
                   : tr("priority %1  not asked").arg(number_text(row.priority)));
    const int beside = em * 5;
    painter.drawText(text.adjusted(beside, 1, 0, 0), Qt::AlignTop,
                     font.elidedText(numbers, Qt::ElideRight, text.width() - beside));
    painter.drawText(text.adjusted(0, 0, 0, -2), Qt::AlignBottom,
                     font.elidedText(row.reason, Qt::ElideRight, text.width()));
  }
  painter.setClipping(false);
  painter.setPen(ink);
  painter.drawLine(bands.left(), axis, bands.right(), axis);
  painter.drawText(QRect(bands.right() + em, axis + 3, figures - em / 2, line + 2), Qt::AlignRight,
                   font.elidedText(tr("command: forward, lateral [m/s], turn [rad/s]"),
                                   Qt::ElideRight, figures - em / 2));
  for (const double tick :
       ticks({start, start + length}, std::max(2, bands.width() / (line * 4)))) {
    const int x = static_cast<int>(x_of(tick));
    painter.drawLine(x, axis, x, axis + 3);
    painter.drawText(QRect(x - line * 3, axis + 3, line * 6, line + 2), Qt::AlignHCenter,
                     tr("%1 s").arg(number_text(tick)));
  }
}

}  // namespace elsie::desktop
