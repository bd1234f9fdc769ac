#include "recorded_world.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QHeaderView>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "engine/elements.h"
#include "engine/workbench.h"

namespace elsie::desktop {
namespace {

constexpr int kSplit_ms = 500;  // the time that a process has to end

bool begins_with(const QString& file, const QByteArray& mark) {
  QFile opened(file);
  return QFileInfo(file).isFile() && opened.open(QIODevice::ReadOnly) &&
         opened.read(mark.size()) == mark;
}

/// The cells of a line of a table; some are between quotation marks.
QStringList cells_of(const QString& line) {
  QStringList cells{QString()};
  bool is_quoted = false;
  for (const QChar c : line) {
    if (c == u'"') {
      is_quoted = !is_quoted;
    } else if (c == u',' && !is_quoted) {
      cells << QString();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

std::vector<StoredRun> runs_in(const QString& table) {
  std::vector<StoredRun> runs;
  QFile file(table);
  if (!file.open(QIODevice::ReadOnly)) {
    return runs;
  }
  const QStringList lines = QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts);
  const QStringList names = cells_of(lines.value(0));
  for (const QString& line : lines.mid(1)) {
    const QStringList cells = cells_of(line);
    const auto cell = [&](const char* name) { return cells.value(names.indexOf(name)); };
    if (const int number = cell("run").toInt(); number > 0) {
      const QString outcome = cell("outcome");
      runs.push_back({number,
                      cell("cell"),
                      cell("seed"),
                      outcome.isEmpty() ? cell("state") : outcome,
                      {cell("simulated_s").toDouble(), cell("steps").toLongLong(),
                       cell("state_hash"), cell("state") != "done"}});
    }
  }
  return runs;
}

/// Reads what `elsie replay --json` says about the end of a run; for a run of a database that
/// contains no outcome.
RecordedEnd end_in(const Json& said) {
  const auto outcome = said.find("outcome");
  const auto duration = said.find("duration_s");
  const bool is_stopped =
      outcome != said.end() && (outcome->is_null() || *outcome == Json("stopped"));
  return {0.0, said.value("steps", qint64{0}), text_of(said, "state_hash"),
          is_stopped || (duration != said.end() && !duration->is_null())};
}

RecordedEvents events_in(const QByteArray& answer) {
  RecordedEvents recorded;
  const Json json = Json::parse(answer.toStdString(), nullptr, false);
  if (!json.is_object()) {
    return recorded;
  }
  recorded.end_s = json.value("end_s", 0.0);
  for (const Json& robot : member(json, "robots")) {
    const QString id = text_of(robot, "id");
    for (const Json& event : member(robot, "events")) {
      recorded.events.emplace_back(event.value("time_s", 0.0), id + ' ' + text_of(event, "name"));
    }
  }
  return recorded;
}

}  // namespace

bool may_be_database(const QString& file) {
  // https://www.sqlite.org/fileformat.html, "The Database Header"
  return begins_with(file, QByteArray("SQLite format 3\0", 16));
}

bool may_be_run(const QString& file) {
  // https://mcap.dev/spec, "Magic"
  return may_be_database(file) || begins_with(file, "\x89MCAP0\r\n") ||
         (file.endsWith(".mcap") && QFileInfo(file).isFile());
}

bool may_be_table(const QString& file) { return begins_with(file, "time_s,robot,"); }

RunReader::RunReader(QString elsie, QStringList options, QObject* parent)
    : QObject(parent), elsie_(std::move(elsie)), options_(std::move(options)) {}

RunReader::~RunReader() { stop(); }

void RunReader::stop() {
  if (process_) {
    process_->disconnect(this);
    process_->kill();
    process_->waitForFinished(kSplit_ms);
    process_.reset();
  }
}

void RunReader::start(const QStringList& words, std::function<void(QProcess&)> done) {
  stop();
  process_ = std::make_unique<QProcess>();
  process_->setStandardInputFile(QProcess::nullDevice());
  connect(process_.get(), &QProcess::finished, this, [this, done = std::move(done)] {
    const std::unique_ptr<QProcess, void (*)(QProcess*)> ended(
        process_.release(), [](QProcess* each) { each->deleteLater(); });
    done(*ended);
  });
  connect(process_.get(), &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) {
      const QString why = process_->errorString();
      process_.release()->deleteLater();
      Q_EMIT failed(tr("'%1' does not start: %2").arg(elsie_, why));
    }
  });
  process_->start(elsie_, words);
}

void RunReader::read_world(const QString& file, int run,
                           std::function<void(const RecordedWorld&)> done) {
  // Other files that were put next to the world, such as weights, stay.
  const std::shared_ptr<QTemporaryDir> folder(new QTemporaryDir, [](QTemporaryDir* each) {
    each->setAutoRemove(
        QDir(each->path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).size() <= 1);
    delete each;
  });
  RecordedWorld world{
      folder->filePath(QFileInfo(file).completeBaseName() + ".xml"), 1, {}, folder, true};
  QStringList words{"replay", file};
  if (run > 0) {
    words << QString::number(run);
  }
  start(words + QStringList{"--json", "--world", world.file} + options_,
        [this, world, done = std::move(done)](QProcess& replay) mutable {
          if (replay.exitStatus() != QProcess::NormalExit || replay.exitCode() != 0 ||
              !QFileInfo::exists(world.file)) {
            Q_EMIT failed(cause_in(QString::fromUtf8(replay.readAllStandardError())));
            return;
          }
          const Json said =
              Json::parse(replay.readAllStandardOutput().toStdString(), nullptr, false);
          if (!said.is_object()) {
            Q_EMIT failed(tr("'%1' did not report what it read from the recording. Install it "
                             "and this window again, from the same version.")
                              .arg(elsie_));
            return;
          }
          world.seed = said.value("seed", std::uint64_t{1});
          world.end = end_in(said);
          world.is_whole = said.value("complete", true);
          done(world);
        });
}

void RunReader::read_events(const QString& recording,
                            std::function<void(const RecordedEvents&)> done) {
  start({"explain", recording, "--json"}, [done = std::move(done)](QProcess& explain) {
    done(events_in(explain.readAllStandardOutput()));
  });
}

void RunReader::list_runs(const QString& database,
                          std::function<void(const std::vector<StoredRun>&)> done) {
  const auto folder = std::make_shared<QTemporaryDir>();
  const QString table = folder->filePath("runs.csv");
  start({"report", database, "--csv", table, "--quiet"},
        [this, folder, table, done = std::move(done)](QProcess& report) {
          const std::vector<StoredRun> runs = runs_in(table);
          if (runs.empty()) {
            const QString why = cause_in(QString::fromUtf8(report.readAllStandardError()));
            Q_EMIT failed(why.isEmpty() ? tr("There are no runs in this database.") : why);
            return;
          }
          done(runs);
        });
}

QDialog* ask_for_run(const std::vector<StoredRun>& runs, QWidget* parent,
                     std::function<void(const StoredRun&)> done) {
  auto* dialog = new QDialog(parent);
  dialog->setObjectName("run_dialog");
  dialog->setWindowTitle(RunReader::tr("Open a run"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  auto* column = new QVBoxLayout(dialog);
  auto* list = new QTreeWidget;
  list->setObjectName("runs");
  list->setAccessibleName(RunReader::tr("Runs of the database"));
  list->setHeaderLabels({RunReader::tr("Run"), RunReader::tr("Settings"), RunReader::tr("Seed"),
                         RunReader::tr("Outcome")});
  list->setRootIsDecorated(false);
  for (const StoredRun& run : runs) {
    auto* item = new QTreeWidgetItem(list, {{}, run.world, run.seed, run.outcome});
    item->setData(0, Qt::DisplayRole, run.number);
  }
  list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list->setSortingEnabled(true);
  list->sortByColumn(0, Qt::AscendingOrder);
  list->setCurrentItem(list->topLevelItem(0));
  column->addWidget(list);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
  buttons->setObjectName("buttons");
  column->addWidget(buttons);
  QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  QObject::connect(list, &QTreeWidget::itemDoubleClicked, dialog, &QDialog::accept);
  QObject::connect(dialog, &QDialog::accepted, parent, [list, runs, done = std::move(done)] {
    const QTreeWidgetItem* item = list->currentItem();
    const int number = item ? item->data(0, Qt::DisplayRole).toInt() : 0;
    for (const StoredRun& run : runs) {
      if (run.number == number) done(run);
    }
  });
  dialog->resize(560, 420);
  dialog->open();
  return dialog;
}

}  // namespace elsie::desktop
