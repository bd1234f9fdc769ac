#include "streams.h"

#include <filesystem>
#include <iostream>
#include <locale>
#include <memory>
#include <streambuf>
#include <string_view>
#include <utility>
#include <vector>

#include <ext/stdio_filebuf.h>
#include <fcntl.h>
#include <unistd.h>

#include "elsie/files/clean_text.h"

namespace elsie::program {

namespace {

int kept_output = STDOUT_FILENO;

std::ostream* made_stream(std::streambuf* buffer) {
  auto* const made = new std::ostream(buffer);
  made->imbue(std::locale::classic());  // whatever a plugin has set for new streams
  return made;
}

/// Standard output. Never destroyed: it is used until the process ends, and flushed before.
std::ostream& as_it_is() {
  static auto* const buffer =
      new __gnu_cxx::stdio_filebuf<char>(kept_output, std::ios::out | std::ios::binary);
  static auto* const stream = made_stream(buffer);
  return *stream;
}

/// Passes on cleaned text, whole lines at a time, so that no character is cut.
class CleanBuffer final : public std::streambuf {
 public:
  explicit CleanBuffer(std::ostream& to) : to_(to) {}

 protected:
  int_type overflow(int_type character) override {
    if (traits_type::eq_int_type(character, traits_type::eof())) {
      return traits_type::not_eof(character);
    }
    const char byte = traits_type::to_char_type(character);
    return xsputn(&byte, 1) == 1 ? character : traits_type::eof();
  }
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    text_.append(bytes, static_cast<std::size_t>(count));
    if (text_.size() > kFull) {
      if (const std::size_t end = text_.rfind('\n'); end != std::string::npos) {
        to_ << files::clean(std::string_view(text_).substr(0, end + 1));
        text_.erase(0, end + 1);
      }
    }
    return to_ ? count : 0;
  }
  int sync() override {
    to_ << files::clean(std::exchange(text_, {})) << std::flush;
    return to_ ? 0 : -1;
  }

 private:
  static constexpr std::size_t kFull = 65'536;

  std::ostream& to_;
  std::string text_;
};

}  // namespace

std::ostream& out() {
  // Never destroyed: it is used until the process ends, and flushed before.
  static auto* const stream = made_stream(new CleanBuffer(as_it_is()));
  return *stream;
}

std::ostream& err() {
  static auto* const stream = [] {
    auto* const made = made_stream(new CleanBuffer(std::cerr));
    made->setf(std::ios::unitbuf);
    return made;
  }();
  return *stream;
}

std::ostream& data_out() {
  out().flush();
  return as_it_is();
}

int out_descriptor() { return kept_output; }

void keep_output(int count, char** arguments) {
  const int kept = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  if (kept < 0) {
    return;  // closed: writing will fail and report it
  }
  kept_output = kept;
  dup2(STDERR_FILENO, STDOUT_FILENO);
  // Kept until the program ends, like arguments.
  static std::vector<std::string> changed;
  changed.reserve(static_cast<std::size_t>(count));
  for (int i = 1; i < count; ++i) {
    const std::string_view argument = arguments[i];
    for (const std::string_view name : {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
      const bool is_value = argument.size() > name.size() && argument.ends_with(name) &&
                            argument[argument.size() - name.size() - 1] == '=';
      if (argument == name || is_value) {
        changed.push_back(std::string(argument.substr(0, argument.size() - name.size())) +
                          "/dev/fd/" + std::to_string(kept));
        arguments[i] = changed.back().data();
        break;
      }
    }
  }
}

void give_output_back() {
  if (kept_output >= 0) dup2(kept_output, STDOUT_FILENO);
}

std::string program_path() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

}  // namespace elsie::program
