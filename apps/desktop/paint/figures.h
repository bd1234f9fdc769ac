// The contents of painted widgets as tables, for screen readers and for users who want the numbers.
#pragma once

#include <QStringList>
#include <vector>

class QWidget;

namespace elsie::desktop {

struct Figures {
  QStringList columns;
  std::vector<QStringList> rows;
};

/// A widget that paints figures. Its accessible interface has them as text, one row per line.
class ShowsFigures {
 public:
  virtual ~ShowsFigures() = default;
  virtual Figures figures() const = 0;
};

/// Call it in the constructor of a widget that is a ShowsFigures: the menu key and a right click
/// then offer its figures as a table, and screen readers find them.
void offer_figures(QWidget* widget);
/// Opens the table, which keeps the figures of this instant until "Again" is pressed.
void show_figures(QWidget* widget);

}  // namespace elsie::desktop
