#include "elsie/snapshots/snapshots.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "elsie/base/error.h"

namespace elsie::snapshots {
namespace {

constexpr std::uint64_t kMagic = 0x656c73696530320a;
constexpr std::uint32_t kBuffers = 3;
constexpr std::uint32_t kFresh = 4;  // a flag that is added to the number of the ready buffer
constexpr std::size_t kPage = 4096;

/// The head of the memory; the buffers follow on pages of their own.
struct Head {
  std::uint64_t magic = kMagic;
  std::uint64_t most = 0;               // bytes of a buffer
  std::atomic<std::uint32_t> ready{2};  // the buffer between the two, and kFresh
};
static_assert(std::atomic<std::uint32_t>::is_always_lock_free && sizeof(Head) <= kPage);

/// The head of a buffer.
struct Sizes {
  std::uint64_t bodies = 0;
  std::uint64_t marks = 0;
  SnapshotFacts facts;
};

/// Whether a buffer of `most` bytes has room for these numbers. No product overflows.
bool fits(std::size_t bodies, std::size_t marks, std::size_t most) {
  return bodies <= most / sizeof(BodyState) && marks <= most / sizeof(MarkState) &&
         sizeof(Sizes) + bodies * sizeof(BodyState) + marks * sizeof(MarkState) <= most;
}

[[noreturn]] void fail(const std::string& what) {
  throw base::Error("memory for snapshots cannot be " + what + ": " + std::strerror(errno));
}

Head& head_of(std::byte* begin) { return *reinterpret_cast<Head*>(begin); }
std::byte* buffer_of(std::byte* begin, std::uint32_t index, std::size_t most) {
  return begin + kPage + index * most;
}

void put(float (&to)[3], const Vector3& from) {
  to[0] = static_cast<float>(from.x);
  to[1] = static_cast<float>(from.y);
  to[2] = static_cast<float>(from.z);
}
Vector3 vector(const float (&from)[3]) { return {from[0], from[1], from[2]}; }

}  // namespace

BodyState BodyState::of(const Frame& frame) {
  BodyState state;
  put(state.origin, frame.origin);
  put(state.forward, frame.forward);
  put(state.left, frame.left);
  return state;
}

MarkState MarkState::of(Sketch::Kind kind, SketchRole role, const Vector3& from, const Vector3& to,
                        std::string_view text) {
  MarkState mark;
  put(mark.from, from);
  put(mark.to, to);
  mark.kind = kind;
  mark.role = role;
  text.copy(mark.text, kMostText);
  return mark;
}

Frame BodyState::frame() const {
  const Vector3 f = vector(forward), l = vector(left);
  return {
      vector(origin), f, l, {f.y * l.z - f.z * l.y, f.z * l.x - f.x * l.z, f.x * l.y - f.y * l.x}};
}

SharedMemory SharedMemory::create(std::size_t most) {
  most = (std::max(most, sizeof(Sizes)) + kPage - 1) / kPage * kPage;
  const std::size_t bytes = kPage + kBuffers * most;
  const int descriptor = memfd_create("elsie-snapshots", MFD_CLOEXEC);
  if (descriptor < 0) {
    fail("made");
  }
  SharedMemory memory(descriptor, true, 0);
  if (ftruncate(descriptor, static_cast<off_t>(bytes)) != 0) {
    fail("made");
  }
  SharedMemory mapped(std::exchange(memory.descriptor_, -1), true, bytes);
  auto* head = new (mapped.begin_) Head;
  head->most = most;
  return mapped;
}

SharedMemory SharedMemory::open(int descriptor) {
  struct stat facts {};
  if (fstat(descriptor, &facts) != 0) {
    fail("opened");
  }
  SharedMemory memory(descriptor, false, static_cast<std::size_t>(facts.st_size));
  if (memory.bytes_ < kPage || head_of(memory.begin_).magic != kMagic ||
      memory.bytes_ != kPage + kBuffers * head_of(memory.begin_).most) {
    errno = EINVAL;
    fail("opened");
  }
  return memory;
}

// Does not use the number in the head, which the other process can overwrite.
std::size_t SharedMemory::most() const { return (bytes_ - kPage) / kBuffers; }

SharedMemory::SharedMemory(int descriptor, bool owned, std::size_t bytes)
    : descriptor_(descriptor), owned_(owned), bytes_(bytes) {
  if (bytes == 0) {
    return;
  }
  void* begin = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  if (begin == MAP_FAILED) {
    if (owned) {
      close(descriptor);
    }
    fail("mapped");
  }
  begin_ = static_cast<std::byte*>(begin);
}

SharedMemory::SharedMemory(SharedMemory&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      owned_(other.owned_),
      bytes_(other.bytes_),
      begin_(std::exchange(other.begin_, nullptr)) {}

SharedMemory::~SharedMemory() {
  if (begin_) {
    munmap(begin_, bytes_);
  }
  if (owned_ && descriptor_ >= 0) {
    close(descriptor_);
  }
}

Writer::Writer(SharedMemory& memory) : memory_(memory) {}

bool Writer::taken() const {
  return (head_of(memory_.begin_).ready.load(std::memory_order_acquire) & kFresh) == 0;
}

bool Writer::write(const SnapshotFacts& facts, std::span<const BodyState> bodies,
                   std::span<const MarkState> marks) {
  Head& head = head_of(memory_.begin_);
  if (!fits(bodies.size(), marks.size(), memory_.most())) {
    return false;
  }
  std::byte* to = buffer_of(memory_.begin_, mine_, memory_.most());
  const Sizes sizes{bodies.size(), marks.size(), facts};
  std::memcpy(to, &sizes, sizeof(sizes));
  to += sizeof(sizes);
  std::copy(bodies.begin(), bodies.end(), reinterpret_cast<BodyState*>(to));
  std::copy(marks.begin(), marks.end(), reinterpret_cast<MarkState*>(to + bodies.size_bytes()));
  mine_ = head.ready.exchange(mine_ | kFresh, std::memory_order_acq_rel) % kFresh % kBuffers;
  return true;
}

Reader::Reader(SharedMemory& memory) : memory_(memory) {}

std::optional<Snapshot> Reader::take() {
  Head& head = head_of(memory_.begin_);
  if ((head.ready.load(std::memory_order_acquire) & kFresh) == 0) {
    return std::nullopt;
  }
  mine_ = head.ready.exchange(mine_, std::memory_order_acq_rel) % kFresh % kBuffers;
  const std::byte* from = buffer_of(memory_.begin_, mine_, memory_.most());
  Sizes sizes;
  std::memcpy(&sizes, from, sizeof(sizes));
  if (!fits(sizes.bodies, sizes.marks, memory_.most())) {
    return std::nullopt;  // the writer has written invalid data
  }
  const auto* bodies = reinterpret_cast<const BodyState*>(from + sizeof(sizes));
  const auto* marks = reinterpret_cast<const MarkState*>(bodies + sizes.bodies);
  return Snapshot{sizes.facts, {bodies, sizes.bodies}, {marks, sizes.marks}};
}

}  // namespace elsie::snapshots
