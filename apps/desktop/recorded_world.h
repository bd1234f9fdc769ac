// The worlds of runs that were recorded, or done in a batch.
#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <optional>

namespace elsie::desktop {

/// Whether the file is a recording (MCAP) or a results database, by how it begins.
bool may_be_run(const QString& file);
bool may_be_database(const QString& file);

struct RecordedWorld {
  QString file;  // a temporary one
  std::uint64_t seed = 1;
};

/// The world as it was when the run began, with the edits that the run was given: `elsie replay
/// --world`. `run`: its number in a database. None, with a sentence, if there is none.
std::optional<RecordedWorld> world_of_run(const QString& elsie, const QStringList& options,
                                          const QString& file, std::optional<int> run,
                                          QString& why);

}  // namespace elsie::desktop
