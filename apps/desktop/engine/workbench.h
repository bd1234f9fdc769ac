// What a window works on: a world in an engine, its run, and the undo history.
//
// The workbench holds no world, only the engine's latest description of it. Every change is an
// order; when the engine has carried it out, described() informs all views. workbench.cpp handles
// the engine and its messages, workbench_files.cpp files, workbench_changes.cpp changes,
// workbench_run.cpp the run.
#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <deque>
#include <map>
#include <vector>

#include "engine/catalog.h"
#include "engine/engine.h"
#include "engine/history.h"
#include "engine/problem.h"
#include "engine/recovery.h"
#include "engine/text_form.h"

class QFileSystemWatcher;

namespace elsie::desktop {

using Problems = std::vector<Problem>;

class Workbench : public QObject {
  Q_OBJECT

 public:
  enum class Run { none, ready, running, paused, ended };

  Workbench(QString elsie, QStringList options, QObject* parent = nullptr);
  ~Workbench() override;

  /// @name The world
  /// @{
  QString file() const { return file_; }  // "" without a file
  /// Whether the file belongs to a recording; the world is then saved elsewhere.
  bool is_borrowed() const { return is_borrowed_; }
  /// The present text, valid or not.
  const QString& text() const { return text_; }
  /// Whether the engine has a world of this document; otherwise problems() says why not.
  bool is_right() const { return tree_.is_object(); }
  const Problems& problems() const { return problems_; }
  /// Whether the engine is reading a world; a large one takes some seconds.
  bool is_opening() const { return !under_way_.isEmpty() && tree_.is_null(); }
  /// Warnings about the world and its plugins, as from `elsie check`.
  Problems remarks() const;
  const Json& tree() const { return tree_; }
  const Json& scene() const { return scene_; }
  std::uint64_t epoch() const { return epoch_; }
  const Catalog& catalog() const { return catalog_; }
  /// Whether there are unsaved changes, including edits still waiting for the engine.
  bool is_modified() const;
  /// @}

  /// @name Files
  /// @{
  static constexpr std::uint64_t kFirstSeed = 1;
  /// Opens this text as a new world, which replaces the present one.
  void open_text(const QString& text, const QString& file, bool is_saved = true,
                 bool is_borrowed = false, const QStringList& plugins = {},
                 std::uint64_t seed = kFirstSeed);
  /// Opens a file. Returns false, with a sentence, if it cannot be read; then nothing has changed.
  bool open(const QString& file, QString& why, std::uint64_t seed = kFirstSeed,
            bool is_borrowed = false);
  /// Takes over what another program wrote into the file, as an edit: undo leads back. Returns
  /// false, with a sentence, if it cannot be read.
  bool read_again(QString& why);
  /// Asks the engine for the text with file names that are right in the folder of `file`, writes it
  /// whole or not at all, and calls back once with "" or a sentence. Without an engine, or with
  /// mistakes, the text is written unchanged. Run and history stay.
  void save_as(const QString& file, std::function<void(const QString&)> done);
  /// Whether another program has written the file since it was read or saved.
  bool is_changed_on_disk() const;
  /// Whether another program has removed the file; its text is then unsaved.
  bool is_gone_from_disk() const { return is_gone_; }
  /// Calls back when all changes ordered so far have been made or refused.
  void when_settled(QObject* receiver, std::function<void()> done);
  /// Whether the engine has not accepted the present text, but still has an earlier world.
  bool has_mistakes() const { return tree_.is_object() && text_ != history_text_; }
  /// Whether all unsaved work is in the recovery file.
  bool is_kept() const { return is_kept_; }
  /// Keeps what is typed in a form or dialog, `by`, and not entered yet, with unsaved work.
  void keep_typed(const QObject* by, std::vector<Typed> typed);
  /// Keeps the texts of sources that are changed and not saved.
  void keep_sources(std::vector<Typed> sources);
  /// Opens the work of a window that was not closed properly, and enters what was typed in it.
  void open_recovered(const Recovered& recovered);
  /// The user discards unsaved work.
  void give_up_unsaved();
  /// @}

  /// @name Changes
  /// Changes are made one after another, in the order of the calls.
  /// @{
  /// Receives nothing if a change was made, otherwise the reasons: exactly once, even if the engine
  /// ends before it answers, but never after `receiver` is gone.
  using Done = std::function<void(const Problems&)>;
  /// Makes all of the edits, or none.
  void edit(const QStringList& edits, const QString& name, const QString& merge = {},
            QObject* receiver = nullptr, Done done = {});
  /// Takes the text as the user typed it, valid or not.
  void type(const QString& text);
  void undo();
  void redo();
  /// Adds a plugin, the source of one, or a script, which the engine then follows: what is saved is
  /// loaded. Reports once it is loaded or refused; one that is refused is loaded as soon as it is
  /// right.
  void add_plugin(const QString& file, QObject* receiver, Done done);
  QString undo_name() const;  // "" if there is nothing
  QString redo_name() const;
  /// @}

  /// @name The run
  /// @{
  Run run_state() const { return run_; }
  /// The shown time, s; earlier than the run's while the user looks back.
  double time_s() const { return time_s_; }
  /// The time that the run has reached, s.
  double latest_s() const { return latest_s_; }
  double pace() const { return pace_; }
  std::uint64_t seed() const { return seed_; }
  double speed() const { return speed_; }
  /// Starts or continues the run, up to the time of set_halt() if that is ahead.
  void run();
  /// Runs to that time as fast as possible, then pauses.
  void run_until(double time_s);
  /// Sets where run() pauses, such as the end of a recording. Opening a world removes it.
  void set_halt(std::optional<double> time_s) { halt_s_ = time_s; }
  bool is_at_halt() const;
  void pause();
  void step();
  /// Goes back to the start, with this seed from now on if the engine accepts it.
  void reset(std::uint64_t seed);
  void set_speed(double factor);
  /// Sends any other order: watch, at, record, command.
  void ask(Json order, Engine::Answer answer) { engine_.ask(std::move(order), std::move(answer)); }
  Engine& engine() { return engine_; }
  /// Ends an engine whose plugin does not return.
  void stop_engine();
  /// @}

