// Commands that are found by typing.
#pragma once

#include <QDialog>
#include <QIcon>
#include <QKeySequence>
#include <functional>
#include <optional>
#include <vector>

class QLineEdit;
class QListWidget;

namespace elsie::desktop {

/// One line of the palette.
struct Offer {
  QString title;
  QString key;  // as the user reads it; "" if it has none
  QIcon icon;
  std::function<void()> does;
  QStringList also{};  // other names by which it is found
};

/// How well a title fits what is typed: all its letters must be in the title in their order, in
/// any case. Beginnings of words and letters in a row count more. None if it does not fit.
std::optional<int> fit(const QString& typed, const QString& title);

/// Lists what fits what is typed, the best first. Enter does the chosen one, Up and Down choose,
/// Esc closes.
class CommandPalette : public QDialog {
  Q_OBJECT

 public:
  /// `typed_offers` makes more of them from what is typed, such as "Set the speed to 3".
  CommandPalette(std::vector<Offer> offers,
                 std::function<std::vector<Offer>(const QString&)> typed_offers, QWidget* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void list_fitting();
  void choose();

  std::vector<Offer> offers_;
  std::function<std::vector<Offer>(const QString&)> typed_offers_;
  std::vector<Offer> listed_;
  QLineEdit* wish_;
  QListWidget* list_;
};

}  // namespace elsie::desktop
