// The window with its docks and files. main_window.cpp shows the state of the run,
// main_window_actions.cpp has commands, menus and bars, main_window_docks.cpp the docks,
// main_window_files.cpp files and unsaved work, main_window_plugins.cpp plugins that are written
// here and help, main_window_runs.cpp recorded runs, main_window_connections.cpp the signals that
// the window receives, main_window_looks.cpp the bars, the theme, the language and the palette of
// commands.
#pragma once

#include <QHash>
#include <QMainWindow>
#include <QPointer>

#include "engine/workbench.h"

class QAction;
class QActionGroup;
class QLabel;
class QMessageBox;
class QToolBar;
class QStackedWidget;
class QToolButton;

namespace elsie::desktop {

class Authoring;
class ControlBar;
class CoordinationPanel;
class Exporter;
class FuzzyPanel;
class GraphPanel;
class Past;
class PlotsPanel;
class ProblemsPanel;
class RunReader;
struct Offer;
class SourcesPanel;
struct Recorded;
struct RecordedWorld;
class RunCard;
struct StoredRun;
class SceneView;
class SensorsPanel;
class Sharer;
class StartPage;
class StuckNotice;
class TimeLine;
class VisionPanel;
class WorldEditor;
class WorldTree;
class Properties;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  static constexpr int kWide = 1900;  // px; wide enough for the text next to the view
  static constexpr qint64 kStuck_ms = 3000;

  /// `elsie` is the program with the engine; `options` are its options for plugins.
  MainWindow(const QString& elsie, const QStringList& options, QWidget* parent = nullptr);
  ~MainWindow() override;

  Workbench& workbench() { return workbench_; }
  SceneView& scene() { return *scene_; }
  /// Opens a world, a recording, or a results database, for which it asks which run. Asks about
  /// unsaved work first. Returns false if the user cancels, or if the file cannot be read.
  /// Recordings and databases are read in the background.
  bool open(const QString& file);
  /// The size of a new window: most of a large screen; 1280 x 800 on smaller screens, if it fits
  /// with its `frame`.
  static QSize first_size(const QSize& room, const QSize& frame);
  /// Layouts for three kinds of work: "author", "watch", "train".
  void arrange(const QString& layout);
  /// Offers the unsaved work of windows that were not closed properly. Returns whether this window
  /// continues it, and says so if it stands in the place of another world.
  bool offer_recovered(const QString& instead_of = {});
  /// Asks the user about unsaved work. Tests replace this by an answer.
  enum class Answer { save, discard, cancel };
  std::function<Answer(const QString& question)> ask_about_unsaved;

