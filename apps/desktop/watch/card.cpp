#include "watch/card.h"

#include <QAccessible>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace elsie::desktop {
namespace {

constexpr double kRound_em = 0.5;
constexpr double kBand_em = 0.4;

}  // namespace

Card::Card(Corner corner, QWidget* parent)
    : QFrame(parent), corner_(corner), column_(new QVBoxLayout) {
  setFocusPolicy(Qt::StrongFocus);
  setAutoFillBackground(false);
  setCursor(Qt::ArrowCursor);  // not that of the view
  auto* row = new QHBoxLayout(this);
  const int em = fontMetrics().height();
  row->setContentsMargins(em, em / 2, em / 2, em / 2);
  row->addLayout(column_, 1);
  auto* close = new QToolButton;
  close->setObjectName(QStringLiteral("close_card"));
  close->setIcon(style()->standardIcon(QStyle::SP_TitleBarCloseButton));
  close->setAutoRaise(true);
  close->setToolTip(tr("Close (Esc)"));
  close->setAccessibleName(tr("Close"));
  row->addWidget(close, 0, Qt::AlignTop);
  connect(close, &QToolButton::clicked, this, &Card::close_by_user);
  parent->installEventFilter(this);
  hide();
}

void Card::set_band(const QColor& colour) {
  band_ = colour;
  update();
}

void Card::open() {
  settle();
  show();
  raise();
  QAccessibleEvent alert(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

// As wide as its contents like, but no wider than half of the view unless they would be cut off,
// and high enough for them.
void Card::settle() {
  // Layouts do not hear of changes of what has never been shown.
  for (QLayout* each : findChildren<QLayout*>()) each->invalidate();
  const int margin = fontMetrics().height() / 2;
  const QSize room = parentWidget()->size() - QSize(2 * margin, 2 * margin);
  const int wished = 24 * fontMetrics().averageCharWidth() * 2;
  const int width = std::max(std::min(wished, room.width() / 2), minimumSizeHint().width());
  const int height = hasHeightForWidth() ? heightForWidth(width) : sizeHint().height();
  resize(std::min(width, room.width()), std::min(height, room.height()));
  const QPoint last(parentWidget()->width() - margin - this->width(),
                    parentWidget()->height() - margin - this->height());
  move(corner_ == Corner::top_left ? QPoint(margin, margin) : last);
}

void Card::close_by_user() {
  const bool had_focus = isAncestorOf(window()->focusWidget()) || hasFocus();
  hide();
  if (had_focus) parentWidget()->setFocus();
  Q_EMIT closed();
}

bool Card::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parent() && event->type() == QEvent::Resize && !isHidden()) {
    settle();
  }
  return QFrame::eventFilter(watched, event);
}

void Card::keyPressEvent(QKeyEvent* event) {
  event->key() == Qt::Key_Escape ? close_by_user() : event->accept();  // not for the view below
}

void Card::mousePressEvent(QMouseEvent* event) { event->accept(); }

void Card::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double em = fontMetrics().height();
  QColor back = palette().color(QPalette::Window);
  back.setAlphaF(0.95F);
  QColor rim = palette().color(hasFocus() ? QPalette::Highlight : QPalette::Mid);
  painter.setPen(QPen(rim, hasFocus() ? 2.0 : 1.0));
  painter.setBrush(back);
  const QRectF all = QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0);
  painter.drawRoundedRect(all, kRound_em * em, kRound_em * em);
  if (band_.isValid()) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(band_);
    painter.setClipRect(QRectF(all.left(), all.top(), kBand_em * em, all.height()));
    painter.drawRoundedRect(all, kRound_em * em, kRound_em * em);
  }
}

}  // namespace elsie::desktop
