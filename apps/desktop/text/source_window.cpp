#include "text/source_window.h"

#include <QCloseEvent>
#include <QDesktopServices>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSaveFile>
#include <QShortcut>
#include <QUrl>
#include <QVBoxLayout>

#include "paint/warning_label.h"
#include "text/code_editor.h"

namespace elsie::desktop {

QString SourceWindow::show(const QString& file, int line, QWidget* parent) {
  const QString path = QFileInfo(file).absoluteFilePath();
  const auto windows = parent->findChildren<SourceWindow*>();
  const auto same = std::find_if(windows.begin(), windows.end(), [&](const SourceWindow* each) {
    return each->file_ == path && each->isVisible();
  });
  SourceWindow* window = same == windows.end() ? nullptr : *same;
  if (!window) {
    QFile opened(path);
    if (!opened.open(QIODevice::ReadOnly)) {
      return tr("'%1' cannot be read: %2.").arg(path, opened.errorString());
    }
    window = new SourceWindow(path, QString::fromUtf8(opened.readAll()), parent);
    window->QWidget::show();
  }
  window->raise();
  window->activateWindow();
  window->editor_->go_to(line);
  return {};
}

SourceWindow::SourceWindow(const QString& file, const QString& text, QWidget* parent)
    : QWidget(parent, Qt::Window), file_(file) {
  setObjectName("source_window");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(QFileInfo(file).fileName() + "[*]");
  auto* column = new QVBoxLayout(this);
  auto* row = new QHBoxLayout;
  auto* name = new QLabel(file);
  name->setTextInteractionFlags(Qt::TextSelectableByMouse);
  name->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->addWidget(name, 1);
  auto* save_button = new QPushButton(tr("&Save"));
  save_button->setObjectName("save");
  row->addWidget(save_button);
  auto* other = new QPushButton(tr("Open in &another program"));
  row->addWidget(other);
  column->addLayout(row);
  editor_ = new CodeEditor(this);
  editor_->setPlainText(text);
  editor_->document()->setModified(false);
  column->addWidget(editor_, 1);
  connect(editor_->document(), &QTextDocument::modificationChanged, this,
          [this](bool is_modified) { setWindowModified(is_modified); });
  connect(save_button, &QPushButton::clicked, this, &SourceWindow::save);
  connect(other, &QPushButton::clicked, this,
          [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(file_)); });
  connect(new QShortcut(QKeySequence::Save, this), &QShortcut::activated, this,
          &SourceWindow::save);
  resize(100 * fontMetrics().averageCharWidth(), 40 * fontMetrics().height());
}

bool SourceWindow::save() {
  QSaveFile file(file_);
  const QByteArray text = editor_->whole_text().toUtf8();
  if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit()) {
    warn(this, tr("Not saved"), tr("'%1' cannot be written: %2.").arg(file_, file.errorString()));
    return false;
  }
  editor_->document()->setModified(false);
  return true;
}

void SourceWindow::closeEvent(QCloseEvent* event) {
  if (isWindowModified()) {
    const auto answer = QMessageBox::question(
        this, tr("Unsaved changes"),
        tr("'%1' has changes that are not saved. Save them?").arg(QFileInfo(file_).fileName()),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
    if (answer == QMessageBox::Cancel || (answer == QMessageBox::Save && !save())) {
      event->ignore();
      return;
    }
  }
  event->accept();
}

}  // namespace elsie::desktop
