#include "watch/coordination_panel.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "look/theme.h"
#include "paint/axes.h"
#include "watch/state.h"

namespace elsie::desktop {

struct CoordinationPanel::Row {
  QString path;
  QString name;
  QString reason;
  QString inhibited_by;
  int depth = 0;
  int parent = -1;
  double activation = 0.0;
  double priority = 0.0;  // as the world sets it
  double weight = 0.0;    // what the coordinator made of it
  double share = 0.0;
  int percent = 0;  // the share; those of a decision add up to 100
  bool asked = false;
  QString command;
};

namespace {

constexpr double kSpan = 30.0;  // s on the time axis
constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
constexpr const char* kCommand[] = {"command/forward", "command/lateral", "command/turn"};

QString command_text(const std::vector<double>& parts) {
  QStringList texts;
  for (const double part : parts) {
    texts << number_text(part);
  }
  return texts.join(QStringLiteral(", "));
}

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
  now_s_ = 0.0;
  looked_back_to_s_.reset();
  then_.reset();
  lay_out();
}

void CoordinationPanel::set_samples(const Samples& samples) {
  samples_ = &samples;
  viewport()->update();
}

void CoordinationPanel::look_back(std::optional<double> time_s) {
  if (looked_back_to_s_ == time_s) return;
  if (time_s) {  // the bands stay as they are as long as they show the time
    const Bands before = bands();
    start_s_ = std::clamp(before.start_s, std::max(0.0, *time_s - before.length_s), *time_s);
  }
  looked_back_to_s_ = time_s;
  viewport()->update();
}

void CoordinationPanel::set_look(const Instant* then) {
  then_ = then ? std::optional(*then) : std::nullopt;
  viewport()->update();
}

void CoordinationPanel::add(const Json& state) {
  const Json& robot = robot_of(state, robot_);
  const double time = number_of(state, "time_s");
  if (robot.is_null() || !robot.contains("members") || !std::isfinite(time)) {
    return;
  }
  const Json& members = member(robot, "members");
  rows_.clear();
  for (const Json& one : members) {
    Row& row = rows_.emplace_back();
    row.path = text_of(one, "path");
    row.name = row.path.section(u'/', -1);
    row.reason = text_of(one, "reason");
    row.depth = integer_of(one, "depth", 0);
    row.parent = integer_of(one, "parent", -1);
    row.activation = number_of(one, "activation");
    row.priority = number_of(one, "priority");
    row.weight = number_of(one, "weight");
    row.share = number_of(one, "share");
    row.asked = member(one, "asked") == true;
    const double inhibitor = number_of(one, "inhibited_by");
    if (inhibitor >= 0.0 && inhibitor < static_cast<double>(members.size())) {
      row.inhibited_by = text_of(members[static_cast<std::size_t>(inhibitor)], "path");
    }
    std::vector<double> command;
    for (const Json& value : member(one, "command")) {
      command.push_back(value.is_number() ? value.get<double>() : kMissing);
    }
    row.command = command_text(command);
  }
  set_percents(rows_);
  now_s_ = time;
  lay_out();
}

void CoordinationPanel::set_percents(std::vector<Row>& rows) {
  std::map<int, std::vector<std::size_t>> decisions;  // by the behaviour around the members
  for (std::size_t i = 0; i < rows.size(); ++i) {
    decisions[rows[i].parent].push_back(i);
  }
  for (const auto& [parent, members] : decisions) {
    std::vector<double> shares;
    for (const std::size_t i : members) {
      shares.push_back(rows[i].asked ? rows[i].share : 0.0);
    }
    const std::vector<int> percents = whole_percents(shares);
    for (std::size_t i = 0; i < members.size(); ++i) {
      rows[members[i]].percent = percents[i];
    }
  }
}

QString CoordinationPanel::number_of_row(const Row& row, const char* name) const {
  return robot_ + u'/' + row.path + u'/' + QLatin1String(name);
}

QStringList CoordinationPanel::numbers(bool looks_back) const {
  QStringList names;
  for (const Row& row : rows_) {
    for (const char* name : {"asked", "share"}) {
      names << number_of_row(row, name);
    }
    if (looks_back) {
      for (const char* name : {"priority", "activation", "weight"}) {
        names << number_of_row(row, name);
      }
      for (const char* name : kCommand) {
        names << number_of_row(row, name);
      }
    }
  }
  return names;
}

std::vector<CoordinationPanel::Row> CoordinationPanel::shown_rows() const {
  std::vector<Row> rows = rows_;
  if (!looked_back_to_s_ || !samples_) {
    return rows;
  }
  for (Row& row : rows) {
    const auto then = [&](const char* name) -> double {
      return samples_->at(number_of_row(row, name), *looked_back_to_s_);
    };
    row.asked = then("asked") > 0.0;
    row.priority = then("priority");
    row.activation = then("activation");
    row.weight = then("weight");
    row.share = then("share");
    row.command = command_text({then(kCommand[0]), then(kCommand[1]), then(kCommand[2])});
    row.inhibited_by.clear();
    row.reason = row.asked ? reason_then(row.path) : QString();
  }
  set_percents(rows);
  return rows;
}

QString CoordinationPanel::reason_then(const QString& path) const {
  const Json& reasons = then_ ? member(robot_of(then_->look, robot_), "reasons") : Json();
  return reasons.is_object() ? text_of(reasons, path.toUtf8().constData())
         : then_             ? tr("the reason is not stored")
                             : QString();
}

Figures CoordinationPanel::figures() const {
  Figures figures{{tr("behaviour"), tr("activation"), tr("weight"), tr("share [%]"),
                   tr("command [m/s, m/s, rad/s]"), tr("inhibited by"), tr("reason")},
                  {}};
  for (const Row& row : shown_rows()) {
    figures.rows.push_back({row.path, number_text(row.activation), number_text(row.weight),
                            row.asked ? QString::number(row.percent) : tr("not asked"), row.command,
                            row.inhibited_by, row.reason});
  }
  return figures;
}

int CoordinationPanel::rows() const { return static_cast<int>(rows_.size()); }

QString CoordinationPanel::row_text(int index) const {
  const Row row = shown_rows().at(static_cast<std::size_t>(index));
  QString text = row.asked
                     ? tr("%1: activation %2, weight %3, share %4 %")
                           .arg(row.path, number_text(row.activation), number_text(row.weight))
                           .arg(row.percent)
                     : tr("%1: not asked").arg(row.path);
  text += row.asked ? tr("\ncommand (forward m/s, lateral m/s, turn rad/s): %1").arg(row.command)
                    : tr("\npriority in the world: %1").arg(number_text(row.priority));
  if (!row.inhibited_by.isEmpty()) {
    text += tr("\ninhibited by %1").arg(row.inhibited_by);
  }
  return row.reason.isEmpty() ? text : text + QStringLiteral("\n") + row.reason;
}

double CoordinationPanel::share_at(int row, double time_s) const {
  const Row& of = rows_.at(static_cast<std::size_t>(row));
  return samples_ && samples_->at(number_of_row(of, "asked"), time_s) > 0.0F
             ? samples_->at(number_of_row(of, "share"), time_s)
             : kMissing;
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

/// The lane goes from the start to the end. A share holds until the next sample.
void CoordinationPanel::paint_band(QPainter& painter, const QRectF& lane, int row, double start_s,
                                   double end_s) const {
  const Row& of = rows_[static_cast<std::size_t>(row)];
  const std::vector<float>* const asked =
      samples_ ? samples_->curve(number_of_row(of, "asked")) : nullptr;
  const std::vector<float>* const shares =
      samples_ ? samples_->curve(number_of_row(of, "share")) : nullptr;
  if (!asked || !shares || !(end_s > start_s)) {
    return;
  }
  QColor grey = palette().color(QPalette::Text);
  grey.setAlphaF(0.10F);
  const std::vector<double>& times = samples_->times();
  const auto x_of = [&](double time_s) {
    return lane.left() + (std::max(time_s, start_s) - start_s) / (end_s - start_s) * lane.width();
  };
  const std::size_t all = samples_->count_until(end_s);
  const std::size_t before = samples_->count_until(start_s);
  const double period_s = all > 1 ? times[all - 1] - times[all - 2] : 0.0;
  for (std::size_t i = before - std::min<std::size_t>(1, before), next = i; i < all; i = next) {
    // One rectangle for a stretch of the same share.
    for (next = i + 1;
         next < all && (*asked)[next] == (*asked)[i] && (*shares)[next] == (*shares)[i]; ++next) {
    }
    const double from = x_of(times[i]);
    const double until_s = next < all ? times[next] : times[all - 1] + period_s;
    const double width = x_of(std::min(until_s, end_s)) - from;
    if ((*asked)[i] > 0.0F) {
      const double high = std::clamp(static_cast<double>((*shares)[i]), 0.0, 1.0) * lane.height();
      const QRectF part(from, lane.center().y() - high / 2, width, high);
      painter.fillRect(part, curve_colour(row, palette()));
      painter.fillRect(part, QBrush(palette().color(QPalette::Base), hatch(row)));
    } else if ((*asked)[i] == 0.0F) {
      painter.fillRect(QRectF(from, lane.top(), width, lane.height()), grey);
    }
  }
}

int CoordinationPanel::names_width() const {
  const QFontMetrics font = fontMetrics();
  const int em = font.horizontalAdvance(u'm');
  int width = em * 8;
  for (const Row& row : rows_) {
    width = std::max(width, font.horizontalAdvance(row.name) + (2 * row.depth + 2) * em);
  }
  return std::min(width, viewport()->width() / 3);
}

int CoordinationPanel::figures_width() const {
  return std::min(fontMetrics().horizontalAdvance(u'm') * 42, viewport()->width() / 2);
}

/// The latest time that the bands can show, s.
double CoordinationPanel::latest_s() const {
  const bool has_past = looked_back_to_s_ && samples_ && !samples_->times().empty();
  return has_past ? std::max(now_s_, samples_->times().back()) : now_s_;
}

CoordinationPanel::Bands CoordinationPanel::bands() const {
  const int em = fontMetrics().horizontalAdvance(u'm');
  Bands bands;
  bands.left = names_width();
  bands.width = std::max(1, viewport()->width() - bands.left - figures_width() - em);
  const double latest = latest_s(), first = std::max(0.0, latest - kSpan);
  bands.start_s = looked_back_to_s_ ? std::min(start_s_, first) : first;
  bands.length_s = std::max(std::min(latest, kSpan), 1.0);
  return bands;
}

std::optional<double> CoordinationPanel::place_of(double time_s) const {
  const Bands where = bands();
  const double x = where.x_of(time_s);
  return x >= where.left && x <= where.left + where.width ? std::optional(x) : std::nullopt;
}

void CoordinationPanel::mousePressEvent(QMouseEvent* event) {
  const Bands where = bands();
  const double x = event->position().x();
  is_dragged_ = event->button() == Qt::LeftButton && !rows_.empty() && x >= where.left &&
                x <= where.left + where.width;
  if (is_dragged_) mouseMoveEvent(event);
}

void CoordinationPanel::mouseMoveEvent(QMouseEvent* event) {
  if (is_dragged_) {
    const Bands where = bands();
    const double x = std::clamp(event->position().x(), static_cast<double>(where.left),
                                static_cast<double>(where.left + where.width));
    Q_EMIT time_wished(std::min(where.time_at(x), latest_s()));
  }
}

void CoordinationPanel::mouseReleaseEvent(QMouseEvent*) { is_dragged_ = false; }

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
  const std::vector<Row> shown = shown_rows();
  const Bands where = bands();
  const int names = where.left, figures = figures_width(), right = where.left + where.width;
  const double end = std::min(where.start_s + where.length_s, latest_s());
  const int axis = viewport()->height() - line * 3 / 2;

  painter.setClipRect(0, 0, viewport()->width(), axis);
  for (int n = 0; n < rows(); ++n) {
    const Row& row = shown[static_cast<std::size_t>(n)];
    const int top = n * row_height() - verticalScrollBar()->value();
    const QColor colour = curve_colour(n, palette());
    QColor grey = ink;
    grey.setAlphaF(0.10F);

    painter.setPen(row.asked ? ink : palette().color(QPalette::PlaceholderText));
    const int indent = em / 2 + row.depth * 2 * em;
    painter.drawText(QRect(indent, top, names - indent, row_height()), Qt::AlignVCenter,
                     font.elidedText(row.name, Qt::ElideMiddle, names - indent));
    paint_band(painter, QRectF(names, top + 3, where.x_of(end) - names, row_height() - 6), n,
               where.start_s, end);
    painter.setPen(grey);
    painter.drawLine(0, top + row_height() - 1, viewport()->width(), top + row_height() - 1);

    const QRect text(right + em, top, figures - em / 2, row_height());
    const int lines = row.reason.isEmpty() ? 1 : 2;  // in the middle of the row
    const int first = top + (row_height() - lines * line) / 2;
    const QRectF bar(text.left(), first + 2, em * 4, line - 4);
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
        (row.asked ? tr("weight %1  share %2 %  (%3)")
                         .arg(number_text(row.weight))
                         .arg(row.percent)
                         .arg(row.command)
                   : tr("priority %1  not asked").arg(number_text(row.priority)));
    const int beside = em * 5;
    const QRect words(text.left() + beside, first, text.width() - beside, line);
    painter.drawText(words, Qt::AlignVCenter,
                     font.elidedText(numbers, Qt::ElideRight, words.width()));
    painter.setPen(quiet(palette()));
    painter.drawText(words.translated(0, line), Qt::AlignVCenter,
                     font.elidedText(row.reason, Qt::ElideRight, words.width()));
  }
  painter.setClipping(false);
  painter.setPen(ink);
  painter.drawLine(names, axis, right, axis);
  painter.drawText(QRect(right + em, axis + 3, figures - em / 2, line + 2), Qt::AlignRight,
                   font.elidedText(tr("command: forward, lateral [m/s], turn [rad/s]"),
                                   Qt::ElideRight, figures - em / 2));
  for (const double tick : ticks({where.start_s, where.start_s + where.length_s},
                                 std::max(2, where.width / (line * 4)))) {
    const int x = static_cast<int>(where.x_of(tick));
    painter.drawLine(x, axis, x, axis + 3);
    painter.drawText(QRect(x - line * 3, axis + 3, line * 6, line + 2), Qt::AlignHCenter,
                     tr("%1 s").arg(number_text(tick)));
  }
  paint_cursor(painter, where, axis);
}

/// The line of the shown time, and the time.
void CoordinationPanel::paint_cursor(QPainter& painter, const Bands& bands, int axis) const {
  if (!looked_back_to_s_) return;
  const int x = static_cast<int>(std::lround(bands.x_of(*looked_back_to_s_)));
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
  painter.drawLine(x, 0, x, axis);
}

}  // namespace elsie::desktop
