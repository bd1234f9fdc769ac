// What the cameras of the robots see.
#pragma once

#include <QImage>
#include <QWidget>
#include <map>

#include "engine/json.h"
#include "paint/figures.h"

class QMenu;
class QToolButton;

namespace elsie::desktop {

/// Shows pictures side by side, raw and processed, without smoothing. A menu with check boxes
/// chooses them; the context menu of a picture saves it.
class VisionPanel : public QWidget, public ShowsFigures {
  Q_OBJECT

 public:
  explicit VisionPanel(QWidget* parent = nullptr);

  /// Takes a `state` event.
  void add(const Json& state);
  void clear();

  /// The names of all pictures so far: "robot/camera raw" and "robot/camera processed".
  QStringList pictures() const;
  QImage picture(const QString& name) const;
  Figures figures() const override;
  void set_shown(const QString& name, bool shown);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  struct Picture {
    QImage image;
    bool shown = true;
  };

  QStringList shown() const;
  QRect cell(int n, int count) const;
  void take(const QString& name, const Json& picture);

  std::map<QString, Picture> pictures_;
  QToolButton* choose_;
  QMenu* choices_;
};

}  // namespace elsie::desktop
