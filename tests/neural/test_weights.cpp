#include <bit>
#include <cstdint>
#include <fstream>
#include <limits>
#include <stdexcept>

#include <catch2/catch.hpp>
#include <sys/stat.h>

#include "elsie/neural/error.h"
#include "elsie/neural/training.h"
#include "elsie/neural/weights.h"

#include "folder.h"
#include "support.h"

using namespace elsie::neural;
using namespace elsie::test;

namespace {

std::vector<std::uint64_t> bits(const Network& network) {
  std::vector<std::uint64_t> all;
  each_weight(network, [&](auto l, auto n, auto i) {
    all.push_back(std::bit_cast<std::uint64_t>(get(network, l, n, i)));
  });
  return all;
}

/// A valid file: 2 inputs, one hidden layer of 1, 2 outputs.
const std::string kGood =
    "elsie network 1\n"
    "sizes 2 1 2\n"
    "about inputs metres\n"
    "# a comment\n"
    "neuron 1 1 0.5 -1 2\n"
    "neuron 2 1 0.25 3\n"
    "\n"
    "neuron 2 2 -1e-3 4\n"
    "end\n";

std::string complaint(const std::string& text) {
  try {
    parse_weights(text, "w");
    return "";
  } catch (const FileError& error) {
    return error.what();
  }
}

/// The valid file with one piece replaced.
std::string with(const std::string& piece, const std::string& other) {
  std::string text = kGood;
  const std::size_t at = text.find(piece);
  REQUIRE(at != std::string::npos);
  return text.replace(at, piece.size(), other);
}

}  // namespace

TEST_CASE("Written and read again, no bit of a network is lost") {
  const Folder folder;
  const TrainingSet samples = elsie::test::reference_set();
  for (const char* hidden : {"2 2", "4 4 4", "0", "7 3"}) {
    Network network = random_network(samples, hidden, 3);
    train(network, samples, {{}, 1e-11, 5000});
    const Weights weights{network, {{"inputs", "metres"}, {"behaviors", "a b"}, {"empty", ""}}};
    write_weights(weights, folder.file("w"));
    const Weights read = read_weights(folder.file("w"));
    CHECK(bits(read.network) == bits(network));
    CHECK(read == weights);
    CHECK(read.remark("behaviors") == "a b");
    CHECK(read.remark("seed").empty());
    CHECK(weights_text(read) == weights_text(weights));
  }
}

TEST_CASE("Weights of any size survive the file") {
  Network network({3, 2});
  const double odd[] = {-0.0,    5e-324, -2.2250738585072014e-308, 1.7976931348623157e308, 0.1,
                        1.0 / 3, 1e22,   -123456789.123456789};
  std::size_t k = 0;
  for (std::size_t n = 0; n < 2; ++n) {
    network.set_bias(0, n, odd[k++]);
    for (std::size_t i = 0; i < 3; ++i) {
      network.set_weight(0, n, i, odd[k++]);
    }
  }
  CHECK(bits(parse_weights(weights_text({network})).network) == bits(network));
}

TEST_CASE("A weight file is read as it stands") {
  const Weights weights = parse_weights(kGood);
  const Network& network = weights.network;
  CHECK(sizes_text(network.sizes()) == "2-1-2");
  CHECK(network.bias(0, 0) == 0.5);
  CHECK(network.weight(0, 0, 0) == -1.0);
  CHECK(network.weight(0, 0, 1) == 2.0);
  CHECK(network.bias(1, 1) == -1e-3);
  CHECK(network.weight(1, 1, 0) == 4.0);
  CHECK(weights.about == std::vector<Remark>{{"inputs", "metres"}});
}

