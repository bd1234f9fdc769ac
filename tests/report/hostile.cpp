#include "hostile.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace elsie::test {

std::string xmllint(const std::string& text, const std::string& options) {
  const std::string file = build_path("tests/report/checked");
  const std::string log = file + ".log";
  std::ofstream(file, std::ios::binary) << text;
  const int code =
      std::system(("xmllint --noout " + options + " '" + file + "' 2> '" + log + "'").c_str());
  std::ostringstream told;
  told << std::ifstream(log).rdbuf();
  return code == 0 ? "" : "failed: " + told.str();
}

}  // namespace elsie::test
