// Checks of the files that will be written, before any work is done.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace elsie::files {

/// A file that is going to be written, and what names it: "--picture", "OUT".
struct Output {
  std::string named_by;
  std::filesystem::path file;
};

/// Throws base::BadInput, which begins with `named_by`, when no file can be written there.
void require_writable(const std::filesystem::path& file, const std::string& named_by);

/// The same. A file that exists must also begin as `is_kind` expects, so that another one is not
/// overwritten by mistake. `kind`: for messages, such as "picture". `is_kind` gets at most the
/// first kilobyte, never an empty text.
void require_replaceable(const std::filesystem::path& file, const std::string& named_by,
                         const std::string& kind,
                         const std::function<bool(std::string_view start)>& is_kind);

/// Throws base::BadInput for a name like ".csv", which is that of a hidden file without a suffix.
void require_stem(const std::filesystem::path& file, const std::string& named_by,
                  std::string_view suffix);

/// Devices such as /dev/stdout, and pipes: they have no suffix, and no content to lose.
bool is_device(const std::filesystem::path& file);

/// Whether both names lead to one file, perhaps over links, and whether it exists or not.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Called before anything is written. Throws base::BadInput when an output is one of the inputs,
/// whose content would be lost, or two outputs are one file. Devices and pipes have no content to
/// lose.
void require_apart(const std::vector<Output>& outputs,
                   const std::vector<std::filesystem::path>& inputs);

}  // namespace elsie::files