TEST_CASE("Anything else than a weight file is refused, with the line") {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"", "w:1: this is no weight file"},
      {"<world/>\n", "w:1: this is no weight file"},
      {with("elsie network 1", "elsie network 2"),
       "w:1: the file has version '2', but this program reads version 1"},
      {with("elsie network 1", "elsie network 01"), "w:1: the file has version '01'"},
      {with("elsie network 1", "elsie network"), "w:1: this is no weight file"},
      {with("sizes 2 1 2", "size 2 1 2"), "w:2: expected 'sizes'"},
      {with("sizes 2 1 2", "sizes 2"), "w:2: expected 'sizes'"},
      {with("sizes 2 1 2", "sizes 2 0 2"), "w:2: the size '0'"},
      {with("sizes 2 1 2", "sizes 2 1.5 2"), "w:2: the size '1.5'"},
      {with("sizes 2 1 2", "sizes 2 99999999999 2"), "w:2: the size '99999999999'"},
      {with("sizes 2 1 2", "sizes 9000 9000 2"), "w:2: A network of 2 layers"},
      {with("sizes 2 1 2", "sizes 3 1 2"), "w:5: neuron 1 1 has 3 numbers, expected 4"},
      {with("sizes 2 1 2", "sizes 2 2 2"), "w:6: expected 'neuron 1 2'"},
      {with("sizes 2 1 2", "sizes 2 1 1"), "w:8: expected 'end'"},
      {with("about inputs metres", "about"), "w:3: expected a word"},
      {with("# a comment", "about inputs again"), "w:4: a second line about 'inputs'"},
      {with("# a comment", "a comment"), "w:4: expected 'neuron 1 1'"},
      {with("neuron 2 1 0.25 3", "neuron 2 1 0.25"), "w:6: neuron 2 1 has 1 number, expected 2"},
      {with("neuron 2 1 0.25 3", "neuron 2 1 0.25 3 4"), "w:6: neuron 2 1 has 3 numbers"},
      {with("neuron 2 1 0.25 3", "neuron 2 2 0.25 3"), "w:6: expected 'neuron 2 1'"},
      {with("neuron 2 1 0.25 3", "neuron 2 1 nan 3"), "w:6: 'nan' is not a finite number"},
      {with("neuron 2 1 0.25 3", "neuron 2 1 0.25 inf"), "w:6: 'inf' is not a finite number"},
      {with("neuron 2 1 0.25 3", "neuron 2 1 0.25 1e400"), "w:6: '1e400' is beyond"},
      {with("neuron 2 1 0.25 3", "neuron 2 1 0,25 3"), "w:6: '0,25' is not a number"},
      {with("neuron 2 1 0.25 3", "neuron 2 1 0.25 3x"), "w:6: '3x' is not a number"},
      {with("end", "neuron 2 3 1 1"), "w:9: expected 'end'"},
      {with("end", "end of file"), "w:9: expected 'end'"},
      {with("end", "end\nneuron 1 1"), "w:10: expected nothing after 'end'"},
      {with("a comment", std::string("\0", 1)), "w:4: this is not a text file"}};
  for (const auto& [text, message] : wrong) {
    CAPTURE(text);
    CHECK_THAT(complaint(text), Catch::StartsWith(message));
  }
}

TEST_CASE("A file that was cut off anywhere is refused") {
  for (std::size_t length = 0; length + 1 < kGood.size(); ++length) {
    const std::string cut = kGood.substr(0, length);
    if (cut.ends_with("end")) {
      continue;  // only the last line feed is missing
    }
    CAPTURE(cut);
    CHECK_FALSE(complaint(cut).empty());
  }
}

TEST_CASE("What cannot be written is not written, and what was there stays") {
  const Folder folder;
  const std::string file = folder.file("w");
  std::ofstream(file) << "precious";
  Network network({1, 1});
  network.set_bias(0, 0, std::numeric_limits<double>::quiet_NaN());
  CHECK_THROWS_AS(write_weights({network}, file), std::invalid_argument);
  network.set_bias(0, 0, 0.0);
  CHECK_THROWS_AS(write_weights({network, {{"two words", "x"}}}, file), std::invalid_argument);
  CHECK_THROWS_AS(write_weights({network, {{"a", "x"}, {"a", "y"}}}, file), std::invalid_argument);
  CHECK_THROWS_AS(write_weights({network, {{"a", "x\nend"}}}, file), std::invalid_argument);
  CHECK_THROWS_AS(write_weights({network, {{"", "x"}}}, file), std::invalid_argument);
  std::string content;
  std::getline(std::ifstream(file), content);
  CHECK(content == "precious");
  CHECK_THROWS_WITH(write_weights({network}, folder.file("no/such/folder/w")),
                    Catch::StartsWith("Cannot write the weights"));
  CHECK_THROWS_AS(write_weights({network}, folder.file("")), std::runtime_error);
  CHECK(folder.files() == 1);  // no temporary file is left
}

TEST_CASE("A weight file is known by how it begins") {
  const Folder folder;
  write_weights({Network({1, 1})}, folder.file("w"));
  CHECK(looks_like_weights(folder.file("w")));
  std::ofstream(folder.file("x")) << "<world/>";
  CHECK_FALSE(looks_like_weights(folder.file("x")));
  CHECK_FALSE(looks_like_weights(folder.file("nothing")));
}

TEST_CASE("A remark that could not be written again is refused") {
  CHECK_THAT(complaint(with("about inputs metres", "about inp\ruts metres")),
             Catch::Contains("contains a carriage return; remove it"));
  CHECK_THAT(complaint(with("about inputs metres", "about inputs met\rres")),
             Catch::Contains("contains a carriage return; remove it"));
}
