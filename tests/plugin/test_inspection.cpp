#include <algorithm>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <elf.h>
#include <sys/mman.h>
#include <unistd.h>

#include "elsie/base/random.h"
#include "elsie/plugin/abi_word.h"
#include "elsie/plugin/inspection.h"

#include "support.h"

using namespace elsie::plugin;
using namespace elsie::plugin::test;
using Catch::Contains;
using Bytes = std::vector<std::byte>;

namespace {

/// Overwrites a field of the file.
template <class Value>
void put(Bytes& bytes, std::size_t offset, Value value) {
  std::memcpy(bytes.data() + offset, &value, sizeof value);
}

Elf64_Ehdr header_of(const Bytes& bytes) {
  Elf64_Ehdr header;
  std::memcpy(&header, bytes.data(), sizeof header);
  return header;
}

std::size_t offset_of_text(const Bytes& bytes, std::string_view text) {
  const auto wanted = std::as_bytes(std::span(text));
  return static_cast<std::size_t>(
      std::search(bytes.begin(), bytes.end(), wanted.begin(), wanted.end()) - bytes.begin());
}

/// Inspects a file in memory that has these bytes.
Inspection inspect_bytes(std::span<const std::byte> bytes) {
  static const int file = memfd_create("library", 0);
  const bool written = ftruncate(file, 0) == 0 && pwrite(file, bytes.data(), bytes.size(), 0) ==
                                                      static_cast<ssize_t>(bytes.size());
  REQUIRE(written);
  return inspect_file("/proc/self/fd/" + std::to_string(file));
}

}  // namespace

TEST_CASE("A plugin library tells its ABI word without being loaded") {
  const Inspection inspection = inspect_file(fixture("good"));
  CHECK(inspection.kind == FileKind::plugin_library);
  CHECK(inspection.abi_word == host_abi_word());
  CHECK(inspection.sentence.empty());
  CHECK_FALSE(is_loaded(fixture("good")));
}

TEST_CASE("What does not claim to be a plugin library is of no interest") {
  CHECK(inspect_file(fixture("stranger")).kind == FileKind::other);
  CHECK_THAT(inspect_file(fixture("stranger")).sentence, Contains("without a plugin of Elsie"));
  CHECK(inspect_file("/").kind == FileKind::other);
  CHECK(inspect_file("/").sentence == "is a directory");
  const std::string text = "a shopping list";
  CHECK(inspect_bytes(std::as_bytes(std::span(text))).kind == FileKind::other);
}

TEST_CASE("A file that cannot be opened is reported with the system's reason") {
  const Inspection inspection = inspect_file("/nowhere/at/all.so");
  CHECK(inspection.kind == FileKind::damaged);
  CHECK_THAT(inspection.sentence, Contains("No such file"));
}

TEST_CASE("A library cut short at any byte is found out") {
  const Bytes bytes = bytes_of(fixture("good"));
  const std::span<const std::byte> all(bytes);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const FileKind kind = inspect_bytes(all.first(size)).kind;
    if (kind != FileKind::damaged) {
      INFO("cut after " << size << " of " << bytes.size() << " bytes");
      REQUIRE(kind == FileKind::damaged);
    }
  }
  CHECK_THAT(inspect_bytes(all.first(bytes.size() / 2)).sentence, Contains("cut short"));
  CHECK(inspect_bytes(all).kind == FileKind::plugin_library);
}

TEST_CASE("A library whose end is zeros, as after a power cut, is found out") {
  Bytes bytes = bytes_of(fixture("good"));
  std::fill(bytes.end() - 4096, bytes.end(), std::byte{0});
  CHECK(inspect_bytes(bytes).kind == FileKind::damaged);
  CHECK_THAT(inspect_bytes(bytes).sentence, Contains("end was never written"));
}

TEST_CASE("Libraries for other kinds of processor are recognised") {
  const Bytes good = bytes_of(fixture("good"));
  Bytes foreign = good;
  const bool is_x86 = header_of(good).e_machine == EM_X86_64;
  put(foreign, offsetof(Elf64_Ehdr, e_machine),
      is_x86 ? Elf64_Half{EM_AARCH64} : Elf64_Half{EM_X86_64});
  CHECK(inspect_bytes(foreign).kind == FileKind::foreign);
  CHECK_THAT(inspect_bytes(foreign).sentence, Contains("another processor"));
  Bytes small = good;
  small[EI_CLASS] = std::byte{ELFCLASS32};
  CHECK(inspect_bytes(small).kind == FileKind::other);
  Bytes big_endian = good;
  big_endian[EI_DATA] = std::byte{ELFDATA2MSB};
  CHECK(inspect_bytes(big_endian).kind == FileKind::other);
  Bytes object_file = good;
  put(object_file, offsetof(Elf64_Ehdr, e_type), Elf64_Half{ET_REL});
  CHECK(inspect_bytes(object_file).kind == FileKind::other);
}

