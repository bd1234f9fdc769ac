// What the window shows first: examples, a new world, files that were open last.
#pragma once

#include <QWidget>

#include "thumbnails.h"

class QListWidget;

namespace elsie::desktop {

class StartPage : public QWidget {
  Q_OBJECT

 public:
  /// `worlds`: the folder of the shipped worlds; "" if it was not found. `elsie`: the program that
  /// draws them.
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

/// The text of a world with four walls only.
QString empty_world();

/// Asks for the size of a new world and what is in it; returns its text, or "" if the user changed
/// his mind.
QString ask_for_new_world(QWidget* parent);

}  // namespace elsie::desktop
