// The first page of the window: examples, a new world, and the files that were opened last.
#pragma once

#include <QProcess>
#include <QWidget>

class QListWidget;

namespace elsie::desktop {

class StartPage : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kPicture_px = 480;

  /// `worlds` is the folder of the shipped worlds, "" if it was not found. `elsie` is the program
  /// that draws them, in the background and while the page is visible. The pictures are kept; a
  /// world that has changed is drawn again.
  StartPage(const QString& worlds, QString elsie, QWidget* parent = nullptr);
  ~StartPage() override;

  void show_recent(const QStringList& files);

 Q_SIGNALS:
  void open_wished(const QString& file);
  void new_wished();
  void empty_wished();
  void browse_wished();

 protected:
  void showEvent(QShowEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void draw_next();
  bool show_picture(int example);

  QString elsie_;
  QProcess drawing_;
  int next_ = 0;  // the example that is drawn next, or now
  QListWidget* examples_;
  QListWidget* recent_;
};

/// The text of a world with only four walls.
QString empty_world();

}  // namespace elsie::desktop
