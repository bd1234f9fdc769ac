#include "elsie/neural/weights.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "elsie/files/write_whole.h"

#include "text.h"

namespace elsie::neural {
namespace {

constexpr const char* kExpectedFile = "a weight file, as elsie train writes it";
constexpr std::string_view kFirstWords = "elsie network";

std::string trimmed_after(std::string_view line, std::string_view word) {
  const auto begin = static_cast<std::size_t>(word.data() - line.data()) + word.size();
  const std::size_t first = line.find_first_not_of(" \t", begin);
  if (first == std::string_view::npos) {
    return "";
  }
  return std::string(line.substr(first, line.find_last_not_of(" \t") + 1 - first));
}

/// Reads the lines of a file in order; stops at the first mistake, because the lines after it
/// depend on it.
class Reader {
 public:
  Reader(std::string_view text, const std::string& name) : name_(name), lines_(lines_of(text)) {}

  Weights read() {
    read_version();
    std::vector<Remark> about;
    Network network(read_sizes());
    while (words_[0] == "about") {
      read_remark(about);
      next("a line that begins with 'about' or 'neuron'");
    }
    for (std::size_t l = 0; l < network.layers(); ++l) {
      for (std::size_t n = 0; n < network.neurons(l); ++n) {
        read_neuron(network, l, n);
        next("the next neuron, or 'end' after the last one");
      }
    }
    if (words_.size() != 1 || words_[0] != "end") {
      refuse("expected 'end': the network has no further neuron");
    }
    if (advance()) {
      refuse("expected nothing after 'end'");
    }
    return {std::move(network), std::move(about)};
  }

 private:
  [[noreturn]] void refuse(const std::string& message, bool at_line = true) {
    throw FileError({{name_, at_line ? static_cast<int>(line_) : 0, message}});
  }

  /// Moves to the next line with content.
  bool advance() {
    while (line_ < lines_.size()) {
      words_ = words_of(lines_[line_++]);
      if (!words_.empty() && !words_[0].starts_with('#')) {
        return true;
      }
    }
    return false;
  }
  void next(const char* expected) {
    if (!advance()) {
      refuse(std::string("the file ends here, expected ") + expected +
             "; was it cut off? Write it again with elsie train");
    }
  }

  void read_version() {
    if (!advance() || words_.size() != 3 || words_[0] != "elsie" || words_[1] != "network") {
      line_ = std::max<std::size_t>(line_, 1);
      refuse(std::string("this is no weight file: expected 'elsie network ") +
             std::to_string(kWeightsVersion) + "' as its first line");
    }
    if (words_[2] != std::to_string(kWeightsVersion)) {
      refuse("the file has version " + neural::in_quotes(words_[2]) +
             ", but this program reads version " + std::to_string(kWeightsVersion) +
             "; write it again with this version's elsie train");
    }
  }

  std::vector<int> read_sizes() {
    next("'sizes' and the size of each layer");
    if (words_[0] != "sizes" || words_.size() < 3) {
      refuse("expected 'sizes', then how many inputs, neurons in each hidden layer, and outputs");
    }
    std::vector<int> sizes;
    for (std::size_t i = 1; i < words_.size(); ++i) {
      long long size = 0;
      if (!read_count(words_[i], 1, size) || size > static_cast<long long>(kMostWeights)) {
        refuse("the size " + neural::in_quotes(words_[i]) + " is not a whole number from 1 to " +
               std::to_string(kMostWeights));
      }
      sizes.push_back(static_cast<int>(size));
    }
    try {
      const Network network(sizes);
    } catch (const std::invalid_argument& problem) {
      refuse(problem.what());
    }
    next("a line that begins with 'about' or 'neuron'");
    return sizes;
  }

  void read_remark(std::vector<Remark>& about) {
    if (words_.size() < 2) {
      refuse("expected a word and a text after 'about'");
    }
    const std::string key(words_[1]);
    if (std::any_of(about.begin(), about.end(), [&](const Remark& r) { return r.key == key; })) {
      refuse("a second line about " + neural::in_quotes(key));
    }
    about.push_back({key, trimmed_after(lines_[line_ - 1], words_[1])});
    if ((about.back().key + about.back().text).find('\r') != std::string::npos) {
      refuse("the remark about " + neural::in_quotes(key) +
             " contains a carriage return; remove it");
    }
  }

