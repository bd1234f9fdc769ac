#include "elsie/plugin/inspection.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <elf.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "elsie/api/abi.h"

namespace elsie::plugin {
namespace {

#if defined(__x86_64__)
constexpr unsigned kMachine = EM_X86_64;
#elif defined(__aarch64__)
constexpr unsigned kMachine = EM_AARCH64;
#else
#error "plugin libraries are known for x86-64 and 64-bit ARM only"
#endif

constexpr std::string_view kOwner{ELSIE_ABI_NOTE_OWNER, sizeof(ELSIE_ABI_NOTE_OWNER)};  // with NUL
constexpr std::size_t kLongestWord = 4096;
constexpr std::size_t kMostSegments = 1024;
constexpr std::size_t kMostNoteBytes = 65'536;

/// Ends the inspection: thrown by the steps below, caught by inspect_file().
struct Refusal {
  FileKind kind;
  std::string sentence;
};

[[noreturn]] void other(const char* sentence) { throw Refusal{FileKind::other, sentence}; }
[[noreturn]] void damaged(const std::string& sentence) {
  throw Refusal{FileKind::damaged, sentence};
}

/// Random access to the bytes of a file. It does not map the file: if a mapped file shrinks, the
/// program crashes.
class Source {
 public:
  explicit Source(const std::filesystem::path& file)
      // Without O_NONBLOCK, opening a named pipe waits for a writer.
      : descriptor_(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  ~Source() { close(descriptor_); }

  void require_file() {
    if (descriptor_ < 0 || fstat(descriptor_, &status_) != 0) {
      damaged(std::string("cannot be read: ") + strerror(errno));
    }
    if (!S_ISREG(status_.st_mode)) {
      other(S_ISDIR(status_.st_mode) ? "is a directory" : "is not a file");
    }
  }
  std::uint64_t size() const { return static_cast<std::uint64_t>(status_.st_size); }
  /// Returns whether the file has these bytes.
  bool contains(std::uint64_t offset, std::uint64_t count) const {
    return offset <= size() && count <= size() - offset;
  }
  /// Returns false when the file has fewer bytes, or when they cannot be read.
  bool read(std::uint64_t offset, void* to, std::size_t count) const {
    return contains(offset, count) &&
           pread(descriptor_, to, count, static_cast<off_t>(offset)) == static_cast<ssize_t>(count);
  }
  template <class Struct>
  std::optional<Struct> get(std::uint64_t offset) const {
    Struct result;
    return read(offset, &result, sizeof result) ? std::optional(result) : std::nullopt;
  }

 private:
  int descriptor_;
  struct stat status_ {};
};

constexpr const char* kCutShort =
    "is a library that was cut short; build or copy it again, and check the free disk space";

/// The file's header, if it is that of a shared library of this word size and byte order.
Elf64_Ehdr read_header(const Source& file) {
  unsigned char identity[EI_NIDENT] = {};
  const std::size_t known = std::min<std::uint64_t>(file.size(), sizeof identity);
  if (known == 0) {
    damaged("is empty");
  }
  if (!file.read(0, identity, known)) {
    damaged("cannot be read");
  }
  if (std::memcmp(identity, ELFMAG, std::min<std::size_t>(known, SELFMAG)) != 0) {
    other("is not a shared library");
  }
  if (known < sizeof identity) {
    damaged(kCutShort);
  }
  if (identity[EI_CLASS] != ELFCLASS64) {
    other("is not a 64-bit library");
  }
  if (identity[EI_DATA] != ELFDATA2LSB) {
    other("is not a library for a little-endian processor");
  }
  const auto header = file.get<Elf64_Ehdr>(0);
  if (!header) {
    damaged(kCutShort);
  }
  if (header->e_type != ET_DYN) {
    other("is an ELF file, but not a shared library");
  }
  return *header;
}

std::vector<Elf64_Phdr> read_segments(const Source& file, const Elf64_Ehdr& header) {
  if (header.e_phentsize != sizeof(Elf64_Phdr) || header.e_phnum == 0 ||
      header.e_phnum > kMostSegments) {
    damaged("is a damaged library: its list of segments makes no sense; build or copy it again");
  }
  std::vector<Elf64_Phdr> segments(header.e_phnum);
  if (!file.read(header.e_phoff, segments.data(), segments.size() * sizeof(Elf64_Phdr))) {
    damaged(kCutShort);
  }
  return segments;
}

/// Checks that the file has everything that the loader will map.
void check_segments(const Source& file, const std::vector<Elf64_Phdr>& segments) {
  bool has_code = false;
  bool has_symbols = false;
  for (const Elf64_Phdr& segment : segments) {
    if (segment.p_type == PT_NULL) continue;
    if (segment.p_filesz > 0 && !file.contains(segment.p_offset, segment.p_filesz)) {
      damaged(kCutShort);
    }
    if (segment.p_type == PT_LOAD && segment.p_filesz > segment.p_memsz) {
      damaged("is a damaged library: a segment is larger in the file than in memory");
    }
    has_code = has_code || segment.p_type == PT_LOAD;
    has_symbols = has_symbols || segment.p_type == PT_DYNAMIC;
  }
  if (!has_code || !has_symbols) {
    damaged("is a damaged library: it has nothing to load; build or copy it again");
  }
}

/// The linker writes the section headers last, so they show whether the file is complete. (A
/// library may have none.)
void check_end(const Source& file, const Elf64_Ehdr& header) {
  if (header.e_shoff == 0 || header.e_shnum == 0) return;
  const std::uint64_t bytes = std::uint64_t{header.e_shnum} * sizeof(Elf64_Shdr);
  if (header.e_shentsize != sizeof(Elf64_Shdr)) {
    damaged("is a damaged library: its list of sections makes no sense; build or copy it again");
  }
  if (!file.contains(header.e_shoff, bytes)) {
    damaged(kCutShort);
  }
  if (header.e_shstrndx != SHN_UNDEF && header.e_shstrndx < header.e_shnum) {
    const auto names = file.get<Elf64_Shdr>(header.e_shoff +
                                            std::uint64_t{header.e_shstrndx} * sizeof(Elf64_Shdr));
    if (!names || names->sh_type != SHT_STRTAB ||
        !file.contains(names->sh_offset, names->sh_size)) {
      damaged("is a library whose end was never written; build or copy it again");
    }
  }
}

std::uint64_t padded(std::uint64_t size, std::uint64_t alignment) {
  return (size + alignment - 1) / alignment * alignment;
}

/// The text of a note that carries an ABI word.
std::string word_of(std::string_view text) {
  text = text.substr(0, text.find('\0'));
  const bool is_printable =
      std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
  if (text.empty() || text.size() > kLongestWord || !is_printable) {
    damaged("is a damaged plugin library: its ABI word cannot be read; build it again");
  }
  return std::string(text);
}

/// Adds the ABI words in a segment of notes. Stops at data that is not a valid note: notes of other
/// tools are not checked.
void find_words(std::string_view notes, std::uint64_t alignment, std::vector<std::string>& words) {
  std::uint64_t at = 0;
  Elf64_Nhdr note;
  while (at <= notes.size() && notes.size() - at >= sizeof note) {
    std::memcpy(&note, notes.data() + at, sizeof note);
    // Sizes are 32 bits wide: the sums cannot overflow.
    const std::uint64_t owner = at + sizeof note;
    const std::uint64_t text = at + padded(sizeof note + std::uint64_t{note.n_namesz}, alignment);
    const std::uint64_t end = text + note.n_descsz;
    if (owner + note.n_namesz > notes.size() || end > notes.size()) return;
    if (note.n_type == ELSIE_ABI_NOTE_TYPE && notes.substr(owner, note.n_namesz) == kOwner) {
      words.push_back(word_of(notes.substr(text, note.n_descsz)));
    }
    at = at + padded(end - at, alignment);
  }
}

/// The ABI word, or none.
std::optional<std::string> read_word(const Source& file, const std::vector<Elf64_Phdr>& segments) {
  std::vector<std::string> words;
  for (const Elf64_Phdr& segment : segments) {
    if (segment.p_type != PT_NOTE || segment.p_filesz > kMostNoteBytes) continue;
    std::string notes(segment.p_filesz, '\0');
    if (!file.read(segment.p_offset, notes.data(), notes.size())) {
      damaged(kCutShort);
    }
    find_words(notes, segment.p_align == 8 ? 8 : 4, words);
  }
  if (words.empty()) return std::nullopt;
  if (std::adjacent_find(words.begin(), words.end(), std::not_equal_to<>()) != words.end()) {
    damaged("consists of parts with different ABI words; rebuild it from scratch");
  }
  return std::move(words.front());
}

}  // namespace

Inspection inspect_file(const std::filesystem::path& path) {
  Inspection result;
  try {
    Source file(path);
    file.require_file();
    const Elf64_Ehdr header = read_header(file);
    const std::vector<Elf64_Phdr> segments = read_segments(file, header);
    check_segments(file, segments);
    check_end(file, header);
    const auto word = read_word(file, segments);
    if (!word) {
      other("is a shared library without a plugin of Elsie");
    }
    result.abi_word = *word;
    if (header.e_machine != kMachine) {
      throw Refusal{FileKind::foreign, "is a plugin library for another processor; rebuild it"};
    }
    result.kind = FileKind::plugin_library;
  } catch (const Refusal& refusal) {
    result.kind = refusal.kind;
    result.sentence = refusal.sentence;
  }
  return result;
}

}  // namespace elsie::plugin
