// The worlds of runs that were recorded, or made in a batch.
#pragma once

#include <QObject>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

class QDialog;

namespace elsie::desktop {

/// Whether the file is a recording (MCAP) or a results database, judged by its first bytes.
bool may_be_run(const QString& file);
bool may_be_database(const QString& file);

/// Whether the file is the table of a run (CSV), which contains no world, judged by its first
/// bytes.
bool may_be_table(const QString& file);

/// How a run ended.
struct RecordedEnd {
  double time_s = 0.0;  // 0: unknown
  qint64 steps = 0;     // 0: unknown
  QString state_hash;   // 16 hexadecimal digits; "": unknown
  bool is_cut = false;  // a run of its world continues there: --duration, Ctrl-C, a crash
};

struct RecordedWorld {
  QString file;  // in `folder`
  std::uint64_t seed = 1;
  RecordedEnd end;
  std::shared_ptr<QTemporaryDir> folder;  // deleted after the last use, if it has no other files
  bool is_whole = true;                   // its file has an end
};

/// The recording that a window plays.
struct Recorded {
  QString source;  // the recording, or a database of results
  int run = 0;     // its number in the database; 0: a recording
  QString title;
  RecordedWorld world;
  QString text;     // the world's text when it was opened
  QString verdict;  // on the run that was made here; "" before it has ended
};

/// The events of a recording, with their times in s, and its end.
struct RecordedEvents {
  std::vector<std::pair<double, QString>> events;
  double end_s = 0.0;
};

struct StoredRun {
  int number = 0;
  QString world, seed, outcome;
  RecordedEnd end;
};

/// Reads recordings and databases with the program elsie, in the background. It reads one file at a
/// time: a new request replaces the previous one, which then calls nothing back.
class RunReader : public QObject {
  Q_OBJECT

 public:
  /// `options` are the options for plugins.
  RunReader(QString elsie, QStringList options, QObject* parent = nullptr);
  ~RunReader() override;

  /// Reads the world as it was when the run began, including the edits that the run received. `run`
  /// is its number in a database, 0 for a recording.
  void read_world(const QString& file, int run, std::function<void(const RecordedWorld&)> done);
  void read_events(const QString& recording, std::function<void(const RecordedEvents&)> done);
  void list_runs(const QString& database, std::function<void(const std::vector<StoredRun>&)> done);
  void stop();

 Q_SIGNALS:
  /// `why` is a sentence.
  void failed(const QString& why);

 private:
  void start(const QStringList& words, std::function<void(QProcess& ended)> done);

  QString elsie_;
  QStringList options_;
  std::unique_ptr<QProcess> process_;
};

/// Asks which run of a database to open, and lists each with its world, seed and outcome. The
/// dialog is shown, and deletes itself.
QDialog* ask_for_run(const std::vector<StoredRun>& runs, QWidget* parent,
                     std::function<void(const StoredRun& run)> done);

}  // namespace elsie::desktop
