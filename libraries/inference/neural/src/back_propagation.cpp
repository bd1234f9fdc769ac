#include "elsie/neural/back_propagation.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "lanes.h"
#include "logistic.h"
#include "text.h"

namespace elsie::neural {
namespace {

/// The way in which a part of a layer passes on deltas.
enum class Passing {
  nothing,  // the network's inputs have no deltas
  whole,    // the part is the whole layer
  added     // other parts add to it; the caller completes the sum
};

/// Changes one row of weights, those from one input; `rate` is learning rate x input. Returns the
/// sum of delta x old weight, in two halves.
template <std::size_t Pairs>
ELSIE_INLINE Pair change_row(double* weights, double* changes, const Pair* deltas, Pair rate,
                             Pair momentum, Pair carried) {
  Pair sum = both(0.0);
  for (std::size_t k = 0; k < Pairs; ++k) {
    const Pair weight = load(weights + 2 * k);
    const Pair kept = momentum * load(changes + 2 * k);
    const Pair learned = rate * deltas[k];
    sum = k == 0 ? weight * deltas[k] : sum + weight * deltas[k];
    store(changes + 2 * k, learned + carried * kept);
    // In this order, work that does not need the deltas is done first.
    store(weights + 2 * k, (weight + kept) + learned);
  }
  return sum;
}

/// Changes the weights of `Pairs` pairs of neurons, from all inputs of their layer.
template <std::size_t Pairs, Passing passing, class Factors>
ELSIE_INLINE void change_part(double* weights, double* changes, std::size_t inputs,
                              std::size_t stride, const double* from, const double* deltas,
                              double* passed, const Factors& rule) {
  Pair delta[Pairs];
  for (std::size_t k = 0; k < Pairs; ++k) {
    delta[k] = load(deltas + 2 * k);
  }
  const auto pass_on = [&](std::size_t i, Pair sum, Pair answer) {
    if constexpr (passing == Passing::whole) {
      store(passed + i, sum * (answer * (both(1.0) - answer)));
    } else if constexpr (passing == Passing::added) {
      store(passed + i, load(passed + i) + sum);
    }
  };
  std::size_t i = 0;
  for (; i + 2 <= inputs; i += 2) {
    const Pair answer = load(from + i);
    const Pair rate = rule.learning_rate * answer;
    const std::size_t row = i * stride;
    const Pair a = change_row<Pairs>(weights + row, changes + row, delta, first_twice(rate),
                                     rule.momentum, rule.carried);
    const Pair b = change_row<Pairs>(weights + row + stride, changes + row + stride, delta,
                                     second_twice(rate), rule.momentum, rule.carried);
    pass_on(i, sums(a, b), answer);
  }
  if (i < inputs) {
    const Pair answer = load(from + i);
    const Pair a =
        change_row<Pairs>(weights + i * stride, changes + i * stride, delta,
                          first_twice(rule.learning_rate * answer), rule.momentum, rule.carried);
    pass_on(i, sums(a, both(0.0)), answer);
  }
  change_row<Pairs>(weights + inputs * stride, changes + inputs * stride, delta, rule.learning_rate,
                    rule.momentum, rule.carried);
}

void check_part(const char* name, double value) {
  if (!(value > 0.0 && value < 1.0)) {
    throw std::invalid_argument(std::string("the ") + name + " is " + number_text(value) +
                                ", but must be a number above 0 and below 1");
  }
}

}  // namespace

void check(const LearningRule& rule) {
  check_part("learning rate", rule.learning_rate);
  check_part("momentum", rule.momentum);
}

/// The numbers of a rule, as pairs. What a weight learned is kept with the learning rate in it, so
/// that the original's momentum is divided by that.
struct BackPropagation::Factors {
  Pair learning_rate;
  Pair momentum;  // of what was kept
  Pair carried;   // 1 or 0: whether momentum itself is kept
};

BackPropagation::Factors BackPropagation::factors() const {
  const bool accumulates = rule_.method == Method::standard;
  return {both(rule_.learning_rate),
          both(accumulates ? rule_.momentum : rule_.momentum / rule_.learning_rate),
          both(accumulates ? 1.0 : 0.0)};
}

BackPropagation::BackPropagation(Network& network, const LearningRule& rule)
    : network_(network),
      rule_(rule),
      workspace_(network),
      deltas_(network.activations_, 0.0),
      changes_(network.weights_.size(), 0.0) {
  check(rule);
}

double BackPropagation::present(std::span<const double> inputs, std::span<const double> targets) {
  double* const activations = workspace_.activations_.data();
  std::copy(inputs.begin(), inputs.end(), activations);
  network_.propagate(activations);
  const double error = output_deltas(targets.data());
  for (std::size_t l = network_.layers_.size(); l-- > 1;) {
    change<false>(network_.layers_[l]);
  }
  change<true>(network_.layers_.front());
  return error;
}

double BackPropagation::output_deltas(const double* targets) {
  const Layer& layer = network_.layers_.back();
  const double* const answers = workspace_.activations_.data() + layer.outputs_at;
  double* const deltas = deltas_.data() + layer.outputs_at;
  Pair squares = both(0.0);
  const auto treat = [&](std::size_t j, Pair missing) {
    const Pair answer = load(answers + j);
    squares += missing * missing;
    store(deltas + j, answer * (both(1.0) - answer) * missing);
  };
  std::size_t j = 0;
  for (; j + 2 <= layer.outputs; j += 2) {
    treat(j, load(targets + j) - load(answers + j));
  }
  if (j < layer.outputs) {
    treat(j, Pair{targets[j] - answers[j], 0.0});
  }
  return 0.5 * (squares[0] + squares[1]);
}

template <bool First>
ELSIE_INLINE void BackPropagation::change(const Layer& layer) {
  const Factors rule = factors();
  double* const weights = network_.weights_.data() + layer.weights;
  double* const changes = changes_.data() + layer.weights;
  const double* const from = workspace_.activations_.data() + layer.inputs_at;
  const double* const deltas = deltas_.data() + layer.outputs_at;
  double* const passed = deltas_.data() + layer.inputs_at;
  constexpr Passing kWhole = First ? Passing::nothing : Passing::whole;
  constexpr Passing kAdded = First ? Passing::nothing : Passing::added;
  const auto part = [&]<std::size_t Pairs, Passing passing>(std::size_t j) {
    change_part<Pairs, passing>(weights + j, changes + j, layer.inputs, layer.stride, from,
                                deltas + j, passed, rule);
  };
  switch (layer.stride) {
    case 2:
      return part.template operator()<1, kWhole>(0);
    case 4:
      return part.template operator()<2, kWhole>(0);
    case 6:
      return part.template operator()<3, kWhole>(0);
    case 8:
      return part.template operator()<4, kWhole>(0);
    default:
      break;
  }
  std::fill_n(passed, First ? 0 : padded(layer.inputs), 0.0);
  std::size_t j = 0;
  for (; j + 8 <= layer.stride; j += 8) {
    part.template operator()<4, kAdded>(j);
  }
  if (j + 4 <= layer.stride) {
    part.template operator()<2, kAdded>(j);
    j += 4;
  }
  if (j < layer.stride) {
    part.template operator()<1, kAdded>(j);
  }
  for (std::size_t i = 0; !First && i < layer.inputs; i += 2) {
    const Pair answer = load(from + i);
    store(passed + i, load(passed + i) * (answer * (both(1.0) - answer)));
  }
}

}  // namespace elsie::neural
