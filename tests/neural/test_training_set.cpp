#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <catch2/catch.hpp>

#include "elsie/neural/error.h"

#include "support.h"

using namespace elsie::neural;

namespace {

const Columns kColumns{2, 2, "one for each range sensor: left, right",
                       "one for each behaviour: avoid_obstacle, find_resource"};

/// The problems of the text; empty if there are none.
std::vector<Problem> problems(const std::string& text) {
  try {
    parse_training_set(text, kColumns, "set.txt");
    return {};
  } catch (const FileError& error) {
    return {error.problems().begin(), error.problems().end()};
  }
}

}  // namespace

TEST_CASE("A line is a sample: inputs, then outputs, with tabs or spaces between") {
  const TrainingSet set =
      parse_training_set("1\t0.5\t0\t1\n  0.25 -3  1e-1\t 0.75 \r\n\n \n", kColumns);
  REQUIRE(set.size() == 2);
  CHECK(set.inputs(0)[1] == 0.5);
  CHECK(set.targets(0)[1] == 1.0);
  CHECK(set.inputs(1)[0] == 0.25);
  CHECK(set.inputs(1)[1] == -3.0);
  CHECK(set.targets(1)[0] == 0.1);
  CHECK(set.targets(1)[1] == 0.75);
  CHECK(parse_training_set("\xEF\xBB\xBF"
                           "1 1 0 1",
                           kColumns)
            .size() == 1);
}

TEST_CASE("The shipped sets are what they were published as") {
  const TrainingSet two = elsie::test::reference_set();
  CHECK(two.size() == 9);
  CHECK(two.inputs(7)[0] == 0.2);
  CHECK(two.targets(8)[0] == 0.6);
  const TrainingSet three = read_training_set(
      elsie::test::source_path("training_sets/three_sensors_two_behaviors.txt"), {3, 2});
  CHECK(three.size() == 12);
  CHECK(three.targets(1)[1] == 0.8);
}

TEST_CASE("A line with another count of numbers is named, with what the numbers are for") {
  const auto found = problems("1 1 0 1\n1 1 0\n1 1 0 1 1\n\n1 1 1 1\n");
  REQUIRE(found.size() == 3);
  const std::string expected =
      ", expected 4: 2 inputs (one for each range sensor: left, right), then 2 outputs (one for "
      "each behaviour: avoid_obstacle, find_resource)";
  CHECK(found[0].text() == "set.txt:2: 3 numbers" + expected);
  CHECK(found[1].text() == "set.txt:3: 5 numbers" + expected);
  CHECK(found[2].text() == "set.txt:4: an empty line" + expected);
}

TEST_CASE("What is not a finite number is named") {
  for (const auto& [word, complaint] :
       std::vector<std::pair<std::string, std::string>>{{"0,5", "decimal point"},
                                                        {"3abc", "'3abc' is not a number"},
                                                        {"+1", "not a number"},
                                                        {"0x1", "not a number"},
                                                        {"1e", "not a number"},
                                                        {"nan", "not a finite number"},
                                                        {"inf", "not a finite number"},
                                                        {"-infinity", "not a finite number"},
                                                        {"1e999", "beyond what a number can hold"},
                                                        {std::string(1000, '7') + "x", "..."},
                                                        {"\x01", "'?'"}}) {
    const auto found = problems("1 1 0 1\n1 " + word + " 0 1\n");
    CAPTURE(word);
    REQUIRE(found.size() == 1);
    CHECK(found[0].line == 2);
    CHECK_THAT(found[0].message, Catch::Contains(complaint));
  }
}

TEST_CASE("A target that no network can answer is refused") {
  const auto found = problems("1 1 0 1.5\n-7 9 -0.1 1\n");
  REQUIRE(found.size() == 2);
  CHECK(found[0].text() == "set.txt:1: output 2 is 1.5, but a network's answers are in [0, 1]");
  CHECK_THAT(found[1].message, Catch::StartsWith("output 1 is -0.1"));
}

TEST_CASE("A file without samples, or that is no text, is refused") {
  CHECK_THAT(problems("").at(0).message, Catch::StartsWith("there is no sample in it"));
  CHECK_THAT(problems("\n\n  \n").at(0).message, Catch::Contains("2 inputs"));
  const auto binary = problems(std::string("1 1 0 1\n\0\x7f", 10));
  REQUIRE(binary.size() == 1);
  CHECK(binary[0].line == 2);
  CHECK_THAT(binary[0].message, Catch::StartsWith("this is not a text file"));
}

TEST_CASE("A wrong file of a million lines is not answered with a million sentences") {
  std::string text;
  for (int i = 0; i < 5000; ++i) {
    text += "1 2 3\n";
  }
  const auto found = problems(text);
  CHECK(found.size() == 21);
  CHECK_THAT(found.back().text(), Catch::Contains("4980 more"));
}

TEST_CASE("Files that cannot be read are named") {
  const auto complaint = [](const std::string& path) {
    try {
      read_training_set(path, kColumns);
      return std::string();
    } catch (const FileError& error) {
      return std::string(error.what());
    }
  };
  CHECK_THAT(complaint("/nowhere/at/all.txt"),
             Catch::StartsWith("/nowhere/at/all.txt: there is no such file"));
  CHECK_THAT(complaint("/"), Catch::Contains("this is a directory"));
}

TEST_CASE("A sample that does not belong is not added to a set") {
  TrainingSet set(2, 1);
  const double two[] = {1, 2}, one[] = {0.5}, beyond[] = {2.0};
  set.add(two, one);
  CHECK_THROWS_AS(set.add(one, one), std::invalid_argument);
  CHECK_THROWS_AS(set.add(two, two), std::invalid_argument);
  CHECK_THROWS_AS(set.add(two, beyond), std::invalid_argument);
  CHECK(set.size() == 1);
}
