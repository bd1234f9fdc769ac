// What a painted widget shows, as a table: for screen readers, and for all who want the numbers.
#pragma once

#include <QStringList>
#include <vector>

class QWidget;

namespace elsie::desktop {

struct Figures {
  QStringList columns;
  std::vector<QStringList> rows;
};

/// A widget that paints figures. Its accessible interface has them as a text, a row a line.
class ShowsFigures {
 public:
  virtual ~ShowsFigures() = default;
  virtual Figures figures() const = 0;
};

/// To be called in the constructor of a widget that is a ShowsFigures: the key for menus and a
/// right click offer its figures as a table, and screen readers find them.
void offer_figures(QWidget* widget);
/// Opens the table. It keeps the figures of this instant until "Again" is pressed.
void show_figures(QWidget* widget);

}  // namespace elsie::desktop
