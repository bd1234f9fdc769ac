#include <cstdio>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/process/shell_word.h"

using namespace elsie;

namespace {

// What the system's shell hands to a program as its arguments, each between brackets.
std::string arguments(const std::string& words) {
  std::FILE* shell = popen(("printf '[%s]' " + words).c_str(), "r");
  REQUIRE(shell);
  std::string text;
  for (int c; (c = std::fgetc(shell)) != EOF;) {
    text += static_cast<char>(c);
  }
  REQUIRE(pclose(shell) == 0);
  return text;
}

}  // namespace

TEST_CASE("Words are quoted where a shell would take them apart") {
  CHECK(process::shell_word("worlds/a-b_c.xml") == "worlds/a-b_c.xml");
  CHECK(process::shell_word("") == "''");
  CHECK(process::shell_word("a b") == "'a b'");
  CHECK(process::shell_word("it's") == "'it'\\''s'");
  CHECK(process::shell_line({"elsie", "batch", "a b", "$x"}) == "elsie batch 'a b' '$x'");
}

TEST_CASE("A shell gives each word back as it was") {
  const std::string word =
      GENERATE("plain", "", " ", "it's", "'", "\"", "a\"b c\"", "$HOME", "`ls`", "$(ls)", "~", "a*",
               "!", "#x", "a;b", "a&b", "a|b", "<x>", "(y)", "{1,2}", "back\\slash", "a\nb",
               "\xc3\xa4 \xf0\x9f\x90\xa2", "%s", "a=b", "[ab]", "?");
  CHECK(arguments(process::shell_line({word, "next"})) == "[" + word + "][next]");
}
