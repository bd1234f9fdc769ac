// The first page of the window: examples, a new world, and the files that were opened last.
#pragma once

#include <QWidget>

#include "thumbnails.h"

class QListWidget;

namespace elsie::desktop {

class StartPage : public QWidget {
  Q_OBJECT

 public:
  /// `worlds` is the folder of the shipped worlds, "" if it was not found. `elsie` is the program
  /// that draws them.
  StartPage(const QString& worlds, const QString& elsie, QWidget* parent = nullptr);

  void show_recent(const QStringList& files);

 Q_SIGNALS:
  void open_wished(const QString& file);
  void new_wished();
  void empty_wished();
  void browse_wished();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void draw_examples();

  QListWidget* examples_;
  QListWidget* recent_;
  Thumbnails thumbnails_;
};

/// The text of a world with only four walls.
QString empty_world();

/// Asks for the size and the contents of a new world. Returns its text, or "" if the user cancels.
QString ask_for_new_world(QWidget* parent);

}  // namespace elsie::desktop
