#include "export/sharer.h"

#include <QDesktopServices>
#include <QFile>
#include <QFileInfo>
#include <QMessageBox>
#include <QProcessEnvironment>
#include <QProgressDialog>
#include <QPushButton>
#include <QUrl>
#include <algorithm>
#include <utility>

#include "engine/workbench.h"
#include "export/export_dialogs.h"
#include "paint/warning_label.h"
#include "recorded_world.h"

namespace elsie::desktop {
namespace {

constexpr int kPatienceAtEnd_ms = 500;  // the time that a process has to end
// Exit codes of elsie: a run that misses its goals, or whose plugin fails, is recorded, too.
constexpr int kDone = 0, kMissed = 1, kPluginFailed = 3;
constexpr const char* kDataPath = "ELSIE_DATA_PATH";

}  // namespace

Sharer::Sharer(Workbench& workbench, QString elsie, QStringList options, QWidget* window)
    : QObject(window),
      workbench_(workbench),
      elsie_(std::move(elsie)),
      options_(std::move(options)),
      window_(window) {}

Sharer::~Sharer() { leave(); }

void Sharer::share(const Recorded* recorded) {
  if (folder_) {
    Q_EMIT said(tr("A page is being written already."));
    return;
  }
  if (!recorded && workbench_.latest_s() <= 0.0) {
    Q_EMIT said(tr("There is no run to show: run the world first."));
    return;
  }
  const QString base =
      QFileInfo(recorded ? recorded->source : workbench_.file()).completeBaseName();
  const QString name = base.isEmpty()                  ? QStringLiteral("run")
                       : recorded && recorded->run > 0 ? base + QString("-%1").arg(recorded->run)
                                                       : base;
  const QString file =
      ask_for_file(tr("Share the run as a page"), name + ".html", tr("Pages (*.html)"), window_);
  if (!file.isEmpty()) {
    write(file, recorded);
  }
}

void Sharer::write(const QString& file, const Recorded* recorded) {
  if (folder_) {
    return;
  }
  file_ = file;
  folder_ = std::make_unique<QTemporaryDir>();
  data_path_.clear();
  ++number_;
  if (!folder_->isValid()) {
    fail(tr("there is no room for temporary files: %1").arg(folder_->errorString()));
    return;
  }
  progress_ = new QProgressDialog(tr("Writing '%1'").arg(file), tr("Cancel"), 0, 0, window_);
  progress_->setObjectName("page_progress");
  progress_->setWindowTitle(tr("Page"));
  progress_->setMinimumDuration(0);
  progress_->show();
  connect(progress_, &QProgressDialog::canceled, this, [this] { fail({}); });
  const QString made = folder_->filePath("run.mcap");
  if (recorded && recorded->run == 0) {
    make_page(recorded->source);
  } else if (recorded) {
    start(QStringList{"replay", recorded->source, QString::number(recorded->run), "--record", made,
                      "--quiet"} +
              options_,
          {kDone, kPluginFailed}, [this, made] { make_page(made); });
  } else {
    until_s_ = workbench_.run_state() == Workbench::Run::ended ? 0.0 : workbench_.latest_s();
    workbench_.ask({{"do", "command"}}, [this, number = number_](const Json& answer) {
      if (folder_ && number == number_) repeat(answer);
    });
  }
}

/// Makes the run again with the text with which it began, which need not be in its file any more.
void Sharer::repeat(const Json& command) {
  QStringList words;
  for (const Json& word : member(command, "words")) {
    if (word.is_string()) words << QString::fromStdString(word.get<std::string>());
  }
  if (words.size() < 2) {
    fail(tr("the engine does not say how the run began"));
    return;
  }
  if (!command.value("saved", true)) {
    const QFileInfo known(words[1]);
    QFile world(folder_->filePath(known.fileName()));
    const QByteArray text = text_of(command, "world").toUtf8();
    if (!world.open(QIODevice::WriteOnly) || world.write(text) != text.size()) {
      fail(world.errorString());
      return;
    }
    data_path_ = known.absolutePath();
    words[1] = world.fileName();
  }
  const QString made = folder_->filePath("run.mcap");
  words << "--record" << made << "--quiet";
  if (until_s_ > 0.0) words << "--duration" << QString::number(until_s_, 'g', 17);
  start(words, {kDone, kMissed, kPluginFailed}, [this, made] { make_page(made); });
}

void Sharer::make_page(const QString& recording) {
  start(QStringList{"page", recording, "--output", file_} + options_, {kDone},
        [this] { show_page(); });
}

void Sharer::start(const QStringList& words, std::initializer_list<int> good,
                   std::function<void()> done) {
  process_ = std::make_unique<QProcess>();
  process_->setStandardInputFile(QProcess::nullDevice());
  process_->setStandardOutputFile(QProcess::nullDevice());
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  if (!data_path_.isEmpty()) {
    const QString before = environment.value(kDataPath);
    environment.insert(kDataPath, before.isEmpty() ? data_path_ : data_path_ + ':' + before);
  }
  process_->setProcessEnvironment(environment);
  connect(process_.get(), &QProcess::finished, this,
          [this, codes = std::vector<int>(good), done = std::move(done)](int code) {
            const std::unique_ptr<QProcess, void (*)(QProcess*)> process(
                process_.release(), [](QProcess* each) { each->deleteLater(); });
            const bool is_good = process->exitStatus() == QProcess::NormalExit &&
                                 std::find(codes.begin(), codes.end(), code) != codes.end();
            if (is_good) {
              done();
              return;
            }
            QString why = QString::fromUtf8(process->readAllStandardError()).trimmed();
            why.remove("elsie: ");
            fail(why.isEmpty() ? tr("'%1' ended without a message").arg(elsie_) : why);
          });
  connect(process_.get(), &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) {
      const QString why = process_->errorString();
      process_.release()->deleteLater();
      fail(tr("'%1' does not start: %2").arg(elsie_, why));
    }
  });
  process_->start(elsie_, words);
}