TEST_CASE("Tables and sizes that make no sense are found out") {
  const Bytes good = bytes_of(fixture("good"));
  const auto spoiled = [&good](std::size_t offset, auto value) {
    Bytes bytes = good;
    put(bytes, offset, value);
    return inspect_bytes(bytes).kind;
  };
  constexpr Elf64_Off kFar = ~Elf64_Off{0} - 8;
  CHECK(spoiled(offsetof(Elf64_Ehdr, e_phoff), kFar) == FileKind::damaged);
  CHECK(spoiled(offsetof(Elf64_Ehdr, e_shoff), kFar) == FileKind::damaged);
  CHECK(spoiled(offsetof(Elf64_Ehdr, e_phnum), Elf64_Half{0}) == FileKind::damaged);
  CHECK(spoiled(offsetof(Elf64_Ehdr, e_phnum), Elf64_Half{0xffff}) == FileKind::damaged);
  CHECK(spoiled(offsetof(Elf64_Ehdr, e_phentsize), Elf64_Half{1}) == FileKind::damaged);
  CHECK(spoiled(offsetof(Elf64_Ehdr, e_shentsize), Elf64_Half{1}) == FileKind::damaged);
  const std::size_t first_segment = header_of(good).e_phoff;
  CHECK(spoiled(first_segment + offsetof(Elf64_Phdr, p_offset), kFar) == FileKind::damaged);
  CHECK(spoiled(first_segment + offsetof(Elf64_Phdr, p_filesz), kFar) == FileKind::damaged);
}

TEST_CASE("An ABI word that is no readable text is found out") {
  Bytes bytes = bytes_of(fixture("good"));
  bytes[offset_of_text(bytes, host_abi_word())] = std::byte{0x1b};
  CHECK(inspect_bytes(bytes).kind == FileKind::damaged);
  CHECK_THAT(inspect_bytes(bytes).sentence, Contains("ABI word cannot be read"));
}

TEST_CASE("A note of another owner is not taken for the ABI word") {
  Bytes bytes = bytes_of(fixture("good"));
  // The owner stands right before the word, padded to eight bytes.
  put(bytes, offset_of_text(bytes, host_abi_word()) - 8, 'x');
  CHECK(inspect_bytes(bytes).kind == FileKind::other);
}

TEST_CASE("No mutilated library harms the reader") {
  const Bytes good = bytes_of(fixture("good"));
  const Elf64_Ehdr header = header_of(good);
  const std::size_t word = offset_of_text(good, host_abi_word());
  // Where the reader looks: the file's header and segments, the notes, the sections.
  const std::pair<std::size_t, std::size_t> regions[] = {
      {0, 1024},
      {word - 64, 256},
      {header.e_shoff, good.size() - header.e_shoff},
      {0, good.size()}};
  elsie::Random random(7);
  const auto below = [&random](std::size_t limit) { return random.bits() % limit; };
  Bytes bytes = good;
  std::vector<std::size_t> changed;
  int refused = 0;
  for (int round = 0; round < 20'000; ++round) {
    for (std::size_t count = 1 + below(6); count > 0; --count) {
      const auto& [begin, size] = regions[below(4)];
      const std::size_t at = begin + below(size);
      constexpr unsigned char kEdges[] = {0x00, 0x01, 0x04, 0x7f, 0x80, 0xff};
      bytes[at] = below(2) == 0 ? std::byte{kEdges[below(6)]}
                                : static_cast<std::byte>(random.bits() & 0xff);
      changed.push_back(at);
    }
    // Memory of the file's exact size, so that a sanitizer sees every step beyond it.
    const bool is_cut = below(8) == 0;
    const auto cut = static_cast<std::ptrdiff_t>(is_cut ? below(bytes.size()) : 0);
    const Inspection inspection =
        is_cut ? inspect_bytes(Bytes(bytes.begin(), bytes.begin() + cut)) : inspect_bytes(bytes);
    if ((inspection.kind == FileKind::plugin_library) != inspection.sentence.empty()) {
      FAIL("a verdict without a sentence in round " << round);
    }
    refused += inspection.kind == FileKind::plugin_library ? 0 : 1;
    for (const std::size_t at : changed) {
      bytes[at] = good[at];
    }
    changed.clear();
  }
  CHECK(refused > 5'000);
}
