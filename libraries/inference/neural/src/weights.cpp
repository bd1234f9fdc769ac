#include "elsie/neural/weights.h"

#include <cstddef>
#include <stdexcept>
#include <utility>

#include "text.h"

namespace elsie::neural {
namespace {

constexpr DataFileKind kWeights{"elsie network", kWeightsVersion, "weight file", "weights"};
constexpr const char* kRemarkOrNeuron = "a line that begins with 'about' or 'neuron'";

class WeightsReader {
 public:
  WeightsReader(std::string_view text, const std::string& name) : lines_(kWeights, text, name) {}

  Weights read() {
    Network network(read_sizes());
    std::vector<Remark> about = lines_.remarks(kRemarkOrNeuron);
    for (std::size_t l = 0; l < network.layers(); ++l) {
      for (std::size_t n = 0; n < network.neurons(l); ++n) {
        read_neuron(network, l, n);
        lines_.next("the next neuron, or 'end' after the last one");
      }
    }
    lines_.end("the network has no further neuron");
    return {std::move(network), std::move(about)};
  }

 private:
  std::vector<int> read_sizes() {
    lines_.next("'sizes' and the size of each layer");
    const auto& words = lines_.words();
    if (words[0] != "sizes" || words.size() < 3) {
      lines_.refuse(
          "expected 'sizes', then how many inputs, neurons in each hidden layer, and outputs");
    }
    std::vector<int> sizes;
    for (std::size_t i = 1; i < words.size(); ++i) {
      long long size = 0;
      if (!read_count(words[i], 1, size) || size > static_cast<long long>(kMostWeights)) {
        lines_.refuse("the size " + neural::in_quotes(words[i]) +
                      " is not a whole number from 1 to " + std::to_string(kMostWeights));
      }
      sizes.push_back(static_cast<int>(size));
    }
    try {
      const Network network(sizes);
    } catch (const std::invalid_argument& problem) {
      lines_.refuse(problem.what());
    }
    lines_.next(kRemarkOrNeuron);
    return sizes;
  }

  void read_neuron(Network& network, std::size_t layer, std::size_t neuron) {
    const auto& words = lines_.words();
    const std::string which =
        "neuron " + std::to_string(layer + 1) + ' ' + std::to_string(neuron + 1);
    if (words.size() < 3 || words[0] != "neuron" || words[1] != std::to_string(layer + 1) ||
        words[2] != std::to_string(neuron + 1)) {
      lines_.refuse("expected '" + which + "', its bias and its weights");
    }
    const std::size_t inputs = network.inputs(layer);
    if (words.size() != inputs + 4) {
      lines_.refuse(which + " has " + counted(words.size() - 3, "number") + ", expected " +
                    std::to_string(inputs + 1) + ": its bias, then a weight for each of its " +
                    counted(inputs, "input"));
    }
    network.set_bias(layer, neuron, lines_.number(words[3]));
    for (std::size_t i = 0; i < inputs; ++i) {
      network.set_weight(layer, neuron, i, lines_.number(words[4 + i]));
    }
  }

  DataFileReader lines_;
};

}  // namespace

std::string_view Weights::remark(std::string_view key) const { return neural::remark(about, key); }

std::string weights_text(const Weights& weights) {
  const Network& network = weights.network;
  if (!network.is_finite()) {
    throw std::invalid_argument("A network whose weights are not all finite cannot be written.");
  }
  std::string text = first_line(kWeights) + "sizes";
  for (const int size : network.sizes()) {
    text += ' ' + std::to_string(size);
  }
  text += '\n' + remark_lines(weights.about);
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
  return WeightsReader(text, name).read();
}

Weights read_weights(const std::string& path) {
  return parse_weights(read_data_file(kWeights, path), path);
}

bool looks_like_weights(const std::string& path) { return looks_like(kWeights, path); }

void write_weights(const Weights& weights, const std::string& path) {
  write_data_file(kWeights, path, weights_text(weights));
}

}  // namespace elsie::neural
