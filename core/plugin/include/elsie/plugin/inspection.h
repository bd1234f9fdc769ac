// Inspects a file without loading it: whether it is a plugin library, and its ABI word.
//
// Every offset in the file is checked against its size, so that a broken file does no harm, and a
// library that was cut short is found before the loader maps memory that does not exist.
#pragma once

#include <filesystem>
#include <string>

namespace elsie::plugin {

enum class FileKind {
  plugin_library,  // an ELF shared library for this processor with an ABI word
  other,           // does not claim to be a plugin library
  damaged,         // an ELF file cut short or inconsistent
  foreign          // a plugin library for another processor
};

struct Inspection {
  FileKind kind = FileKind::other;
  std::string abi_word;  // of a plugin library
  std::string sentence;  // what was found, without the file's name; "" for a plugin library
};

/// Never throws because of the file. A file that cannot be opened is `damaged`, with the system's
/// reason.
Inspection inspect_file(const std::filesystem::path& file);

}  // namespace elsie::plugin
