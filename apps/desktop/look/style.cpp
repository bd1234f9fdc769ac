#include "look/style.h"

#include <QDockWidget>
#include <QPainter>
#include <QScrollBar>
#include <QStyleFactory>
#include <QStyleOption>
#include <algorithm>

#include "look/icons.h"
#include "look/theme.h"

namespace elsie::desktop {
namespace {

constexpr double kRound = 4.0;  // px, of corners
constexpr int kTrack = 12;      // px, of scroll bars
constexpr int kShortest = 24;   // px, of their handles

QColor mixed(const QColor& a, const QColor& b, double part) {
  const auto mix = [part](float x, float y) { return x + static_cast<float>(part) * (y - x); };
  return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()),
                          mix(a.blueF(), b.blueF()));
}

/// A surface with a thin rim.
void draw_plate(QPainter* painter, const QRect& rect, const QColor& fill, const QColor& rim) {
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(rim.alpha() > 0 ? QPen(rim, 1.0) : QPen(Qt::NoPen));
  painter->setBrush(fill);
  painter->drawRoundedRect(QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5), kRound, kRound);
  painter->restore();
}

/// A button is raised by a rim, and lit under the pointer.
void draw_button(QPainter* painter, const QStyleOption& option, bool is_raised, bool is_default) {
  const QPalette& palette = option.palette;
  const bool is_on = option.state & QStyle::State_Enabled;
  const bool is_down = option.state & (QStyle::State_Sunken | QStyle::State_On);
  const bool is_under = is_on && (option.state & QStyle::State_MouseOver);
  const QColor ink = palette.color(QPalette::ButtonText);
  const QColor base = is_raised ? palette.color(QPalette::Button) : palette.color(QPalette::Window);
  if (!is_raised && !is_down && !is_under) {
    return;
  }
  const bool has_focus = option.state & QStyle::State_HasFocus;
  const QColor rim = !is_raised ? QColor(Qt::transparent)
                     : is_default || has_focus
                         ? palette.color(QPalette::Highlight)
                         : mixed(line_colour(palette), ink, is_on ? 0.15 : 0.0);
  draw_plate(painter, option.rect, mixed(base, ink, is_down ? 0.16 : is_under ? 0.07 : 0.0), rim);
}

/// The handle of a scroll bar; the whole groove if there is nothing to scroll.
QRect handle_of(const QStyleOptionSlider& bar) {
  const bool is_flat = bar.orientation == Qt::Horizontal;
  const int room = is_flat ? bar.rect.width() : bar.rect.height();
  const int range = bar.maximum - bar.minimum;
  if (range <= 0) {
    return bar.rect;
  }
  const int length =
      std::clamp(static_cast<int>(double(room) * bar.pageStep / (double(range) + bar.pageStep)),
                 std::min(kShortest, room), room);
  const int at = QStyle::sliderPositionFromValue(bar.minimum, bar.maximum, bar.sliderPosition,
                                                 room - length, bar.upsideDown);
  return is_flat ? QRect(bar.rect.x() + at, bar.rect.y(), length, bar.rect.height())
                 : QRect(bar.rect.x(), bar.rect.y() + at, bar.rect.width(), length);
}

void draw_tab(QPainter* painter, const QStyleOptionTab& tab) {
  const QPalette& palette = tab.palette;
  const bool is_chosen = tab.state & QStyle::State_Selected;
  const bool is_under = tab.state & QStyle::State_MouseOver;
  const bool is_above = tab.shape == QTabBar::RoundedNorth || tab.shape == QTabBar::TriangularNorth;
  painter->save();
  if (is_chosen || is_under) {
    painter->fillRect(tab.rect, mixed(palette.color(QPalette::Window),
                                      palette.color(QPalette::Base), is_chosen ? 1.0 : 0.5));
  }
  if (is_chosen) {
    QRect mark = tab.rect;
    is_above ? mark.setTop(mark.bottom() - 1) : mark.setBottom(mark.top() + 1);
    painter->fillRect(mark, palette.color(QPalette::Highlight));
  }
  painter->restore();
}

void draw_dock_title(QPainter* painter, const QStyleOptionDockWidget& title, const QRect& text) {
  painter->save();
  QFont font = painter->font();
  font.setWeight(QFont::DemiBold);
  painter->setFont(font);
  painter->setPen(title.palette.color(QPalette::WindowText));
  const QRect room = text.adjusted(4, 0, -2, 0);
  painter->drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                    painter->fontMetrics().elidedText(title.title, Qt::ElideRight, room.width()));
  painter->restore();
}

