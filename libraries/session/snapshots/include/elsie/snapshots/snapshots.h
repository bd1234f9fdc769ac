// Snapshots of all positions, passed from the simulating process to the drawing process in shared
// memory.
//
// Three buffers are exchanged (triple buffering): one is written, one is read, one is ready for the
// reader. Neither side waits for the other. A killed writer leaves the last complete snapshot.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "elsie/api/geometry.h"
#include "elsie/api/sketch.h"

namespace elsie::snapshots {

/// The frame of a body without `up`, which follows from the other two axes.
struct BodyState {
  float origin[3];
  float forward[3];
  float left[3];
  float present = 1.0F;  // 0: removed, such as a collected resource

  static BodyState of(const Frame& frame);
  Frame frame() const;
};

/// A part of what a plugin draws, in the world, m: a point, a piece of a line, an arrow or a text.
struct MarkState {
  static constexpr std::size_t kMostText = 31;  // bytes

  float from[3];
  float to[3];  // of a point and a text: from
  Sketch::Kind kind = Sketch::Kind::points;
  SketchRole role = SketchRole::range;
  std::uint16_t unused = 0;
  char text[kMostText + 1] = {};  // ends with 0

  static MarkState of(Sketch::Kind kind, SketchRole role, const Vector3& from, const Vector3& to,
                      std::string_view text = {});
  Vector3 begin() const { return {from[0], from[1], from[2]}; }
  Vector3 end() const { return {to[0], to[1], to[2]}; }
};

/// The data of a snapshot before its lists.
struct SnapshotFacts {
  std::uint64_t epoch = 0;  // the number of the scene to which the bodies belong
  std::uint64_t steps = 0;
  double time_s = 0.0;         // simulated
  double pace = 0.0;           // recent simulated seconds per second on the clock
  std::uint64_t left_out = 0;  // marks for which a snapshot has no room
};

/// A snapshot in the shared memory.
struct Snapshot {
  SnapshotFacts facts;
  std::span<const BodyState> bodies;
  std::span<const MarkState> marks;
};

/// Memory that two processes share by a file descriptor. It only occupies pages that were written.
class SharedMemory {
 public:
  /// Creates memory for snapshots of up to `most` bytes each. Throws base::Error.
  static SharedMemory create(std::size_t most);
  /// Opens the memory of a descriptor from create(), which stays open. Throws base::Error.
  static SharedMemory open(int descriptor);
  SharedMemory(SharedMemory&& other) noexcept;
  SharedMemory& operator=(SharedMemory&&) = delete;
  ~SharedMemory();

  /// The descriptor for another process. This object closes it if it was made by create().
  int descriptor() const { return descriptor_; }

 private:
  friend class Writer;
  friend class Reader;
  SharedMemory(int descriptor, bool owned, std::size_t bytes);
  std::size_t most() const;  // bytes of a buffer

  int descriptor_ = -1;
  bool owned_ = false;
  std::size_t bytes_ = 0;
  std::byte* begin_ = nullptr;
};

/// Writes snapshots. The memory must outlive it.
class Writer {
 public:
  explicit Writer(SharedMemory& memory);

  /// Whether the reader has taken the last snapshot. Until then, another one is not needed.
  bool taken() const;
  /// Writes a snapshot. Returns false and does nothing if the memory is too small.
  bool write(const SnapshotFacts& facts, std::span<const BodyState> bodies,
             std::span<const MarkState> marks);

 private:
  SharedMemory& memory_;
  std::uint32_t mine_ = 0;
};

/// Reads snapshots. The memory must outlive it.
class Reader {
 public:
  explicit Reader(SharedMemory& memory);

  /// The last snapshot if it is new, else none. Valid until the next call.
  std::optional<Snapshot> take();

 private:
  SharedMemory& memory_;
  std::uint32_t mine_ = 1;
};

}  // namespace elsie::snapshots
