// Shares a run as a page that any browser plays: docs/run-page.md.
#pragma once

#include <QObject>
#include <QPointer>
#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>
#include <functional>
#include <memory>

#include "engine/json.h"

class QProgressDialog;
class QWidget;

namespace elsie::desktop {

class Workbench;
struct Recorded;

/// The program elsie writes the page, in the background. A run that was made here, or that a
/// database has, is made again first, with all its edits: the same world and seed give the same
/// run.
class Sharer : public QObject {
  Q_OBJECT

 public:
  /// `elsie` is the program; `options` say where it finds plugins. `window` owns this object and
  /// the dialogs.
  Sharer(Workbench& workbench, QString elsie, QStringList options, QWidget* window);
  ~Sharer() override;

  /// Asks for the file. `recorded`: the recording that is played; null for a run made here.
  void share(const Recorded* recorded);
  /// Writes the page of a recording, of a run of a database, or of the run made here, up to now. A
  /// file that was there is only replaced by a whole page.
  void write(const QString& file, const Recorded* recorded);

 Q_SIGNALS:
  void said(const QString& sentence);
  void ended(bool is_whole);

 private:
  /// Runs elsie with these words. Then `done`, or, with an exit code that is not among these,
  /// end().
  void start(const QStringList& words, std::initializer_list<int> good, std::function<void()> done);
  void repeat(const Json& command);
  void make_page(const QString& recording);
  void show_page();
  /// `why`: a sentence; "": the user has cancelled it.
  void fail(const QString& why);
  void leave();

  Workbench& workbench_;
  QString elsie_;
  QStringList options_;
  QWidget* window_;

  QString file_;
  std::unique_ptr<QTemporaryDir> folder_;  // while a page is written
  std::unique_ptr<QProcess> process_;
  QPointer<QProgressDialog> progress_;
  QString data_path_;  // where files of the world are searched, too
  double until_s_ = 0.0;
  int number_ = 0;  // answers to orders for another page are ignored
};

}  // namespace elsie::desktop
