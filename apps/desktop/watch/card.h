// Cards: small panels that lie over the view.
#pragma once

#include <QFrame>

class QVBoxLayout;

namespace elsie::desktop {

/// Lies in a corner of its parent, over what that paints. The button in its corner and Esc close
/// it. Screen readers hear its accessible name and description when it opens.
class Card : public QFrame {
  Q_OBJECT

 public:
  enum class Corner { top_left, bottom_right };

  Card(Corner corner, QWidget* parent);

  /// The colour of the band at its left.
  void set_band(const QColor& colour);
  /// Shows it, and says so.
  void open();

 Q_SIGNALS:
  void closed();  // by the user

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

  QVBoxLayout* column() { return column_; }
  /// To be called when its contents have changed.
  void settle();

 private:
  void close_by_user();

  Corner corner_;
  QColor band_;
  QVBoxLayout* column_;
};

}  // namespace elsie::desktop
