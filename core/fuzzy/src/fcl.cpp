#include "elsie/fuzzy/fcl.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "builder.h"
#include "parser.h"
#include "problems.h"

namespace elsie::fuzzy {

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
  return parse_fcl(text, path);
}

}  // namespace elsie::fuzzy
