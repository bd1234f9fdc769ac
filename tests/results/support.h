// A database with a few runs, made by hand.
#pragma once

#include <string>

#include "elsie/results/database_file.h"
#include "elsie/results/hash.h"

#include "../batch/tables.h"
#include "folder.h"

namespace elsie::test {

/// A list of poses that takes several pages of the file.
inline std::string long_list(int run) {
  std::string list = "[";
  for (int i = 0; i < 700; ++i) {
    list += (i > 0 ? ",[" : "[") + std::to_string(run) + "." + std::to_string(i) + ",-0.5,0.125]";
  }
  return list + "]";
}

/// Two cells, a data file, and runs with ways and timelines.
inline std::string made_database(const Folder& folder, const std::string& name = "r.sqlite",
                                 int runs = 10) {
  const std::string file = folder.file(name);
  auto connection = results::make_database(file);
  results::sqlite::Transaction transaction(connection);
  results::make_schema(connection);
  connection.run(
      "INSERT INTO about VALUES (1, '1.2.3', 'abi', 'made', '', 'e.xml', '<experiment/>', 'f00d', "
      "'1/1', 10, 60, 0.1, '2026-01-01T00:00:00Z')");
  results::sqlite::Statement cell(connection,
                                  "INSERT INTO cells VALUES (?, ?, 'w', ?, '/w', ?, 0, NULL)");
  for (std::int64_t i = 0; i < 2; ++i) {
    const std::string world =
        "<world>" + std::to_string(i) + std::string(6000, ' ') + "</world>" + std::to_string(i);
    cell.run(i, "cell " + std::to_string(i), world, results::sha256(world));
  }
  results::sqlite::Statement(connection,
                             "INSERT INTO files VALUES (1, 'data', '/model', ?, ?, NULL)")
      .run(results::sha256("a model"), results::sqlite::Bytes{"a model"});
  results::sqlite::Statement run(connection,
                                 "INSERT INTO runs (id, cell_id, seed, repetition, state, outcome, "
                                 "ended) VALUES (?, ?, ?, 1, 'done', 'success', 'now')");
  results::sqlite::Statement way(connection,
                                 "INSERT INTO trajectories VALUES (?, 'r1', 0, 0.1, ?, '[]')");
  results::sqlite::Statement timeline(
      connection, "INSERT INTO timelines VALUES (?, 'r1', '[{\"path\":\"wander\"}]', '[]')");
  for (std::int64_t i = 1; i <= runs; ++i) {
    run.run(i, i % 2, i);
    way.run(i, long_list(static_cast<int>(i)));
    timeline.run(i);
  }
  transaction.commit();
  return file;
}

/// Why a file is refused; "" if it is not.
inline std::string refusal(const std::string& file) {
  try {
    results::open_to_read(file);
  } catch (const results::DatabaseRefused& error) {
    return error.what();
  }
  return "";
}

}  // namespace elsie::test
