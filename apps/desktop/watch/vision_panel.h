// What the cameras of the robots see, now or at the shown time of the past.
#pragma once

#include <QImage>
#include <QWidget>
#include <map>
#include <optional>

#include "engine/past.h"
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
  /// Shows the pictures of that time; null: those of the present.
  void look_back(const Instant* then);
  void clear();

  /// The names of all pictures so far: "robot/camera raw" and "robot/camera processed".
  QStringList pictures() const;
  /// The one that is shown; null if there is none of the shown time.
  QImage picture(const QString& name) const;
  /// What it says in place of pictures; "" if it shows some.
  QString notice() const;
  Figures figures() const override;
  void set_shown(const QString& name, bool shown);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  struct Picture {
    QImage image;  // of the present
    QImage then;   // of the shown time of the past
    bool shown = true;
  };

  const QImage& image_of(const Picture& picture) const;
  QStringList shown() const;
  QRect cell(int n, int count) const;
  /// Takes the pictures of a state, or of a look.
  void take(const Json& state, QImage Picture::*where);
  Picture& offered(const QString& name);

  std::map<QString, Picture> pictures_;
  std::optional<double> then_s_;  // the shown time of the past
  QToolButton* choose_;
  QMenu* choices_;
};

}  // namespace elsie::desktop
