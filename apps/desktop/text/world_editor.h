// The editor of a world's text.
#pragma once

#include <QTimer>

#include "engine/catalog.h"
#include "text/code_editor.h"

class QCompleter;
class QStringListModel;

namespace elsie::desktop {

class XmlHighlighter;

/// Shows the text of the document, which the window owns: set_text() sets it, and edited() reports
/// what was typed. The editor has no undo of its own; it leaves the keys to the window.
class WorldEditor : public CodeEditor {
  Q_OBJECT

 public:
  explicit WorldEditor(QWidget* parent = nullptr);

  /// Changes only what differs, so that cursor and scroll position stay, without edited(). While
  /// typed text waits for its edited(), the text stays as typed, and edited() sends it.
  void set_text(const QString& text);
  /// Emits edited() now if it waits.
  void commit();
  void set_catalog(const Catalog& catalog) { catalog_ = catalog; }

 Q_SIGNALS:
  /// Emitted 400 ms after the last key stroke.
  void edited(const QString& text);
  void undo_wished();
  void redo_wished();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void use_palette() override;

 private:
  void offer_words(bool wished);
  void take_word(const QString& word);

  XmlHighlighter* highlighter_;
  QStringListModel* words_;
  QCompleter* completer_;
  QTimer typing_;
  bool from_outside_ = false;
  Catalog catalog_;
};

}  // namespace elsie::desktop
