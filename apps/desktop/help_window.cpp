#include "help_window.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QTextBrowser>
#include <QTextTable>
#include <QVBoxLayout>

namespace elsie::desktop {
namespace {

/// Links to other pages are followed here, those to worlds by the window.
class Pages : public QTextBrowser {
 public:
  explicit Pages(HelpWindow* owner) : owner_(owner) {}

 protected:
  void doSetSource(const QUrl& name, QTextDocument::ResourceType type) override {
    const QFileInfo file(name.toLocalFile());
    if (file.suffix() == QLatin1String("xml")) {
      Q_EMIT owner_->world_wished(file.absoluteFilePath());
    } else if (file.suffix() == QLatin1String("md")) {
      QTextBrowser::doSetSource(name, QTextDocument::MarkdownResource);
      draw_tables_flat();
    } else {
      QTextBrowser::doSetSource(name, type);
    }
  }
  QVariant loadResource(int type, const QUrl& name) override {
    if (type != QTextDocument::ImageResource) return QTextBrowser::loadResource(type, name);
    // No wider than the text.
    QImage image(document()->baseUrl().resolved(name).toLocalFile());
    const int widest = std::max(200, viewport()->width() - 4 * fontMetrics().height());
    return image.width() > widest ? image.scaledToWidth(widest, Qt::SmoothTransformation) : image;
  }

 private:
  /// With one line between two cells, where Qt has two.
  void draw_tables_flat() {
    for (QTextFrame* frame : document()->rootFrame()->childFrames()) {
      if (auto* table = qobject_cast<QTextTable*>(frame)) {
        QTextTableFormat format = table->format();
        format.setBorderCollapse(true);
        format.setBorder(1.0);
        format.setBorderBrush(palette().color(QPalette::Mid));
        format.setCellPadding(fontMetrics().height() / 4.0);
        format.setCellSpacing(0.0);
        table->setFormat(format);
      }
    }
  }

  HelpWindow* owner_;
};

}  // namespace

QString HelpWindow::folder() {
  const QDir program(QApplication::applicationDirPath());
  for (const char* place : {"../share/doc/elsie/docs", "../../../docs", "../../docs"}) {
    const QFileInfo found(program.filePath(QLatin1String(place)));
    if (QFileInfo::exists(found.filePath() + QStringLiteral("/tutorial"))) {
      return found.canonicalFilePath();
    }
  }
  return {};
}

QString HelpWindow::page_of(const QString& kind, const QString& plugin) {
  const QString page = kind + QStringLiteral("s/") + plugin + QStringLiteral(".md");
  return QFileInfo::exists(folder() + u'/' + page) ? page : QString();
}

HelpWindow::HelpWindow(QWidget* parent) : QDialog(parent), text_(new Pages(this)) {
  setObjectName(QStringLiteral("help_window"));
  setWindowTitle(tr("Help"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(128 * fontMetrics().averageCharWidth(), 46 * fontMetrics().height());
  text_->setObjectName(QStringLiteral("help_text"));
  text_->setAccessibleName(tr("Page of the documentation"));
  text_->setOpenExternalLinks(true);
  text_->setWordWrapMode(QTextOption::WordWrap);  // no name in two halves
  text_->document()->setDocumentMargin(fontMetrics().height());
  auto* row = new QHBoxLayout;
  const auto button = [&](const QString& text, auto does) {
    auto* made = new QPushButton(text);
    made->setAutoDefault(false);
    row->addWidget(made);
    connect(made, &QPushButton::clicked, this, does);
    return made;
  };
  auto* back = button(tr("&Back"), [this] { text_->backward(); });
  auto* forward = button(tr("&Forward"), [this] { text_->forward(); });
  button(tr("&Tutorial"), [this] { open(QStringLiteral("tutorial/1-your-first-behavior.md")); });
  row->addStretch(1);
  button(tr("&Close"), [this] { close(); });
  back->setEnabled(false);
  forward->setEnabled(false);
  connect(text_, &QTextBrowser::backwardAvailable, back, &QPushButton::setEnabled);
  connect(text_, &QTextBrowser::forwardAvailable, forward, &QPushButton::setEnabled);
  auto* column = new QVBoxLayout(this);
  column->addWidget(text_, 1);
  column->addLayout(row);
  text_->setFocus();
}

void HelpWindow::open(const QString& page) {
  text_->setSource(QUrl::fromLocalFile(folder() + u'/' + page), QTextDocument::MarkdownResource);
}

}  // namespace elsie::desktop
