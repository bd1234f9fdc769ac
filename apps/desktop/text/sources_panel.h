// The sources of plugins that are written in the window.
#pragma once

#include <QByteArray>
#include <QWidget>
#include <vector>

#include "engine/problem.h"
#include "engine/recovery.h"

class QLabel;
class QPushButton;
class QTabWidget;

namespace elsie::desktop {

class CodeEditor;
class CodeHighlighter;

/// The source of one plugin. Saving it makes the engine compile and load it.
class SourceEditor : public QWidget {
  Q_OBJECT

 public:
  explicit SourceEditor(QWidget* parent = nullptr);

  /// Returns "", or why the file cannot be read.
  QString open(const QString& file);
  const QString& file() const { return file_; }
  bool is_model() const;   // a fuzzy one
  bool is_plugin() const;  // which the engine follows
  /// Returns "", or why the file cannot be written. A file that another program has changed is
  /// only overwritten at the second call. Line ends stay as they are.
  QString save();
  bool is_modified() const;
  void say(const QString& state);
  /// The problems of this file.
  void set_problems(const std::vector<Problem>& problems);
  CodeEditor& text() { return *text_; }

 Q_SIGNALS:
  void save_wished();
  void modified();

 private:
  QString file_;
  QByteArray on_disk_;  // when it was last read or written here, or found changed
  bool has_line_ends_of_windows_ = false;
  CodeEditor* text_;
  CodeHighlighter* highlighter_;
  QPushButton* save_;
  QLabel* state_;
};

/// A tab for each of them.
class SourcesPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SourcesPanel(QWidget* parent = nullptr);

  /// Shows the file. Returns "", or why it cannot be read.
  QString open(const QString& file);
  /// Whether it has a tab.
  bool has(const QString& file) const { return editor_of(file) != nullptr; }
  void go_to(const QString& file, int line);
  /// What is wrong with them, and whether the engine uses what was saved.
  void set_problems(const std::vector<Problem>& problems);
  void take(const QStringList& used, const QStringList& kept);
  void say(const QString& file, const QString& state);
  /// The files with changes that are not saved.
  QStringList modified() const;
  /// Those files, with the texts that they are to have.
  std::vector<Typed> unsaved() const;
  /// Puts a text that was not saved in the place of that of the file, which has a tab.
  void put(const Typed& unsaved);
  /// Saves these. Returns "", or why a file cannot be written.
  QString save(const QStringList& files);
  /// Closes the tab of a file; what is not saved is lost.
  void close_tab(const QString& file);

 Q_SIGNALS:
  /// Somebody wants to close the tab of a file.
  void close_wished(const QString& file);
  void failed(const QString& sentence);
  /// Of a fuzzy model: the engine reads it when a run begins.
  void model_saved(const QString& file);
  /// unsaved() may have changed.
  void edited();

 private:
  SourceEditor* editor_of(const QString& file) const;
  std::vector<SourceEditor*> editors() const;
  void show_titles();
  QString save(SourceEditor* editor);

  QTabWidget* tabs_;
};

}  // namespace elsie::desktop