/// Says how large it is, and offers to open it. The box does not block the event loop.
void Sharer::show_page() {
  leave();
  constexpr double kMegabyte = 1e6;
  const double size = static_cast<double>(QFileInfo(file_).size()) / kMegabyte;
  auto* box = new QMessageBox(
      QMessageBox::Information, tr("The page is written"),
      tr("'%1' takes %2 MB. It plays the run in any browser, without Elsie and without a network.")
          .arg(file_)
          .arg(size, 0, 'f', 2),
      QMessageBox::Close, window_);
  box->setObjectName("page_written");
  box->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* open = box->addButton(tr("&Open in the browser"), QMessageBox::AcceptRole);
  open->setObjectName("open_page");
  box->setDefaultButton(open);
  connect(open, &QPushButton::clicked, this, [this, file = file_] {
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(file).absoluteFilePath()))) {
      warn(window_, tr("Not opened"),
           tr("No browser opens '%1'. Open it from your browser or file manager.").arg(file),
           "page_not_opened");
    }
  });
  box->open();
  Q_EMIT said(tr("The page is in '%1'").arg(file_));
  Q_EMIT ended(true);
}

void Sharer::fail(const QString& why) {
  if (!folder_) {
    return;
  }
  leave();
  if (!why.isEmpty()) {
    warn(window_, tr("Not shared"),
         tr("The page could not be written to '%1': %2\nWhat was there before is unchanged.")
             .arg(file_, why),
         "page_failed");
  }
  Q_EMIT ended(false);
}

void Sharer::leave() {
  if (process_) {
    process_->disconnect(this);
    process_->kill();
    process_->waitForFinished(kPatienceAtEnd_ms);
    process_.release()->deleteLater();
  }
  if (progress_) {
    progress_->disconnect(this);
    progress_->deleteLater();
  }
  folder_.reset();
}

}  // namespace elsie::desktop
