#include "text/sources_panel.h"

#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QStringDecoder>
#include <QTabWidget>
#include <QTextDocument>
#include <QVBoxLayout>
#include <cstring>
#include <utility>

#include "elsie/files/write_whole.h"

#include "engine/compiler_messages.h"
#include "text/code_editor.h"
#include "text/code_highlighter.h"

namespace elsie::desktop {
namespace {

constexpr qint64 kLongest = 10'000'000;  // bytes

/// Has its own undo, and saves on Ctrl+S: the world is saved elsewhere.
class SourceText : public CodeEditor {
 public:
  explicit SourceText(SourceEditor* owner)
      : CodeEditor(owner), owner_(owner), highlighter(new CodeHighlighter(document())) {
    use_palette();
  }

 protected:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::ShortcutOverride) {
      auto* key = static_cast<QKeyEvent*>(event);
      if (key->matches(QKeySequence::Save)) {
        event->accept();
        return true;
      }
    }
    return CodeEditor::event(event);
  }
  void keyPressEvent(QKeyEvent* event) override {
    if (event->matches(QKeySequence::Save)) {
      Q_EMIT owner_->save_wished();
    } else if (event->key() == Qt::Key_Tab) {
      insertPlainText(QString(highlighter->indent(), u' '));
    } else {
      CodeEditor::keyPressEvent(event);
    }
  }
  void use_palette() override { highlighter->use_palette(palette()); }

 private:
  SourceEditor* owner_;

 public:
  CodeHighlighter* highlighter;
};

}  // namespace

