#include "elsie/fuzzy/fcl.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "builder.h"
#include "parser.h"
#include "problems.h"

namespace elsie::fuzzy {
namespace {

/// What this thread has read last. The robots of a world share their models, and the thousands of
/// cells of an experiment do; a model follows from its text alone, and does not change.
class Recent {
 public:
  Model model(const std::string& text, const std::string& path) {
    for (const Entry& entry : entries_) {
      if (entry.text == text) {
        return entry.model;
      }
    }
    Model model = parse_fcl(text, path);
    if (entries_.size() < kMost) {
      entries_.push_back({text, model});
    } else {
      entries_[next_] = {text, model};
      next_ = (next_ + 1) % kMost;
    }
    return model;
  }

 private:
  static constexpr std::size_t kMost = 8;

  struct Entry {
    std::string text;
    Model model;
  };
  std::vector<Entry> entries_;
  std::size_t next_ = 0;  // to be replaced
};

Recent& recent() {
  thread_local Recent recent;
  return recent;
}

}  // namespace

Model parse_fcl(std::string_view text, const std::string& name) {
  Problems problems(name);
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    const auto line = 1 + std::count(text.begin(), text.begin() + zero, '\n');
    problems.add(static_cast<int>(line),
                 "This is not a text file, expected one in Fuzzy Control Language.");
    problems.throw_if_any();
  }
  const ast::FunctionBlock block = parse(text, problems);
  // What was not understood is missing from the block: checking that would find mistakes that are
  // none.
  problems.throw_if_any();
  std::shared_ptr<const ModelData> data = build(block, problems);
  problems.throw_if_any();
  return Model(std::move(data));
}

Model read_fcl(const std::string& path) {
  Problems problems(path);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    problems.add(0, "There is no such file. Check the path.");
  } else if (std::filesystem::is_directory(path, error)) {
    problems.add(0, "This is a directory, expected a file in Fuzzy Control Language.");
  }
  problems.throw_if_any();
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) {
    problems.add(0, "The file cannot be read. Check its permissions.");
  }
  problems.throw_if_any();
  return recent().model(text, path);
}

}  // namespace elsie::fuzzy
