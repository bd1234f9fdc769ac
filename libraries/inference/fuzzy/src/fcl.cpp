#include "elsie/fuzzy/fcl.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "elsie/base/read_whole.h"
#include "elsie/base/words.h"
#include "elsie/fuzzy/error.h"

#include "builder.h"
#include "parser.h"
#include "text.h"

namespace elsie::fuzzy {
namespace {

constexpr std::size_t kMostProblems = 200;  // more would help nobody

/// The models that this thread read last. The robots of a world and the cells of an experiment
/// share models; a model depends on its text only and never changes.
class Recent {
 public:
  Model model(const std::string& text, const std::string& path, const std::string& block,
              Gaps gaps) {
    for (const Entry& entry : entries_) {
      if (entry.text == text && entry.path == path && entry.block == block && entry.gaps == gaps) {
        return entry.model;
      }
    }
    Model model = parse_fcl(text, path, block, gaps);
    if (entries_.size() < kMost) {
      entries_.push_back({text, path, block, gaps, model});
    } else {
      entries_[next_] = {text, path, block, gaps, model};
      next_ = (next_ + 1) % kMost;
    }
    return model;
  }

 private:
  static constexpr std::size_t kMost = 8;

  struct Entry {
    std::string text;
    std::string path;  // notes name it
    std::string block;
    Gaps gaps;
    Model model;
  };
  std::vector<Entry> entries_;
  std::size_t next_ = 0;  // index of the next to be replaced
};

Recent& recent() {
  thread_local Recent recent;
  return recent;
}

/// The block of this name; "": the only one. Throws FclError unless that is exactly one block.
/// Errors in other blocks are ignored.
const ast::FunctionBlock& choose(const std::vector<ast::FunctionBlock>& blocks,
                                 const std::string& name, Problems& problems) {
  if (blocks.empty()) {
    problems.raise<FclError>();
  }
  if (name.empty() && blocks.size() == 1) {
    return blocks.front();
  }
  std::vector<std::string> names;
  const ast::FunctionBlock* chosen = nullptr;
  const ast::FunctionBlock* second = nullptr;  // of the same name
  for (const ast::FunctionBlock& block : blocks) {
    const bool is_it = !name.empty() && same_name(block.name.text, name);
    second = is_it && chosen && !second ? &block : second;
    chosen = is_it && !chosen ? &block : chosen;
    const std::string shown =
        block.name.text.empty() ? "(without a name)" : "'" + block.name.text + "'";
    if (std::none_of(names.begin(), names.end(),
                     [&](const std::string& other) { return same_name(other, shown); })) {
      names.push_back(shown);
    }
  }
  if (chosen) {
    problems.forget(0, chosen->first_line - 1);
    if (chosen->last_line > 0) {  // else reading ended in it
      problems.forget(chosen->last_line + 1, std::numeric_limits<int>::max());
    }
    if (second) {
      problems.add(second->first_line,
                   "A second function block '" + name + "'; the first is in line " +
                       std::to_string(chosen->first_line) + ". Give one of them another name.");
    }
    return *chosen;
  }
  if (!name.empty() && blocks.back().last_line == 0) {  // it may be in the part that was not read
    problems.raise<FclError>();
  }
  problems.forget(0, std::numeric_limits<int>::max());
  if (name.empty() && names.size() == 1) {
    problems.add(blocks[1].first_line,
                 "A second function block " + names[0] + "; the first is in line " +
                     std::to_string(blocks[0].first_line) +
                     ". Give each a name of its own, by which it can be chosen.");
  } else if (name.empty()) {
    problems.add(blocks[1].first_line,
                 "A second FUNCTION_BLOCK begins here, and a model is one of them. Name it: " +
                     base::enumerated(names, "or") +
                     " (elsie fuzzy: --block NAME; in a world: the attribute block, left_block or "
                     "right_block).");
  } else {
    problems.add(0, "There is no function block '" + name + "'. The file has " +
                        base::enumerated(names, "or") + ".");
  }
  problems.raise<FclError>();
  return blocks.front();  // not reached
}

}  // namespace

Model parse_fcl(std::string_view text, const std::string& name, const std::string& block,
                Gaps gaps) {
  Problems problems(name, kMostProblems);
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    const auto line = 1 + std::count(text.begin(), text.begin() + zero, '\n');
    problems.add(static_cast<int>(line),
                 "This is not a text file, expected one in Fuzzy Control Language.");
    problems.raise<FclError>();
  }
  const std::vector<ast::FunctionBlock> blocks = parse(text, problems);
  const ast::FunctionBlock& chosen = choose(blocks, block, problems);
  // Statements with errors are missing in the block, so that checking it would report false errors.
  problems.raise<FclError>();
  std::shared_ptr<const ModelData> data = build(chosen, problems, gaps);
  problems.raise<FclError>();
  return Model(std::move(data));
}

Model read_fcl(const std::string& path, const std::string& block, Gaps gaps) {
  Problems problems(path, kMostProblems);
  constexpr std::uintmax_t kMostBytes = 16'000'000;
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    problems.add(0, "There is no such file. Check the path.");
    problems.raise<FclError>();
  }
  std::string text;
  try {
    text = base::read_whole(path, kMostBytes);
  } catch (const std::runtime_error& why) {
    const std::string reason = why.what();
    const bool by_the_system = reason.starts_with("cannot be read");
    problems.add(0, "This " + reason +
                        (by_the_system ? "." : ". Expected a file in Fuzzy Control Language."));
  }
  problems.raise<FclError>();
  return recent().model(text, path, block, gaps);
}

}  // namespace elsie::fuzzy
