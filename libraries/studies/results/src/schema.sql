-- The results of one experiment; docs/results-database.md describes them for users who query the database.
-- make_schema() adds the fields of a run, which run_fields.h declares.
-- The plan is written before the first run begins; each run is written in one transaction when it
-- has ended. So a row of `runs` is either pending and empty, or complete.
-- PRAGMA application_id is 0x456C7369 ("Elsi"), PRAGMA user_version the version of this schema.

CREATE TABLE about (                  -- one row
  id             INTEGER PRIMARY KEY CHECK (id = 1),
  elsie_version  TEXT NOT NULL,
  abi            TEXT NOT NULL,       -- the word that plugins must match
  experiment     TEXT NOT NULL,       -- its name
  description    TEXT NOT NULL,
  file           TEXT NOT NULL,       -- as the user named it
  text           TEXT NOT NULL,       -- of the experiment file
  fingerprint    TEXT NOT NULL,       -- SHA-256 over everything that affects the runs: --resume compares it
  shard          TEXT NOT NULL,       -- "2/5": every fifth run, starting at the second; or "1/1"
  runs           INTEGER NOT NULL,    -- of the experiment, in all shards
  wall_limit_s   REAL NOT NULL,       -- on the clock, for one run
  trajectory_period_s REAL NOT NULL,  -- asked for; see trajectories
  created        TEXT NOT NULL        -- UTC, ISO 8601
) STRICT;

CREATE TABLE factors (
  id   INTEGER PRIMARY KEY,           -- in the order of the file; 0 is "world"
  name TEXT NOT NULL UNIQUE
) STRICT;

CREATE TABLE stages (                 -- the experiment as it was begun, and as it was each time that it was extended
  id          INTEGER PRIMARY KEY,    -- from 0
  cells       INTEGER NOT NULL,       -- the cells with lower ids
  seeds       TEXT NOT NULL,          -- "1-20,33"
  repeats     INTEGER NOT NULL,
  runs        INTEGER NOT NULL,       -- of the experiment until then, in all shards: those with ids up to this number
  fingerprint TEXT NOT NULL,          -- as in about
  created     TEXT NOT NULL           -- UTC, ISO 8601
) STRICT;

CREATE TABLE files (                  -- world files, models, training sets, libraries of plugins and of the program
  id      INTEGER PRIMARY KEY,
  kind    TEXT NOT NULL CHECK (kind IN ('data', 'library', 'world')),
  path    TEXT NOT NULL UNIQUE,       -- absolute
  sha256  TEXT NOT NULL,
  content BLOB,                       -- of data files, so that a run can be done again elsewhere
  load_order INTEGER,                 -- of plugin libraries: if two have the same plugin, the first one counts
  CHECK ((kind = 'data') = (content IS NOT NULL))
) STRICT;

CREATE TABLE plugins (
  id      INTEGER PRIMARY KEY,
  kind    TEXT NOT NULL,              -- "behavior", "coordinator", "sensor", "measure", "drive"
  name    TEXT NOT NULL,
  version TEXT NOT NULL,
  file_id INTEGER REFERENCES files(id),
  UNIQUE (kind, name)
) STRICT;

CREATE TABLE cells (
  id         INTEGER PRIMARY KEY,     -- from 0, in the order of the grid; cells that came later come after
  label      TEXT NOT NULL UNIQUE,
  world      TEXT NOT NULL,           -- the id in the experiment
  world_text TEXT NOT NULL,           -- as resolved: templates merged in, settings made
  world_file TEXT NOT NULL,           -- relative names in world_text are relative to its folder
  sha256     TEXT NOT NULL,           -- of world_text
  place      INTEGER NOT NULL DEFAULT 0, -- in the order of the grid, for sorting
  layout_seed INTEGER                 -- the 64 bits as a signed number; null: no layouts, or they follow the seeds of the runs
) STRICT;

CREATE TABLE layouts (                -- of cells whose layouts follow the seeds: the resulting world of each seed
  cell_id    INTEGER NOT NULL REFERENCES cells(id) ON DELETE CASCADE,
  seed       INTEGER NOT NULL,        -- of the runs, as there
  world_text TEXT NOT NULL,           -- that of the first seed is the cell's, too
  sha256     TEXT NOT NULL,           -- of world_text
  PRIMARY KEY (cell_id, seed)
) STRICT;

CREATE TABLE cell_levels (
  cell_id   INTEGER NOT NULL REFERENCES cells(id) ON DELETE CASCADE,
  factor_id INTEGER NOT NULL REFERENCES factors(id),
  label     TEXT NOT NULL,
  place     INTEGER NOT NULL,         -- among the factor's levels, for sorting
  PRIMARY KEY (cell_id, factor_id)
) STRICT;

CREATE TABLE cell_plugins (
  cell_id   INTEGER NOT NULL REFERENCES cells(id) ON DELETE CASCADE,
  plugin_id INTEGER NOT NULL REFERENCES plugins(id),
  PRIMARY KEY (cell_id, plugin_id)
) STRICT;

CREATE TABLE cell_files (             -- data files
  cell_id INTEGER NOT NULL REFERENCES cells(id) ON DELETE CASCADE,
  file_id INTEGER NOT NULL REFERENCES files(id),
  name    TEXT NOT NULL,              -- what world_text calls it
  PRIMARY KEY (cell_id, name)
) STRICT;

