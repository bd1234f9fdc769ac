// Snapshots: shared memory between who simulates and who draws.
#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/error.h"
#include "elsie/snapshots/snapshots.h"

using namespace elsie;
using namespace elsie::snapshots;

namespace {

std::vector<BodyState> bodies(std::size_t count, double x) {
  return std::vector<BodyState>(count, BodyState::of({.origin = {x, 2.0 * x, 0.5}}));
}

}  // namespace

TEST_CASE("A snapshot is read as it was written, once") {
  SharedMemory memory = SharedMemory::create(10'000);
  SharedMemory same = SharedMemory::open(memory.descriptor());
  Writer writer(memory);
  Reader reader(same);

  CHECK_FALSE(reader.take());
  CHECK(writer.taken());
  const std::vector<MarkState> marks{
      MarkState::of(Sketch::Kind::line, SketchRole::hit, {1, 2, 3}, {4, 5, 6}),
      MarkState::of(Sketch::Kind::text, SketchRole::target, {7, 8, 9}, {7, 8, 9},
                    "a text that is longer than there is room for it")};
  REQUIRE(writer.write({3, 200, 2.0, 0.9, 5}, bodies(2, 1.5), marks));
  CHECK_FALSE(writer.taken());

  const auto snapshot = reader.take();
  REQUIRE(snapshot);
  CHECK(writer.taken());
  CHECK(snapshot->facts.epoch == 3);
  CHECK(snapshot->facts.steps == 200);
  CHECK(snapshot->facts.time_s == 2.0);
  CHECK(snapshot->facts.pace == 0.9);
  CHECK(snapshot->facts.left_out == 5);
  REQUIRE(snapshot->bodies.size() == 2);
  CHECK(snapshot->bodies[1].frame().origin == Vector3{1.5, 3.0, 0.5});
  REQUIRE(snapshot->marks.size() == 2);
  CHECK(snapshot->marks[0].end() == Vector3{4, 5, 6});
  CHECK(snapshot->marks[0].role == SketchRole::hit);
  CHECK(snapshot->marks[1].begin() == Vector3{7, 8, 9});
  CHECK(snapshot->marks[1].text == std::string("a text that is longer than ther"));
  CHECK_FALSE(reader.take());
}

TEST_CASE("The state of a body keeps its frame") {
  const Frame frame = Frame::turned({1.0, -2.0, 0.25}, 2.0, -0.5);
  const Frame found = BodyState::of(frame).frame();
  for (const auto& [one, other] :
       {std::pair{frame.forward, found.forward}, {frame.left, found.left}, {frame.up, found.up}}) {
    CHECK(one.x == Approx(other.x).margin(1e-6));
    CHECK(one.y == Approx(other.y).margin(1e-6));
    CHECK(one.z == Approx(other.z).margin(1e-6));
  }
}

TEST_CASE("The reader gets the latest of several snapshots") {
  SharedMemory memory = SharedMemory::create(10'000);
  Writer writer(memory);
  Reader reader(memory);
  for (std::uint64_t step = 1; step <= 5; ++step) {
    REQUIRE(writer.write({1, step, 0.0, 0.0}, bodies(1, 0.0), {}));
  }
  CHECK(reader.take()->facts.steps == 5);
}

TEST_CASE("A snapshot that does not fit is not written") {
  SharedMemory memory = SharedMemory::create(1);  // a page
  Writer writer(memory);
  Reader reader(memory);
  CHECK_FALSE(writer.write({}, bodies(1000, 0.0), {}));
  CHECK_FALSE(reader.take());
  CHECK(writer.write({}, bodies(10, 0.0), {}));
  CHECK(reader.take()->bodies.size() == 10);
}

TEST_CASE("Only memory for snapshots is opened") {
  CHECK_THROWS_AS(SharedMemory::open(-1), base::Error);
  CHECK_THROWS_WITH(SharedMemory::open(0), Catch::Contains("memory for snapshots"));
}

TEST_CASE("What is read is whole, however fast the writer is") {
  constexpr std::size_t kBodies = 2000;
  constexpr std::uint64_t kSnapshots = 20'000;
  SharedMemory memory = SharedMemory::create(200'000);
  std::atomic<std::uint64_t> written{0};
  std::atomic<bool> done{false};
  std::atomic<std::size_t> taken{0};
  std::thread simulating([&] {
    Writer writer(memory);
    // Until the reader has had its turns, too, which the machine may give it late.
    for (std::uint64_t step = 1; step <= kSnapshots || taken <= 10; ++step) {
      const auto x = static_cast<double>(step % 1000);
      writer.write({1, step, 0.0, 0.0}, bodies(kBodies, x), {});
      written = step;
    }
    done = true;
  });
  Reader reader(memory);
  std::uint64_t last = 0;
  std::size_t torn = 0;
  while (!done || last < written) {
    const auto snapshot = reader.take();
    if (!snapshot) {
      continue;
    }
    ++taken;
    const auto x = static_cast<float>(snapshot->facts.steps % 1000);
    for (const BodyState& body : snapshot->bodies) {
      torn += body.origin[0] != x || body.origin[1] != 2.0F * x ? 1U : 0U;
    }
    torn += snapshot->facts.steps <= last || snapshot->bodies.size() != kBodies ? 1U : 0U;
    last = snapshot->facts.steps;
  }
  simulating.join();
  CHECK(torn == 0);
  CHECK(taken > 10);
}
