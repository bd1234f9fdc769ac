// The pages of the documentation, which are installed with the program: no network is needed.
#pragma once

#include <QDialog>

class QTextBrowser;

namespace elsie::desktop {

class HelpWindow : public QDialog {
  Q_OBJECT

 public:
  /// The folder of the pages, of an installed program or of a build; "" if there is none.
  static QString folder();
  /// The page of a plugin of a kind ("behavior"), seen from that folder; "" if there is none.
  static QString page_of(const QString& kind, const QString& plugin);

  explicit HelpWindow(QWidget* parent);

  /// Shows a page, by its name in the folder: "tutorial/1-your-first-behavior.md".
  void open(const QString& page);

 Q_SIGNALS:
  /// A link leads to a world.
  void world_wished(const QString& file);

 private:
  QTextBrowser* text_;
};

}  // namespace elsie::desktop