CREATE TABLE runs (
  id          INTEGER PRIMARY KEY,    -- from 1, in the order of the grid: cell, seed, repetition; first those of the first stage, then what the second adds...
  cell_id     INTEGER NOT NULL REFERENCES cells(id) ON DELETE CASCADE,
  seed        INTEGER NOT NULL,       -- the 64 bits as a signed number
  repetition  INTEGER NOT NULL,       -- from 1
  {run_fields},                       -- run_fields.h declares them
  ended       TEXT,                   -- UTC, ISO 8601
  UNIQUE (cell_id, seed, repetition),
  CHECK (state IN ('pending', 'done', 'fault', 'crash', 'hang', 'error')),
  CHECK (outcome IN ('success', 'failure', 'time_limit')),
  CHECK ((state = 'pending') = (ended IS NULL)),
  CHECK ((state = 'done') = (outcome IS NOT NULL)),
  CHECK (solver_gave_up BETWEEN 0 AND steps + 1),  -- also counts the step that a fault ended
  CHECK (solver_unsolved BETWEEN 0 AND solver_gave_up)
) STRICT;
CREATE INDEX runs_by_state ON runs (state);

CREATE VIEW run_worlds AS             -- of each run: the seed of its layouts, null without layouts, and its world
  SELECT runs.id AS run_id, coalesce(layouts.seed, cells.layout_seed) AS layout_seed,
         coalesce(layouts.world_text, cells.world_text) AS world_text
  FROM runs JOIN cells ON cells.id = runs.cell_id
  LEFT JOIN layouts ON layouts.cell_id = runs.cell_id AND layouts.seed = runs.seed;

CREATE TABLE measures (               -- what is measured, once for the experiment
  name    TEXT PRIMARY KEY,           -- "path_length_m"
  unit    TEXT NOT NULL,
  meaning TEXT NOT NULL
) STRICT, WITHOUT ROWID;

CREATE TABLE run_measures (           -- of runs that are done
  run_id  INTEGER NOT NULL REFERENCES runs(id) ON DELETE CASCADE,
  measure TEXT NOT NULL REFERENCES measures(name),
  value   REAL,                       -- null: it has none in this run
  PRIMARY KEY (run_id, measure)
) STRICT, WITHOUT ROWID;

CREATE TABLE run_robots (
  run_id     INTEGER NOT NULL REFERENCES runs(id) ON DELETE CASCADE,
  robot      TEXT NOT NULL,
  team       TEXT NOT NULL,
  distance_m REAL NOT NULL,
  collected  INTEGER NOT NULL,
  energy     REAL NOT NULL,
  collisions INTEGER NOT NULL,
  x_m        REAL NOT NULL,
  y_m        REAL NOT NULL,
  heading_rad REAL NOT NULL,
  PRIMARY KEY (run_id, robot)
) STRICT, WITHOUT ROWID;

CREATE TABLE run_events (
  run_id INTEGER NOT NULL REFERENCES runs(id) ON DELETE CASCADE,
  place  INTEGER NOT NULL,
  time_s REAL NOT NULL,
  robot  TEXT NOT NULL,
  name   TEXT NOT NULL,
  detail TEXT NOT NULL,
  PRIMARY KEY (run_id, place)
) STRICT, WITHOUT ROWID;

CREATE TABLE trajectories (
  run_id   INTEGER NOT NULL REFERENCES runs(id) ON DELETE CASCADE,
  robot    TEXT NOT NULL,
  from_s   REAL NOT NULL,             -- simulated time of the first pose: 0, or when an edit added the robot
  period_s REAL NOT NULL,             -- simulated, between two poses
  poses    TEXT NOT NULL,             -- JSON: [[x_m, y_m, heading_rad], ...], millimetres and milliradians
  touches  TEXT NOT NULL,             -- JSON: [[x_m, y_m], ...], where it collided
  PRIMARY KEY (run_id, robot)
) STRICT, WITHOUT ROWID;

CREATE TABLE curves (                 -- learning curves of plugins, from before the run
  run_id  INTEGER NOT NULL REFERENCES runs(id) ON DELETE CASCADE,
  robot   TEXT NOT NULL,
  plugin  TEXT NOT NULL,              -- its id on the robot
  name    TEXT NOT NULL,              -- "error"
  x_label TEXT NOT NULL,
  y_label TEXT NOT NULL,
  points  TEXT NOT NULL,              -- JSON: [[x, y], ...]
  PRIMARY KEY (run_id, robot, plugin, name)
) STRICT, WITHOUT ROWID;

CREATE TABLE timelines (              -- which behaviour decided when, condensed: see docs/explaining-a-run.md
  run_id INTEGER NOT NULL REFERENCES runs(id) ON DELETE CASCADE,
  robot  TEXT NOT NULL,
  behaviors TEXT NOT NULL,            -- JSON: [{"path", "share": mean share in the robot's command, "decided_s"}, ...]
  episodes  TEXT NOT NULL,            -- JSON: [{"from_s", "to_s", "decider", "share"}, ...]; decider: a path, "" nobody, "*" several
  PRIMARY KEY (run_id, robot)
) STRICT, WITHOUT ROWID;

CREATE TABLE notes (                  -- messages of plugins before the run, and of the simulator about its physics (plugin "physics")
  run_id INTEGER NOT NULL REFERENCES runs(id) ON DELETE CASCADE,
  place  INTEGER NOT NULL,
  robot  TEXT NOT NULL,
  plugin TEXT NOT NULL,
  text   TEXT NOT NULL,
  PRIMARY KEY (run_id, place)
) STRICT, WITHOUT ROWID;
