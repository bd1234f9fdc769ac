// A look at a file, without loading it: is it a plugin library, and of which ABI?
//
// Only the bytes of the file are read. Every offset that the file gives is checked against its
// size, so that no file, however broken, does harm here; and a library that was cut short, or whose
// end was never written, is found before the loader maps memory that is not there.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace elsie::plugin {

enum class FileKind {
  plugin_library,  // an ELF shared library for this processor with an ABI word
  other,           // anything that does not claim to be a plugin library: none of our business
  damaged,         // an ELF file cut short or inconsistent
  foreign          // a plugin library for another processor
};

struct Inspection {
  FileKind kind = FileKind::other;
  std::string abi_word;  // of a plugin library
  std::string sentence;  // what was found, unless it is a plugin library; without the file's name
};

/// Looks at a file. Never throws because of what the file is or holds; a file that cannot be opened
/// is `other`, with the system's reason.
Inspection inspect_file(const std::filesystem::path& file);

/// The same for the bytes of a file.
Inspection inspect_bytes(std::span<const std::byte> bytes);

}  // namespace elsie::plugin