/// A check box or the circle of a choice: a rim that is seen on dark windows, too, and a mark.
void draw_mark(QPainter* painter, const QStyleOption& option, bool is_round) {
  const QPalette& palette = option.palette;
  const bool is_on = option.state & QStyle::State_Enabled;
  const bool is_marked = option.state & (QStyle::State_On | QStyle::State_NoChange);
  const double side = std::min(option.rect.width(), option.rect.height()) - 1.0;
  QRectF box(0.0, 0.0, side, side);
  box.moveCenter(QRectF(option.rect).center());
  const QColor ink = palette.color(is_on ? QPalette::Active : QPalette::Disabled, QPalette::Text);
  const QColor accent = palette.color(QPalette::Highlight);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(option.state & QStyle::State_HasFocus || is_marked
                      ? accent
                      : mixed(palette.color(QPalette::Base), ink, 0.55));
  painter->setBrush(is_marked ? accent : palette.color(QPalette::Base));
  const double round = is_round ? 0.5 * side : 0.2 * side;
  painter->drawRoundedRect(box, round, round);
  const auto at = [&](double x, double y) {
    return QPointF(box.left() + x * side, box.top() + y * side);
  };
  const QColor sign = palette.color(QPalette::HighlightedText);
  if (is_marked && is_round) {
    painter->setPen(Qt::NoPen);
    painter->setBrush(sign);
    painter->drawEllipse(box.center(), 0.22 * side, 0.22 * side);
  } else if (is_marked) {
    painter->setPen(QPen(sign, std::max(1.5, 0.14 * side), Qt::SolidLine, Qt::RoundCap));
    painter->setBrush(Qt::NoBrush);
    const bool is_part = option.state & QStyle::State_NoChange;
    painter->drawPolyline(is_part ? QPolygonF{at(0.25, 0.5), at(0.75, 0.5)}
                                  : QPolygonF{at(0.22, 0.52), at(0.42, 0.72), at(0.78, 0.28)});
  }
  painter->restore();
}

}  // namespace

Style::Style() : QProxyStyle(QStyleFactory::create("Fusion")) {}

void Style::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                          const QWidget* widget) const {
  const QPalette& palette = option->palette;
  switch (element) {
    case PE_PanelButtonCommand: {
      const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
      const bool is_flat = button && (button->features & QStyleOptionButton::Flat);
      draw_button(painter, *option, !is_flat,
                  button && (button->features & QStyleOptionButton::DefaultButton));
      return;
    }
    case PE_PanelButtonTool:
    case PE_IndicatorButtonDropDown:
      draw_button(painter, *option, !(option->state & State_AutoRaise), false);
      return;
    case PE_PanelLineEdit:
      if (const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
          frame && frame->lineWidth > 0) {
        const bool has_focus = option->state & State_HasFocus;
        draw_plate(painter, option->rect, palette.color(QPalette::Base),
                   has_focus ? palette.color(QPalette::Highlight)
                             : mixed(line_colour(palette), palette.color(QPalette::Text), 0.15));
        return;
      }
      break;
    case PE_Frame:
    case PE_FrameMenu:
    case PE_FrameTabWidget:
    case PE_FrameGroupBox:
      painter->save();
      painter->setPen(line_colour(palette));
      if (element == PE_FrameMenu || element == PE_Frame) painter->setBrush(Qt::NoBrush);
      painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
      painter->restore();
      return;
    case PE_IndicatorCheckBox:
    case PE_IndicatorRadioButton:
      draw_mark(painter, *option, element == PE_IndicatorRadioButton);
      return;
    case PE_IndicatorTabClose:
      draw_button(painter, *option, false, false);
      icon("close").paint(painter, option->rect);
      return;
    case PE_IndicatorToolBarSeparator: {
      const QRect& rect = option->rect;
      const int inset = rect.height() / 5;
      painter->fillRect(QRect(rect.center().x(), rect.top() + inset, 1, rect.height() - 2 * inset),
                        line_colour(palette));
      return;
    }
    case PE_FrameStatusBarItem:
    case PE_FrameDockWidget:
    case PE_PanelStatusBar:
    case PE_FrameTabBarBase:
      return;
    case PE_IndicatorDockWidgetResizeHandle: {
      const QRect& rect = option->rect;
      painter->fillRect(rect.width() > rect.height()
                            ? QRect(rect.left(), rect.center().y(), rect.width(), 1)
                            : QRect(rect.center().x(), rect.top(), 1, rect.height()),
                        line_colour(palette));
      return;
    }
    default:
      break;
  }
  QProxyStyle::drawPrimitive(element, option, painter, widget);
}

void Style::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                        const QWidget* widget) const {
  switch (element) {
    case CE_ToolBar:
    case CE_MenuBarEmptyArea:
      painter->fillRect(option->rect, option->palette.color(QPalette::Window));
      if (element == CE_ToolBar) {
        painter->fillRect(
            QRect(option->rect.left(), option->rect.bottom(), option->rect.width(), 1),
            line_colour(option->palette));
      }
      return;
    case CE_TabBarTabShape:
      if (const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option)) {
        draw_tab(painter, *tab);
        return;
      }
      break;
    case CE_DockWidgetTitle:
      if (const auto* title = qstyleoption_cast<const QStyleOptionDockWidget*>(option)) {
        draw_dock_title(painter, *title, subElementRect(SE_DockWidgetTitleBarText, option, widget));
        return;
      }
      break;
    case CE_Splitter:
      drawPrimitive(PE_IndicatorDockWidgetResizeHandle, option, painter, widget);
      return;
    case CE_HeaderSection: {
      const QRect& rect = option->rect;
      painter->fillRect(rect, option->palette.color(QPalette::Window));
      painter->fillRect(QRect(rect.left(), rect.bottom(), rect.width(), 1),
                        line_colour(option->palette));
      return;
    }
    default:
      break;
  }
  QProxyStyle::drawControl(element, option, painter, widget);
}