  void read_neuron(Network& network, std::size_t layer, std::size_t neuron) {
    const std::string which =
        "neuron " + std::to_string(layer + 1) + ' ' + std::to_string(neuron + 1);
    if (words_.size() < 3 || words_[0] != "neuron" || words_[1] != std::to_string(layer + 1) ||
        words_[2] != std::to_string(neuron + 1)) {
      refuse("expected '" + which + "', its bias and its weights");
    }
    const std::size_t inputs = network.inputs(layer);
    if (words_.size() != inputs + 4) {
      refuse(which + " has " + counted(words_.size() - 3, "number") + ", expected " +
             std::to_string(inputs + 1) + ": its bias, then a weight for each of its " +
             counted(inputs, "input"));
    }
    network.set_bias(layer, neuron, number(words_[3]));
    for (std::size_t i = 0; i < inputs; ++i) {
      network.set_weight(layer, neuron, i, number(words_[4 + i]));
    }
  }

  double number(std::string_view word) {
    double value = 0.0;
    if (const std::string wrong = read_number(word, value); !wrong.empty()) {
      refuse(wrong);
    }
    return value;
  }

  std::string name_;
  std::vector<std::string_view> lines_;
  std::size_t line_ = 0;  // number of lines read
  std::vector<std::string_view> words_;
};

void check_remarks(const std::vector<Remark>& about) {
  for (auto remark = about.begin(); remark != about.end(); ++remark) {
    const bool is_word =
        words_of(remark->key).size() == 1 && words_of(remark->key)[0] == remark->key;
    const bool known = std::any_of(about.begin(), remark,
                                   [&](const Remark& other) { return other.key == remark->key; });
    if (!is_word || known ||
        (remark->key + remark->text).find_first_of("\r\n") != std::string::npos) {
      throw std::invalid_argument("'" + remark->key +
                                  "' is no remark about a network: it must be one word that occurs "
                                  "once, and its text one line.");
    }
  }
}

[[noreturn]] void refuse_writing(const std::string& path, int error) {
  throw std::runtime_error(
      "Cannot write the weights '" + path + "': " + std::generic_category().message(error) +
      (error == ENOSPC ? ". Make room there, or name a file elsewhere."
                       : ". Name a file in a folder that exists and that you may write "
                         "to."));
}

}  // namespace

std::string_view Weights::remark(std::string_view key) const {
  const auto found =
      std::find_if(about.begin(), about.end(), [&](const Remark& r) { return r.key == key; });
  return found == about.end() ? std::string_view() : std::string_view(found->text);
}

std::string weights_text(const Weights& weights) {
  const Network& network = weights.network;
  if (!network.is_finite()) {
    throw std::invalid_argument("A network whose weights are not all finite cannot be written.");
  }
  check_remarks(weights.about);
  std::string text = std::string(kFirstWords) + ' ' + std::to_string(kWeightsVersion) + "\nsizes";
  for (const int size : network.sizes()) {
    text += ' ' + std::to_string(size);
  }
  text += '\n';
  for (const Remark& remark : weights.about) {
    text += "about " + remark.key + (remark.text.empty() ? "" : " ") + remark.text + '\n';
  }
  text += "# Of each neuron: layer and place, bias, a weight for each of its inputs.\n";
  for (std::size_t l = 0; l < network.layers(); ++l) {
    for (std::size_t n = 0; n < network.neurons(l); ++n) {
      text += "neuron " + std::to_string(l + 1) + ' ' + std::to_string(n + 1) + ' ' +
              number_text(network.bias(l, n));
      for (std::size_t i = 0; i < network.inputs(l); ++i) {
        text += ' ' + number_text(network.weight(l, n, i));
      }
      text += '\n';
    }
  }
  return text + "end\n";
}

Weights parse_weights(std::string_view text, const std::string& name) {
  require_text(text, name, kExpectedFile);
  return Reader(text, name).read();
}

Weights read_weights(const std::string& path) {
  return parse_weights(read_text_file(path, kExpectedFile), path);
}

bool looks_like_weights(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string beginning(kFirstWords.size(), '\0');
  file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return file && beginning == kFirstWords;
}

void write_weights(const Weights& weights, const std::string& path) {
  // Stored on the disk before it replaces another file.
  if (const int error = files::write_whole(path, weights_text(weights), files::Durable::yes);
      error != 0) {
    refuse_writing(path, error);
  }
}

}  // namespace elsie::neural
