#include "look/theme.h"

#include <QApplication>
#include <QGuiApplication>
#include <QPalette>
#include <QPixmapCache>
#include <QSettings>
#include <QStyleHints>

#include "look/style.h"

namespace elsie::desktop {
namespace {

constexpr auto kThemeSetting = "theme";

bool is_system_dark = false;

struct Colours {
  QRgb window, base, alternate, button, text, quiet, off, line, highlight, link, tip, tip_text;
};
constexpr Colours kLight{0xf4f5f7, 0xffffff, 0xf7f8fa, 0xffffff, 0x1d2129, 0x5f6876,
                         0xa3a9b3, 0xd5d9e0, 0x2563c9, 0x1d56b8, 0x262b34, 0xf4f5f7};
constexpr Colours kDark{0x22252b, 0x1a1c21, 0x1f2227, 0x2e323a, 0xe4e7ec, 0x9ca5b3,
                        0x6b7280, 0x3a3f48, 0x3f7ee0, 0x86b4ff, 0x3a3f48, 0xf1f3f6};

QPalette palette_of(const Colours& colours) {
  QPalette palette;
  const QColor window = colours.window;
  const auto set = [&](QPalette::ColorRole role, QRgb colour) {
    palette.setColor(role, QColor(colour));
  };
  set(QPalette::Window, colours.window);
  set(QPalette::WindowText, colours.text);
  set(QPalette::Base, colours.base);
  set(QPalette::AlternateBase, colours.alternate);
  set(QPalette::Text, colours.text);
  set(QPalette::PlaceholderText, colours.quiet);
  set(QPalette::Button, colours.button);
  set(QPalette::ButtonText, colours.text);
  set(QPalette::BrightText, 0xffffff);
  set(QPalette::Highlight, colours.highlight);
  set(QPalette::HighlightedText, 0xffffff);
  set(QPalette::Link, colours.link);
  set(QPalette::LinkVisited, colours.link);
  set(QPalette::ToolTipBase, colours.tip);
  set(QPalette::ToolTipText, colours.tip_text);
  set(QPalette::Mid, colours.line);
  palette.setColor(QPalette::Light, window.lighter(108));
  palette.setColor(QPalette::Midlight, window.lighter(104));
  palette.setColor(QPalette::Dark, QColor(colours.line).darker(120));
  palette.setColor(QPalette::Shadow, window.darker(250));
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::PlaceholderText}) {
    palette.setColor(QPalette::Disabled, role, QColor(colours.off));
  }
  palette.setColor(QPalette::Disabled, QPalette::Base, window);
  palette.setColor(QPalette::Disabled, QPalette::Button, window);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(colours.line));
  return palette;
}

void show_theme() {
  const QString chosen = theme();
  const bool dark = chosen == "system" ? is_system_dark : chosen == "dark";
  QPixmapCache::clear();
  QApplication::setPalette(palette_of(dark ? kDark : kLight));
}

}  // namespace

void begin_theme() {
  is_system_dark = is_dark(QGuiApplication::palette());
  QApplication::setStyle(new Style);
#if QT_VERSION >= QT_VERSION_CHECK(6, 5, 0)
  is_system_dark = QGuiApplication::styleHints()->colorScheme() == Qt::ColorScheme::Dark;
  QObject::connect(QGuiApplication::styleHints(), &QStyleHints::colorSchemeChanged, qApp,
                   [](Qt::ColorScheme scheme) {
                     is_system_dark = scheme == Qt::ColorScheme::Dark;
                     show_theme();
                   });
#endif
  show_theme();
}

QString theme() {
  const QString chosen = QSettings().value(kThemeSetting).toString();
  return chosen == "light" || chosen == "dark" ? chosen : QStringLiteral("system");
}

void choose_theme(const QString& name) {
  QSettings().setValue(kThemeSetting, name);
  show_theme();
}

bool is_dark(const QPalette& palette) {
  return palette.color(QPalette::Window).lightnessF() < 0.5F;
}

QColor accent(const QPalette& palette) {
  return is_dark(palette) ? QColor(0x56, 0xc2, 0x8a) : QColor(0x17, 0x86, 0x4f);
}

QColor line_colour(const QPalette& palette) { return palette.color(QPalette::Mid); }

QColor quiet(const QPalette& palette) { return palette.color(QPalette::PlaceholderText); }

}  // namespace elsie::desktop