void Style::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                               QPainter* painter, const QWidget* widget) const {
  const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option);
  if (control != CC_ScrollBar || !bar) {
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    return;
  }
  const QPalette& palette = bar->palette;
  painter->fillRect(bar->rect, palette.color(QPalette::Window));
  if (bar->maximum <= bar->minimum) {
    return;
  }
  const bool is_held = bar->activeSubControls & SC_ScrollBarSlider;
  const bool is_flat = bar->orientation == Qt::Horizontal;
  const QRectF handle =
      QRectF(handle_of(*bar))
          .adjusted(is_flat ? 1 : 3, is_flat ? 3 : 1, is_flat ? -1 : -3, is_flat ? -3 : -1);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(Qt::NoPen);
  painter->setBrush(mixed(palette.color(QPalette::Window), palette.color(QPalette::WindowText),
                          is_held ? 0.5 : 0.28));
  const double round = std::min(handle.width(), handle.height()) / 2.0;
  painter->drawRoundedRect(handle, round, round);
  painter->restore();
}

QRect Style::subControlRect(ComplexControl control, const QStyleOptionComplex* option,
                            SubControl part, const QWidget* widget) const {
  const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option);
  if (control != CC_ScrollBar || !bar) {
    return QProxyStyle::subControlRect(control, option, part, widget);
  }
  const QRect handle = handle_of(*bar);
  QRect rect = bar->rect;
  const bool is_flat = bar->orientation == Qt::Horizontal;
  switch (part) {
    case SC_ScrollBarSlider:
      return handle;
    case SC_ScrollBarGroove:
      return rect;
    case SC_ScrollBarSubPage:
      is_flat ? rect.setRight(handle.left() - 1) : rect.setBottom(handle.top() - 1);
      return rect;
    case SC_ScrollBarAddPage:
      is_flat ? rect.setLeft(handle.right() + 1) : rect.setTop(handle.bottom() + 1);
      return rect;
    default:
      return {};
  }
}

int Style::pixelMetric(PixelMetric metric, const QStyleOption* option,
                       const QWidget* widget) const {
  switch (metric) {
    case PM_ScrollBarExtent:
      return kTrack;
    case PM_ScrollBarSliderMin:
      return kShortest;
    case PM_ToolBarIconSize:
      return 20;
    case PM_ToolBarItemSpacing:
      return 1;
    case PM_ToolBarItemMargin:
      return 2;
    case PM_ToolBarFrameWidth:
      return 0;
    case PM_DockWidgetTitleMargin:
      return 5;
    case PM_DockWidgetTitleBarButtonMargin:
      return 2;
    case PM_DockWidgetSeparatorExtent:
    case PM_SplitterWidth:
      return 5;
    case PM_TabBarTabVSpace:
      return 10;
    case PM_TabBarTabHSpace:
      return 24;
    case PM_TabBarBaseHeight:
    case PM_TabBarBaseOverlap:
    case PM_TabBarTabShiftVertical:
    case PM_ButtonShiftHorizontal:
    case PM_ButtonShiftVertical:
      return 0;
    default:
      return QProxyStyle::pixelMetric(metric, option, widget);
  }
}

QIcon Style::standardIcon(StandardPixmap which, const QStyleOption* option,
                          const QWidget* widget) const {
  switch (which) {
    case SP_MessageBoxInformation:
      return icon("information");
    case SP_MessageBoxWarning:
      return icon("warning");
    case SP_MessageBoxCritical:
      return icon("error");
    case SP_MessageBoxQuestion:
      return icon("question");
    case SP_TitleBarCloseButton:
    case SP_DockWidgetCloseButton:
      return icon("close");
    case SP_TitleBarNormalButton:
      return icon("float");
    default:
      return QProxyStyle::standardIcon(which, option, widget);
  }
}

int Style::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                     QStyleHintReturn* more) const {
  switch (hint) {
    case SH_DialogButtonBox_ButtonsHaveIcons:
    case SH_EtchDisabledText:
    case SH_DitherDisabledText:
    case SH_ScrollBar_Transient:
      return 0;
    case SH_ScrollBar_LeftClickAbsolutePosition:
      return 0;
    default:
      return QProxyStyle::styleHint(hint, option, widget, more);
  }
}

}  // namespace elsie::desktop