 protected:
  void closeEvent(QCloseEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// A command of the window, at the end of a menu; null: in none. It is enabled with its group.
  /// Users' keys are stored under its `name`, the object name, which is also that of its icon.
  QAction* command(QMenu* menu, QActionGroup* group, const char* name, const QString& text,
                   const QKeySequence& key, std::function<void()> does, const QString& tip = {});
  QAction* local(QAction* action, Qt::ShortcutContext context);
  void make_menus();
  void fill_file_menu(QMenu* menu);
  void fill_edit_menu(QMenu* menu);
  void fill_add_menu(QMenu* menu);
  void fill_view_menu(QMenu* menu);
  void fill_looks_menus(QMenu* menu);
  void fill_simulation_menu(QMenu* menu);
  void fill_help_menu(QMenu* menu);
  void fill_tool_bars();
  /// Shows words next to the icons where there is room for them.
  void fit_tool_bars();
  void make_status_bar();
  void go_to_next_dock();
  void ask_for_command();
  std::vector<Offer> typed_commands(const QString& typed);
  void show_keys();

  QDockWidget* dock(const char* name, const QString& title, QWidget* widget,
                    Qt::DockWidgetArea area);
  void bring_back(QDockWidget* dock);
  void keep_layout();
  void reset_layout();
  QDockWidget* new_dock(const char* name, const QString& title, QWidget* widget);
  /// All docks, also those of teams.
  QList<QDockWidget*> docks() const;
  QList<WorldTree*> trees() const;
  /// Hides a dock that has nothing to show until it has something.
  void put_away(QDockWidget* dock);
  void put_away_empty();
  void bring_out(QDockWidget* dock);
  /// Brings out the docks for which this state has something.
  void bring_out_filled(const Json& state);
  /// What the engine is asked for to learn whether a dock has something to show.
  void ask_for_fillings(Json& what) const;
  /// The start page has the window to itself; the docks come back with the world.
  void show_page(bool is_start);
  void connect_tree(WorldTree* tree, const QString& team);
  QDockWidget* make_team(const QString& team);
  void make_docks();
  void connect_workbench();
  void connect_views();

  bool may_leave();
  bool save(bool elsewhere);
  bool may_have_mistakes();
  bool is_agreed(const char* name, const QString& title, const QString& question);
  void open_database(const QString& file);
  void read_run(const QString& file, const StoredRun& run);
  void show_recording(Recorded recorded);
  void set_end_of_recording(double time_s);
  /// The recording that runs here; null if another run is shown, or if the world was changed.
  const Recorded* recorded() const;
  /// Says whether a finished run equals the recorded one.
  void compare_with_recording(const Json& end);
  void run_or_pause();
  /// Begins a run at once.
  void run_with(quint64 seed);
  void connect_cards();
  void show_end();
  void write_behavior();
  void use_source(const QString& source, const QString& name);
  void open_source(const QString& file, int line);
  void take_plugins(const QStringList& used, const QStringList& kept);
  void take_saved_model(const QString& file);
  bool may_leave_sources(const QStringList& files);
  bool bring_back_sources(const Recovered& recovered);
  void open_page(const QString& page);
  void open_page_of_selected();
  void show_past();
  void list_events(QMenu* menu);
  void begin_anew(quint64 seed);
  void show_opened(const QString& file);
  void forget_world();
  void begin_world(const std::function<QString()>& text);
  void show_start();
  void show_state();
  void show_pose();
  void show_lock();
  void show_title();
  /// Enables the commands that need a world only while there is one, and names what undo undoes.
  void enable_commands();
  void show_teams();
  void show_recent();
  void note_recent(const QString& file);
  /// Asks the engine only for what the window shows.
  void watch();
  /// Likewise for the stored past.
  void request_past();
  void show_looked_back();
  /// Shows what is stored of the shown time.
  void show_instant();
  /// Shows weights, speed and energy in trees and Properties.
  void show_values(const Json& state);
  void watch_robot(const QString& id);
  void enter_what_is_typed();
  /// Whether a problem's file is the text of the world.
  bool is_of_world(const QString& file) const;
  void show_problems();
  QString notice() const;
  void say_that_the_engine_ended(const QString& report, bool was_stopped,
                                 const QStringList& not_made);
  void go_to(const QString& file, int line);
  void say(const QString& text);
  void ask_about_disk();

  void show_selection(const QStringList& paths);
  void about();

  QString elsie_;
  QStringList options_;
  Workbench workbench_;
  Past* past_;
  Authoring* authoring_;
  Exporter* exporter_;
  Sharer* sharer_;
  QStackedWidget* centre_;
  SceneView* scene_;
  RunCard* run_card_;
  StuckNotice* stuck_notice_;
  StartPage* start_;
  TimeLine* time_line_;
  ControlBar* control_bar_;
  QToolBar* tools_;
  QToolBar* environment_;
  WorldTree* world_tree_;
  struct Team {
    WorldTree* tree = nullptr;
    QDockWidget* dock = nullptr;
  };
  QHash<QString, Team> teams_;
  QStringList teams_shown_;   // in their order
  QSet<QString> idle_teams_;  // usual ones whose windows give way
  struct Docks {
    QDockWidget *world, *properties, *coordination, *plots, *text, *problems, *vision, *fuzzy,
        *sensors, *graph, *source;
  };
  QSet<QDockWidget*> away_;           // not closed by the user, but empty
  QSet<QDockWidget*> filled_;         // have had something to show in this world
  QList<QDockWidget*> behind_start_;  // hidden while the start page has the window
  QStringList in_front_;              // the names of the docks in front
  QDockWidget* first_ = nullptr;      // comes to the front when it comes by itself
  bool is_start_shown_ = false;
  bool is_start_wished_ = false;  // although there is a world
  int worded_px_ = 0;             // the width of the environment bar with words
  Docks docks_{};
  Properties* properties_;
  WorldEditor* editor_;
  ProblemsPanel* problems_;
  CoordinationPanel* coordination_;
  PlotsPanel* plots_;
  VisionPanel* vision_;
  FuzzyPanel* fuzzy_;
  SensorsPanel* sensors_;
  GraphPanel* graph_;
  SourcesPanel* sources_;
  /// New behaviours by their sources, and the robots that get them once they are loaded.
  struct ToRobot {
    QString name, robot;
  };
  QHash<QString, ToRobot> to_robots_;
  /// The commands that are used outside of their menus, in the order of these.
  struct Actions {
    QAction *new_world, *open, *save;
    QAction *undo, *redo, *cut, *copy, *paste, *remove, *lock;
    QAction *add_robot, *add_sensor, *behaviors, *coordinator, *add_resource, *add_charger,
        *add_nest, *add_lamp, *add_patch;
    QList<QAction*> obstacles;
    QAction *measure, *status_bar;
    QAction *run, *step, *reset;
  };
  Actions actions_{};
  QList<QAction*> commands_;  // all
  QActionGroup* with_world_;  // the commands that need a world
  QActionGroup* with_text_;   // those that need the text of one, right or not
  QToolButton* boxes_;
  QMenu* recent_;
  QPointer<QMessageBox> engine_lost_, changed_on_disk_;
  QLabel* time_label_;
  QLabel* pace_label_;
  QLabel* seed_label_;
  QLabel* outcome_label_;
  QString outcome_;
  QString opening_;  // shown in the status bar until the world is open
  QLabel* recording_label_;
  RunReader* runs_;
  std::unique_ptr<Recorded> recorded_;
  Problems problems_shown_;
  QString failure_;        // of the run
  bool is_stuck_ = false;  // the engine does not answer
  bool is_seed_asked_ = false;
  QByteArray default_state_;
  QSet<const QDockWidget*> seen_;  // the docks in front
  QString watched_;                // what the engine was last asked to send
  QString watched_robot_;          // the robot in the panels that show one robot
  QStringList plottable_;          // the robots whose numbers are offered; none: all
  bool was_shown_ = false;
};

}  // namespace elsie::desktop
