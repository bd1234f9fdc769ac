// Weight files: a trained network as text.
//
//   elsie network 1
//   sizes 2 2 2
//   about inputs metres
//   neuron 1 1 -0.31 0.25 1.5
//   ...
//   end
//
// The first line names the version of the format. `sizes`: inputs, neurons of each layer. `about`:
// a word and a text, for the user of the network. `neuron`: its layer and its place there, both
// counted from 1, its bias, then the weight of each of its inputs; all neurons, in this order.
// Numbers are the shortest decimals that read back as the same: writing and reading keeps every
// bit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "elsie/neural/data_file.h"
#include "elsie/neural/network.h"

namespace elsie::neural {

inline constexpr int kWeightsVersion = 1;

struct Weights {
  Network network;
  std::vector<Remark> about{};

  /// The text of a remark, or "".
  std::string_view remark(std::string_view key) const;

  friend bool operator==(const Weights&, const Weights&) = default;
};

/// The content of a weight file. Throws std::invalid_argument for a weight that is not finite, and
/// for a remark whose key is no word or repeated, or whose text has several lines.
std::string weights_text(const Weights& weights);

/// Reads a weight file. Lines that it does not understand are errors. Throws FileError.
Weights read_weights(const std::string& path);

/// Reads weights from text; `name` is its name in messages. Throws FileError.
Weights parse_weights(std::string_view text, const std::string& name = "weights");

/// Whether the file begins like a weight file.
bool looks_like_weights(const std::string& path);

/// Writes a weight file in one piece, through a new file next to it. Throws as weights_text() does,
/// and std::runtime_error with file and reason when it cannot be written; an existing file is then
/// unchanged.
void write_weights(const Weights& weights, const std::string& path);

}  // namespace elsie::neural