 Q_SIGNALS:
  /// Views must now pass unfinished input to type() or edit().
  void about_to_change();
  void described();  // the world changed: text, tree, scene
  void problems_changed();
  void catalog_changed();
  void refused(const elsie::desktop::Problems& problems);
  void history_changed();
  void run_changed();
  void settings_changed();                          // another speed, or a seed that is refused
  void went_on();                                   // the run continues, or makes a step
  void came_to(const elsie::desktop::Json& event);  // it has paused at the time it was to run to
  void snapshot(const elsie::snapshots::Snapshot& snapshot);
  void state(const elsie::desktop::Json& state);
  void noted(const QString& note);
  void raised(const elsie::desktop::Json& event);
  void ended(const elsie::desktop::Json& end);
  void stuck(const elsie::desktop::Json& event);  // robots that stand still
  /// The engine ended, by stop_engine() or by itself. It was started again with the same world,
  /// unless engine().is_there() is false; the report says what its plugin did. Waiting edits are
  /// made again; `not_made` has the names of those that are given up.
  void engine_lost(const QString& report, bool was_stopped, const QStringList& not_made);
  void changed_on_disk();
  /// The engine uses new versions of these files; of `kept` the old versions, or none.
  void plugins_changed(const QStringList& files, const QStringList& kept);

 private:
  struct Change {
    std::function<void()> begin;
    QPointer<QObject> receiver;
    bool has_receiver = false;
    Done done;
    bool is_edit = false;
    QString name = {};  // of edits that the text does not have yet
  };

  void start_engine();
  void load_catalog();
  void take_plugins(const Json& event);
  void take_plugin_problems(const Json& event);
  Problems problems_of_plugins() const;
  void heard(const Json& event);
  void lost(int exit_code, const QString& report);
  void keep_as_text(const QString& why);
  void set_run(Run run);
  void set_problems(Problems problems);
  bool is_current(std::uint64_t epoch) const { return epoch >= epoch_; }
  /// Whether the engine is making steps.
  bool is_busy() const { return run_ == Run::running || is_stepping_; }

  void in_turn(std::function<void()> begin, bool is_edit = false, QObject* receiver = nullptr,
               Done done = {}, const QString& name = {});
  void next_change();
  void end_change(const Problems& problems = {});
  QStringList drop_changes(const QString& why);
  std::deque<Change> take_waiting();
  void order(const Json& order, Engine::Answer answer);

  void describe(const Json& answer, const QString& sent);
  void take(const Json& answer, const QString& sent);
  void remember(const QString& name, const QString& merge, const QString& before);
  void lead(const History::Entry& entry, const QString& text, void (History::*done)());
  void open_in_engine(const QString& text);
  void send_typed(const QString& name = tr("type"), const QString& merge = "type");
  void open_as_edit(const QString& text, const QString& name, const QString& merge = {});

  void save_in_turn(const QString& target);
  void save_elsewhere(const QString& target);
  void saved_as(const QString& target, const QString& text);
  QString write(const QString& file, const QString& text);
  bool has_unsaved_text() const { return is_gone_ || text_ != saved_text_; }
  QStringList drafts() const;
  void keep();
  static std::optional<QByteArray> bytes_of_world(const QString& file, QString& why);
  void watch_file();
  void look_at_disk();
  void set_gone(bool is_gone);

  void go(Json order);

  Engine engine_;
  Catalog catalog_;
  /// Plugins whose old versions stay in use until the problem is solved.
  struct PluginProblem {
    Problem problem;
    QStringList plugins;  // none: it is listed until the next event
  };

  QString file_;
  bool is_borrowed_ = false;
  QString text_;
  QString history_text_;                           // the text to which the history leads
  std::optional<QString> saved_text_ = QString();  // none if no file has it
  QByteArray on_disk_;
  bool is_gone_ = false;
  QTimer gone_timer_;  // a program that replaces a file may take it away first
  TextForm form_;
  Json tree_, scene_;
  std::uint64_t epoch_ = 0;
  Problems problems_, warnings_;
  std::vector<PluginProblem> plugin_problems_;
  History history_;
  std::deque<Change> changes_;  // the first is under way if is_changing_
  bool is_changing_ = false;
  QString awaited_;         // the plugin that the engine is to add
  int turn_ = 0;            // counts beginnings and ends of changes
  QString under_way_;       // the text that the engine is reading
  bool had_world_ = false;  // the engine has had a world: plugins may have threads in it
  Run run_ = Run::none;
  double time_s_ = 0.0;
  double latest_s_ = 0.0;
  std::optional<double> halt_s_;
  double pace_ = 0.0;
  double speed_ = 1.0;
  std::uint64_t seed_ = kFirstSeed;
  int deaths_ = 0;            // of the engine since the user last did something
  bool is_stopping_ = false;  // by the user
  bool is_stepping_ = false;  // a step is ordered and not made
  Recovery recovery_;
  std::map<const QObject*, std::vector<Typed>> typed_;
  std::vector<Typed> sources_;
  bool is_kept_ = true;
  std::unique_ptr<QFileSystemWatcher> on_disk_watcher_;
};

Problems problems_of(const Json& answer);

/// The line of an engine's report that says what ended it; plugins may have printed lines before
/// it.
QString cause_in(const QString& report);
/// Whether that line names a plugin.
bool names_plugin(const QString& report);

}  // namespace elsie::desktop