SourceEditor::SourceEditor(QWidget* parent)
    : QWidget(parent), save_(new QPushButton), state_(new QLabel) {
  auto* text = new SourceText(this);
  text->setObjectName(QStringLiteral("source_text"));
  text->setAccessibleName(tr("Source of the plugin"));
  text_ = text;
  highlighter_ = text->highlighter;
  setFocusProxy(text_);
  save_->setObjectName(QStringLiteral("save_source"));
  state_->setObjectName(QStringLiteral("source_state"));
  state_->setTextFormat(Qt::PlainText);
  state_->setWordWrap(true);  // a longer sentence does not make the window wider
  state_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* row = new QHBoxLayout;
  row->addWidget(save_);
  row->addWidget(state_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(text_, 1);
  column->addLayout(row);
  connect(save_, &QPushButton::clicked, this, &SourceEditor::save_wished);
  save_->setEnabled(false);
  connect(text_->document(), &QTextDocument::modificationChanged, this, &SourceEditor::modified);
  connect(this, &SourceEditor::modified, save_, [this] { save_->setEnabled(is_modified()); });
}

QString SourceEditor::open(const QString& file) {
  QFile opened(file);
  if (!opened.open(QIODevice::ReadOnly) || opened.size() > kLongest) {
    return tr("'%1' cannot be read: %2.")
        .arg(file, opened.isOpen() ? tr("it is too long for a source") : opened.errorString());
  }
  const QByteArray bytes = opened.readAll();
  QStringDecoder decoder(QStringDecoder::Utf8);
  const QString text = decoder(bytes);
  if (decoder.hasError()) {
    return tr("'%1' is not in UTF-8, and saving it here would damage it. Convert it first, for "
              "example with 'iconv -f LATIN1 -t UTF-8'.")
        .arg(file);
  }
  file_ = file;
  save_->setText(is_plugin() ? tr("&Save and load") : tr("&Save"));
  save_->setToolTip(
      is_plugin()
          ? tr("Saves the file; the engine compiles and loads it, and the run goes on (Ctrl+S)")
          : tr("Saves the file (Ctrl+S)"));
  on_disk_ = bytes;
  has_line_ends_of_windows_ = bytes.contains("\r\n");
  highlighter_->set_language(file.endsWith(QLatin1String(".py")) ? CodeHighlighter::Language::python
                                                                 : CodeHighlighter::Language::cpp);
  text_->setPlainText(text);
  text_->document()->setModified(false);
  return {};
}

QString SourceEditor::save() {
  QFile there(file_);
  if (there.open(QIODevice::ReadOnly)) {
    if (const QByteArray now = there.readAll(); now != std::exchange(on_disk_, now)) {
      return tr("'%1' has been changed by another program, and is not overwritten. Save again to "
                "replace it by the text in this window.")
          .arg(file_);
    }
  }
  QByteArray bytes = text_->whole_text().toUtf8();
  if (has_line_ends_of_windows_) bytes.replace("\n", "\r\n");
  const int error = files::write_whole(file_.toStdString(), bytes.toStdString());
  if (error != 0) {
    return tr("'%1' cannot be written: %2. The text stays here; make room, or allow writing there, "
              "and save again.")
        .arg(file_, QString::fromLocal8Bit(strerror(error)));
  }
  on_disk_ = bytes;
  text_->document()->setModified(false);
  return {};
}

bool SourceEditor::is_model() const { return file_.endsWith(QLatin1String(".fcl")); }
bool SourceEditor::is_plugin() const {
  return !is_model() && !file_.endsWith(QLatin1String(".xml"));
}

bool SourceEditor::is_modified() const { return text_->document()->isModified(); }

void SourceEditor::say(const QString& state) { state_->setText(state); }

void SourceEditor::set_problems(const std::vector<Problem>& problems) {
  text_->set_problems(problems);
}

SourcesPanel::SourcesPanel(QWidget* parent) : QWidget(parent), tabs_(new QTabWidget) {
  tabs_->setObjectName(QStringLiteral("source_tabs"));
  tabs_->setDocumentMode(true);
  tabs_->setTabsClosable(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(tabs_);
  connect(tabs_, &QTabWidget::tabCloseRequested, this, [this](int tab) {
    Q_EMIT close_wished(static_cast<SourceEditor*>(tabs_->widget(tab))->file());
  });
}

std::vector<SourceEditor*> SourcesPanel::editors() const {
  std::vector<SourceEditor*> all;
  for (int i = 0; i < tabs_->count(); ++i) {
    all.push_back(static_cast<SourceEditor*>(tabs_->widget(i)));
  }
  return all;
}

SourceEditor* SourcesPanel::editor_of(const QString& file) const {
  for (SourceEditor* each : editors()) {
    if (QFileInfo(each->file()) == QFileInfo(file)) return each;
  }
  return nullptr;
}

QString SourcesPanel::open(const QString& file) {
  SourceEditor* editor = editor_of(file);
  if (!editor) {
    editor = new SourceEditor;
    const QString why = editor->open(file);
    if (!why.isEmpty()) {
      delete editor;
      return why;
    }
    tabs_->addTab(editor, {});
    connect(editor, &SourceEditor::modified, this, &SourcesPanel::show_titles);
    connect(editor, &SourceEditor::modified, this, &SourcesPanel::edited);
    connect(&editor->text(), &QPlainTextEdit::textChanged, this, &SourcesPanel::edited);
    connect(editor, &SourceEditor::save_wished, this, [this, editor] {
      if (const QString mistake = save(editor); !mistake.isEmpty()) Q_EMIT failed(mistake);
    });
    show_titles();
  }
  tabs_->setCurrentWidget(editor);
  editor->setFocus();
  return {};
}

void SourcesPanel::show_titles() {
  for (int i = 0; i < tabs_->count(); ++i) {
    const auto* editor = static_cast<SourceEditor*>(tabs_->widget(i));
    tabs_->setTabText(i, QFileInfo(editor->file()).fileName() +
                             (editor->is_modified() ? QStringLiteral("*") : QString()));
    tabs_->setTabToolTip(i, editor->file());
  }
}

/// Returns "", or why its file cannot be written.
QString SourcesPanel::save(SourceEditor* editor) {
  if (!editor->is_modified()) {
    return {};  // the engine has it
  }
  if (const QString why = editor->save(); !why.isEmpty()) {
    return why;
  }
  if (editor->is_model()) {
    Q_EMIT model_saved(editor->file());
    return {};
  }
  editor->say(editor->is_plugin() ? tr("Saved. The engine loads it...") : tr("Saved."));
  return {};
}

void SourcesPanel::go_to(const QString& file, int line) {
  if (const QString why = open(file); !why.isEmpty()) {
    Q_EMIT failed(why);
    return;
  }
  editor_of(file)->text().go_to(line);
}

void SourcesPanel::set_problems(const std::vector<Problem>& problems) {
  for (SourceEditor* each : editors()) {
    std::vector<Problem> own;
    for (const Problem& problem : problems) {
      for (const Problem& place : problems_in(problem.message)) {
        if (place.line > 0 && QFileInfo(place.file) == QFileInfo(each->file())) {
          own.push_back(place);
        }
      }
    }
    each->set_problems(own);
  }
}

void SourcesPanel::take(const QStringList& used, const QStringList& kept) {
  for (SourceEditor* each : editors()) {
    if (used.contains(each->file())) {
      each->say(tr("✓ Loaded: the engine uses what was saved."));
    } else if (kept.contains(each->file())) {
      each->say(tr("✗ Not loaded: it has errors, which the window Errors lists."));
    }
  }
}

void SourcesPanel::say(const QString& file, const QString& state) {
  if (SourceEditor* editor = editor_of(file)) editor->say(state);
}

QStringList SourcesPanel::modified() const {
  QStringList files;
  for (const SourceEditor* each : editors()) {
    if (each->is_modified()) files << each->file();
  }
  return files;
}

std::vector<Typed> SourcesPanel::unsaved() const {
  std::vector<Typed> all;
  for (SourceEditor* each : editors()) {
    if (each->is_modified()) all.push_back({each->file(), each->text().whole_text()});
  }
  return all;
}

void SourcesPanel::put(const Typed& unsaved) {
  if (SourceEditor* editor = editor_of(unsaved.path)) {
    QTextCursor all(editor->text().document());
    all.select(QTextCursor::Document);
    all.insertText(unsaved.text);
  }
}

QString SourcesPanel::save(const QStringList& files) {
  for (const QString& file : files) {
    SourceEditor* editor = editor_of(file);
    const QString why = editor ? save(editor) : QString();
    if (!why.isEmpty()) return why;
  }
  return {};
}

void SourcesPanel::close_tab(const QString& file) {
  if (SourceEditor* editor = editor_of(file)) {
    tabs_->removeTab(tabs_->indexOf(editor));
    editor->deleteLater();
    Q_EMIT edited();
  }
}

}  // namespace elsie::desktop
