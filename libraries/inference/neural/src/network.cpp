#include "elsie/neural/network.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "lanes.h"
#include "logistic.h"
#include "text.h"

namespace elsie::neural {
namespace {

/// The answers of `Pairs` pairs of neurons. `weights` points into the first row of their layer.
template <std::size_t Pairs>
ELSIE_INLINE void answer(const double* weights, std::size_t inputs, std::size_t stride,
                         const double* from, double* to) {
  Pair sum[Pairs];
  const double* const biases = weights + inputs * stride;
  for (std::size_t k = 0; k < Pairs; ++k) {
    sum[k] = load(biases + 2 * k);
  }
  std::size_t i = 0;
  for (; i + 2 <= inputs; i += 2) {
    const Pair a = both(from[i]), b = both(from[i + 1]);
    const double* const row = weights + i * stride;
    for (std::size_t k = 0; k < Pairs; ++k) {
      sum[k] += a * load(row + 2 * k) + b * load(row + stride + 2 * k);
    }
  }
  if (i < inputs) {
    const Pair a = both(from[i]);
    const double* const row = weights + i * stride;
    for (std::size_t k = 0; k < Pairs; ++k) {
      sum[k] += a * load(row + 2 * k);
    }
  }
  for (std::size_t k = 0; k < Pairs; ++k) {
    store(to + 2 * k, logistic(sum[k]));
  }
}

/// The answers of a whole layer of any width.
ELSIE_INLINE void answer_all(const double* weights, std::size_t inputs, std::size_t stride,
                             const double* from, double* to) {
  switch (stride) {
    case 2:
      return answer<1>(weights, inputs, 2, from, to);
    case 4:
      return answer<2>(weights, inputs, 4, from, to);
    case 6:
      return answer<3>(weights, inputs, 6, from, to);
    case 8:
      return answer<4>(weights, inputs, 8, from, to);
    default:
      break;
  }
  std::size_t j = 0;
  for (; j + 8 <= stride; j += 8) {
    answer<4>(weights + j, inputs, stride, from, to + j);
  }
  if (j + 4 <= stride) {
    answer<2>(weights + j, inputs, stride, from, to + j);
    j += 4;
  }
  if (j < stride) {
    answer<1>(weights + j, inputs, stride, from, to + j);
  }
}

/// 2 r / m - 1 in whole numbers, for a random r from 0 to m = 32767.
double original_weight(Random& random) {
  constexpr std::uint64_t kMost = 32767;
  const std::uint64_t drawn = random.bits() >> 49;  // 15 bits
  const std::uint64_t quotient = 2 * drawn / kMost;
  return static_cast<double>(quotient) - 1.0;
}

}  // namespace

Workspace::Workspace(const Network& network) : activations_(network.activations_) {}

Network::Network(std::vector<int> sizes) : sizes_(std::move(sizes)) {
  if (sizes_.size() < 2 || *std::min_element(sizes_.begin(), sizes_.end()) < 1) {
    throw std::invalid_argument("A network of the sizes '" + sizes_text(sizes_) +
                                "' cannot be made: it needs inputs and outputs, and at least one "
                                "neuron in each layer.");
  }
  std::size_t weights = 0;
  for (std::size_t l = 0; l + 1 < sizes_.size() && weights <= kMostWeights; ++l) {
    weights += (static_cast<std::size_t>(sizes_[l]) + 1) * static_cast<std::size_t>(sizes_[l + 1]);
  }
  if (sizes_.size() - 1 > kMostLayers || weights > kMostWeights) {
    throw std::invalid_argument(
        "A network of " + std::to_string(sizes_.size() - 1) + " layers and " +
        std::to_string(weights) + " or more weights is too large: expected at most " +
        std::to_string(kMostLayers) + " layers and " + std::to_string(kMostWeights) + " weights.");
  }
  std::size_t at = 0;
  for (std::size_t l = 0; l + 1 < sizes_.size(); ++l) {
    Layer layer{};
    layer.inputs = static_cast<std::size_t>(sizes_[l]);
    layer.outputs = static_cast<std::size_t>(sizes_[l + 1]);
    layer.stride = padded(layer.outputs);
    layer.weights = at;
    layer.inputs_at = activations_;
    layer.outputs_at = activations_ + padded(layer.inputs);
    at += (layer.inputs + 1) * layer.stride;
    activations_ = layer.outputs_at;
    layers_.push_back(layer);
  }
  activations_ += padded(outputs());
  weights_.resize(at, 0.0);
}

void Network::randomize(Random& random, Method method) {
  const auto draw = [&] {
    return method == Method::original ? original_weight(random) : random.uniform(-1.0, 1.0);
  };
  for (std::size_t l = 0; l < layers(); ++l) {
    for (std::size_t n = 0; n < neurons(l); ++n) {
      for (std::size_t i = 0; i < inputs(l); ++i) {
        set_weight(l, n, i, draw());
      }
      set_bias(l, n, draw());
    }
  }
}

bool Network::is_finite() const {
  return std::all_of(weights_.begin(), weights_.end(), [](double w) { return std::isfinite(w); });
}

void Network::evaluate(std::span<const double> inputs, std::span<double> outputs,
                       Workspace& workspace) const {
  double* const activations = workspace.activations_.data();
  std::copy(inputs.begin(), inputs.end(), activations);
  propagate(activations);
  std::copy_n(activations + layers_.back().outputs_at, outputs.size(), outputs.begin());
}

void Network::propagate(double* activations) const {
  for (const Layer& layer : layers_) {
    answer_all(weights_.data() + layer.weights, layer.inputs, layer.stride,
               activations + layer.inputs_at, activations + layer.outputs_at);
  }
}

std::vector<int> parse_hidden_layers(std::string_view text) {
  const auto refuse = [&](const std::string& problem) {
    throw std::invalid_argument(
        "hidden is " + in_quotes(text) + ": " + problem +
        "; expected how many neurons each hidden layer has, such as '4 4', or '0' for none");
  };
  const std::vector<std::string_view> words = words_of(text);
  if (words.empty() || (words.size() == 1 && words[0] == "0")) {
    return {};
  }
  std::vector<int> layers;
  for (const std::string_view word : words) {
    long long size = 0;
    if (!read_count(word, 1, size)) {
      refuse(in_quotes(word) + " is not a whole number above zero");
    }
    if (size > static_cast<long long>(kMostWeights)) {
      refuse("a layer of " + std::string(word) + " neurons is too large");
    }
    layers.push_back(static_cast<int>(size));
  }
  return layers;
}

std::string sizes_text(std::span<const int> sizes) {
  std::string text;
  for (const int size : sizes) {
    text += (text.empty() ? "" : "-") + std::to_string(size);
  }
  return text;
}

}  // namespace elsie::neural
