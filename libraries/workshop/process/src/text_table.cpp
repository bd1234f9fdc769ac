#include "elsie/process/text_table.h"

#include <algorithm>

#include "elsie/base/utf8.h"
#include "elsie/files/clean_text.h"

namespace elsie::process {

std::string laid_out(std::vector<std::vector<std::string>> rows, std::size_t text_columns,
                     std::size_t gap) {
  for (auto& cells : rows) {
    std::transform(cells.begin(), cells.end(), cells.begin(), files::one_line);
  }
  std::vector<std::size_t> widths;
  for (const auto& cells : rows) {
    widths.resize(std::max(widths.size(), cells.size()), 0);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      widths[i] = std::max(widths[i], base::characters(cells[i]));
    }
  }
  std::string text;
  for (const auto& cells : rows) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string padding(widths[i] - base::characters(cells[i]), ' ');
      line += std::string(i > 0 ? gap : 0, ' ');
      line += i < text_columns ? cells[i] + padding : padding + cells[i];
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

}  // namespace elsie::process
