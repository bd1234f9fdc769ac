#include "hostile.h"

#include <cstdlib>

namespace elsie::test {

std::string xmllint(const std::string& text, const std::string& options) {
  const Folder folder;
  const std::string file = folder.write("checked", text), log = folder.file("log");
  const int code =
      std::system(("xmllint --noout " + options + " '" + file + "' 2> '" + log + "'").c_str());
  return code == 0 ? "" : "failed: " + folder.read("log");
}

}  // namespace elsie::test
