// Any bytes give a model or a list of problems; nothing else happens.
#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/random.h"
#include "elsie/fuzzy/error.h"
#include "elsie/fuzzy/fcl.h"

#include "places.h"

using elsie::Random;
using namespace elsie::fuzzy;

namespace {

std::string file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  REQUIRE(stream);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<std::string> seeds() {
  const std::string folder = elsie::test::source_path("tests/fuzzy/models/");
  return {file(folder + "standard.fcl"), file(folder + "jfuzzylogic.fcl"),
          file(folder + "fuzzylite.fcl")};
}

std::size_t place(Random& random, std::size_t size) {
  return static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(size)));
}

/// True if the text is a model; it is then evaluated, and must answer within the range.
bool survives(const std::string& text, Random& random) {
  try {
    const Model model = parse_fcl(text);
    Workspace workspace;
    std::vector<double> inputs(model.inputs().size());
    std::vector<double> outputs(model.outputs().size());
    for (int i = 0; i < 5; ++i) {
      for (std::size_t k = 0; k < inputs.size(); ++k) {
        const Range range = model.inputs()[k].range;
        inputs[k] = random.uniform(range.low, range.high);
      }
      model.evaluate(inputs, outputs, workspace);
      for (std::size_t k = 0; k < outputs.size(); ++k) {
        CHECK(std::isfinite(outputs[k]));
        (void)model.output_set(k, inputs, workspace);
      }
    }
    return true;
  } catch (const FclError& error) {
    CHECK_FALSE(error.problems().empty());
    CHECK(error.problems().size() <= 200);
    for (const Problem& problem : error.problems()) {
      CHECK(problem.line > 0);
      CHECK(problem.message.size() > 10);
    }
    return false;
  }
}

}  // namespace

TEST_CASE("A file that ends too early is refused, wherever it ends") {
  Random random(1, "truncated");
  for (const std::string& text : seeds()) {
    const std::size_t needed = text.rfind("END_FUNCTION_BLOCK") + 18;
    for (std::size_t length = 0; length < needed; length += 7) {
      INFO(length);
      CHECK_FALSE(survives(text.substr(0, length), random));
    }
    CHECK(survives(text.substr(0, needed), random));
  }
}

TEST_CASE("Random bytes are refused") {
  Random random(2, "bytes");
  for (int i = 0; i < 300; ++i) {
    std::string text(place(random, 400), '\0');
    for (char& c : text) {
      c = static_cast<char>(random.bits() & 0xff);
    }
    CHECK_FALSE(survives(text, random));
    CHECK_FALSE(survives("FUNCTION_BLOCK f " + text, random));
  }
}

TEST_CASE("Models with random damage are refused or still make sense") {
  Random random(3, "damage");
  const std::vector<std::string> originals = seeds();
  const std::string pieces[] = {"(",  ")",    ";",   ":=", "..", "1e308", "-1", "0",          "NOT",
                                "IF", "TERM", "nan", "(*", "*)", "RULE",  ",",  "END_FUZZIFY"};
  for (int i = 0; i < 3000; ++i) {
    std::string text = originals[place(random, originals.size())];
    for (std::size_t n = place(random, 4) + 1; n > 0; --n) {
      const std::size_t at = place(random, text.size());
      const double how = random.uniform();
      if (how < 0.3) {
        text[at] = static_cast<char>(random.bits() & 0x7f);
      } else if (how < 0.6) {
        text.erase(at, place(random, 20));
      } else if (how < 0.8) {
        text.insert(at, text.substr(place(random, text.size()), place(random, 60)));
      } else {
        text.insert(at, pieces[place(random, std::size(pieces))]);
      }
    }
    survives(text, random);
  }
}

TEST_CASE("Tokens of the language in random order are refused, or make sense") {
  Random random(4, "tokens");
  std::istringstream words(
      "FUNCTION_BLOCK VAR_INPUT END_VAR x y : REAL ; FUZZIFY TERM := ( 0 , 1 ) .. RANGE "
      "END_FUZZIFY "
      "DEFUZZIFY METHOD COG RULE IF IS THEN NOT AND OR WITH RULEBLOCK DEFAULT NC - | FUNCTION SIN "
      "* ^ "
      "very");
  std::vector<std::string> tokens{std::istream_iterator<std::string>(words), {}};
  tokens.push_back("\n");
  for (int i = 0; i < 1000; ++i) {
    std::string text = "FUNCTION_BLOCK ";
    for (std::size_t n = place(random, 200); n > 0; --n) {
      text += tokens[place(random, tokens.size())] + " ";
    }
    CHECK_FALSE(survives(text, random));
  }
}

TEST_CASE("Deep nesting is refused, not followed until the stack ends") {
  for (const char* opening : {"(", "NOT ", "NOT ("}) {
    std::string text = "FUNCTION_BLOCK RULEBLOCK RULE 1 : IF ";
    for (int i = 0; i < 100000; ++i) {
      text += opening;
    }
    CHECK_THROWS_AS(parse_fcl(text), FclError);
  }
}

TEST_CASE("Very many comments that open and never close take no time") {
  std::string text;
  for (int i = 0; i < 100000; ++i) {
    text += "(* (* *)";
  }
  CHECK_THROWS_AS(parse_fcl(text), FclError);
}
