// Where everything is, from the process that simulates to the one that draws, in memory that both
// share.
//
// Three buffers change hands: one is written, one is read, one lies ready between them. Neither
// side ever waits for the other, and a writer that is killed leaves the last whole snapshot.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "elsie/api/geometry.h"

namespace elsie::snapshots {

/// Where a body is: a frame without its `up`, which follows.
struct BodyState {
  float origin[3];
  float forward[3];
  float left[3];
  float present = 1.0F;  // 0: not there any more, as a collected resource

  static BodyState of(const Frame& frame);
  Frame frame() const;
};

/// A ray of a range sensor, in the world, m.
struct BeamState {
  float from[3];
  float to[3];
  std::uint32_t robot = 0;  // its index in the world
  std::uint32_t hit = 0;
};

/// What stands before the lists of a snapshot.
struct SnapshotFacts {
  std::uint64_t epoch = 0;  // counts the scenes: the bodies are those of this one
  std::uint64_t steps = 0;
  double time_s = 0.0;  // simulated
  double pace = 0.0;    // simulated seconds per second on the clock, lately
};

/// A snapshot in the shared memory.
struct Snapshot {
  SnapshotFacts facts;
  std::span<const BodyState> bodies;
  std::span<const BeamState> beams;
};

/// Memory that two processes share, by its file descriptor. It takes no more than was written.
class SharedMemory {
 public:
  /// Memory for snapshots of up to `most` bytes each. Throws base::Error.
  static SharedMemory create(std::size_t most);
  /// The memory behind a descriptor of create(), which stays open. Throws base::Error.
  static SharedMemory open(int descriptor);
  SharedMemory(SharedMemory&& other) noexcept;
  SharedMemory& operator=(SharedMemory&&) = delete;
  ~SharedMemory();

  /// To hand to another process; closed with this object if it made it.
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

/// The one who writes. The memory must outlive it.
class Writer {
 public:
  explicit Writer(SharedMemory& memory);

  /// Whether the last snapshot has been taken: until then another one is in vain.
  bool taken() const;
  /// False, and nothing happens, if the memory is too small.
  bool write(const SnapshotFacts& facts, std::span<const BodyState> bodies,
             std::span<const BeamState> beams);

 private:
  SharedMemory& memory_;
  std::uint32_t mine_ = 0;
};

/// The one who reads. The memory must outlive it.
class Reader {
 public:
  explicit Reader(SharedMemory& memory);

  /// The last snapshot if it is a new one, valid until the next call.
  std::optional<Snapshot> take();

 private:
  SharedMemory& memory_;
  std::uint32_t mine_ = 1;
};

}  // namespace elsie::snapshots
