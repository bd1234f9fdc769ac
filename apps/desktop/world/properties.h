// What the chosen thing is given, as a form; every entry is an edit.
#pragma once

#include <QWidget>

#include "engine/catalog.h"

class QLabel;
class QLineEdit;

namespace elsie::desktop {

class Form;
class Workbench;

class Properties : public QWidget {
  Q_OBJECT

 public:
  explicit Properties(Workbench& workbench, QWidget* parent = nullptr);

  /// Of the element at the path; "" is the world.
  void show_element(const QString& path);
  /// The priority that the chosen behaviour has now, from a `state` event, beside the one that it
  /// was given.
  void show_weight(const Json& state);
  const QString& path() const { return path_; }
  Form& form() { return *form_; }

 private:
  void refresh();
  void change(const QString& path, const QString& name, const QString& edit);

  Workbench& workbench_;
  QString path_;
  QLabel* title_;
  QLabel* about_;
  QLineEdit* filter_;
  Form* form_;
};

/// What is at a path, also of a part that every world has and that its file does not name.
struct Described {
  QString title;
  Kind kind;
  Json values;
};
std::optional<Described> described_at(const Workbench& workbench, const QString& path);

}  // namespace elsie::desktop
