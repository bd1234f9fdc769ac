// Binds the bases of elsie.Fuzzy and elsie.Network.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "elsie/base/error.h"
#include "elsie/fuzzy/fcl.h"
#include "elsie/neural/assessment.h"
#include "elsie/neural/network.h"
#include "elsie/neural/trainable.h"
#include "elsie/neural/training.h"
#include "elsie/neural/training_set.h"
#include "elsie/neural/weights.h"
#include "elsie/world/data_directories.h"
#include "elsie/world/files.h"

#include "bindings.h"
#include "made.h"

namespace elsie::python {
namespace {

struct Fuzzy : Made {
  explicit Fuzzy(fuzzy::Model read) : model(std::move(read)) {}
  fuzzy::Model model;
};

struct Network : Made {
  explicit Network(neural::Weights read) : weights(std::move(read)) {}
  neural::Weights weights;
};

/// The file of this name, or the shipped one; else the name, for the reader to complain about.
std::string found(const std::string& name) {
  std::error_code error;
  const std::filesystem::path file(name);
  if (file.is_absolute() || std::filesystem::exists(file, error)) return name;
  return world::Files(name, world::default_data_directories()).find_data(name).value_or(name);
}

/// Numbers in rows; anything that numpy makes such an array of.
using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::span<const double> row(const Rows& rows, py::ssize_t i) {
  return {rows.data(i, 0), static_cast<std::size_t>(rows.shape(1))};
}

void require_columns(const Rows& rows, std::size_t columns, const char* of) {
  if (rows.ndim() != 2 || static_cast<std::size_t>(rows.shape(1)) != columns) {
    throw base::BadInput(std::string(of) + ": expected rows of " + std::to_string(columns) +
                         " numbers, found an array of shape " +
                         std::string(py::str(rows.attr("shape"))));
  }
}

/// The answers to rows of numbers.
template <class Evaluate>
Rows answers(const Rows& inputs, std::size_t outputs, const Evaluate& evaluate) {
  Rows all({inputs.shape(0), static_cast<py::ssize_t>(outputs)});
  for (py::ssize_t i = 0; i < inputs.shape(0); ++i) {
    evaluate(row(inputs, i), std::span<double>(all.mutable_data(i, 0), outputs));
  }
  return all;
}

Rows evaluate(const fuzzy::Model& model, const Rows& inputs) {
  require_columns(inputs, model.inputs().size(), "inputs");
  fuzzy::Workspace workspace;
  return answers(inputs, model.outputs().size(), [&](auto in, auto out) {
    std::fill(out.begin(), out.end(), std::numeric_limits<double>::quiet_NaN());
    model.evaluate(in, out, workspace);
  });
}

Rows degrees(const fuzzy::Model& model, const Rows& inputs) {
  require_columns(inputs, model.inputs().size(), "inputs");
  fuzzy::Workspace workspace;
  return answers(inputs, model.rules().size(),
                 [&](auto in, auto out) { model.rule_degrees(in, out, workspace); });
}

/// (name, lowest, highest) of each variable.
template <class Variables>
py::list variables_of(const Variables& variables) {
  py::list all;
  for (const fuzzy::Variable& variable : variables) {
    all.append(py::make_tuple(variable.name, variable.range.low, variable.range.high));
  }
  return all;
}

void bind_fuzzy(py::module_& module) {
  py::class_<Fuzzy>(module, "Fuzzy", "The base of elsie.Fuzzy.")
      .def(py::init([](const std::optional<std::string>& text, const std::string& file,
                       const std::string& block) {
             return made<Fuzzy>(text ? fuzzy::parse_fcl(*text, file, block)
                                     : fuzzy::read_fcl(found(file), block));
           }),
           py::arg("text"), py::arg("file"), py::arg("block"))
      .def_property_readonly(
          "name", [](const Fuzzy& self) { return self.model.name(); }, "Of the function block.")
      .def("_all_inputs", [](const Fuzzy& self) { return variables_of(self.model.inputs()); })
      .def("_all_outputs", [](const Fuzzy& self) { return variables_of(self.model.outputs()); })
      .def("_all_rules",
           [](const Fuzzy& self) {
             py::list rules;
             for (const fuzzy::Rule& rule : self.model.rules()) rules.append(rule.text);
             return rules;
           })
      .def("_rows",
           [](const Fuzzy& self, const Rows& inputs) { return evaluate(self.model, inputs); })
      .def("_degrees_of_rows",
           [](const Fuzzy& self, const Rows& inputs) { return degrees(self.model, inputs); });
}

neural::Method method_of(const std::string& name) {
  if (name == "standard") return neural::Method::standard;
  if (name == "original") return neural::Method::original;
  throw base::BadInput("method: expected 'standard' or 'original', found '" + name + "'");
}

std::unique_ptr<Network> drawn(const std::vector<int>& sizes, std::uint64_t seed,
                               const std::string& method) {
  neural::Network network(sizes);
  Random random = neural::stream_of_seed(seed);
  network.randomize(random, method_of(method));
  return made<Network>(neural::Weights{std::move(network), {}});
}

/// (how it ended, presentations, [(presentations, error), ...])
py::tuple train(Network& self, const Rows& inputs, const Rows& targets, double learning_rate,
                double momentum, const std::string& method, double threshold,
                std::uint64_t presentations) {
  neural::Network& network = self.weights.network;
  require_columns(inputs, network.inputs(), "inputs");
  require_columns(targets, network.outputs(), "targets");
  if (inputs.shape(0) != targets.shape(0)) {
    throw base::BadInput("there are " + std::to_string(inputs.shape(0)) + " rows of inputs, but " +
                         std::to_string(targets.shape(0)) + " of targets");
  }
  neural::TrainingSet samples(network.inputs(), network.outputs());
  for (py::ssize_t i = 0; i < inputs.shape(0); ++i) samples.add(row(inputs, i), row(targets, i));
  const neural::TrainingOptions options{
      {learning_rate, momentum, method_of(method)}, threshold, presentations};
  neural::Network learning = network;  // it stays as it is if it cannot learn, or is interrupted
  const neural::Training training =
      neural::train(learning, samples, options, [](const neural::TrainingProgress&) {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        return true;
      });
  network = std::move(learning);
  py::list curve;
  for (const neural::CurvePoint& point : training.curve) {
    curve.append(py::make_tuple(static_cast<double>(point.presentations), point.error));
  }
  return py::make_tuple(
      training.ending == neural::Ending::threshold ? "threshold" : "presentations",
      training.presentations, curve);
}

void require_layer(const neural::Network& network, std::size_t layer) {
  if (layer >= network.layers()) {
    throw base::BadInput("there is no layer " + std::to_string(layer) + " of neurons; there are " +
                         std::to_string(network.layers()));
  }
}

/// A row for each neuron of a layer: the weights of its inputs, then its bias.
Rows weights_of(const Network& self, std::size_t layer) {
  const neural::Network& network = self.weights.network;
  require_layer(network, layer);
  const std::size_t inputs = network.inputs(layer), neurons = network.neurons(layer);
  Rows rows({static_cast<py::ssize_t>(neurons), static_cast<py::ssize_t>(inputs + 1)});
  auto at = rows.mutable_unchecked<2>();
  for (std::size_t n = 0; n < neurons; ++n) {
    const auto r = static_cast<py::ssize_t>(n);
    for (std::size_t i = 0; i < inputs; ++i) {
      at(r, static_cast<py::ssize_t>(i)) = network.weight(layer, n, i);
    }
    at(r, static_cast<py::ssize_t>(inputs)) = network.bias(layer, n);
  }
  return rows;
}

void set_weights(Network& self, std::size_t layer, const Rows& rows) {
  neural::Network& network = self.weights.network;
  require_layer(network, layer);
  const std::size_t inputs = network.inputs(layer), neurons = network.neurons(layer);
  require_columns(rows, inputs + 1, "weights");
  if (static_cast<std::size_t>(rows.shape(0)) != neurons) {
    throw base::BadInput("weights: expected a row for each of " + std::to_string(neurons) +
                         " neurons, found " + std::to_string(rows.shape(0)));
  }
  neural::Network next = network;
  for (std::size_t n = 0; n < neurons; ++n) {
    const auto numbers = row(rows, static_cast<py::ssize_t>(n));
    for (std::size_t i = 0; i < inputs; ++i) next.set_weight(layer, n, i, numbers[i]);
    next.set_bias(layer, n, numbers[inputs]);
  }
  if (!next.is_finite()) throw base::BadInput("weights: expected finite numbers only");
  network = std::move(next);
}

Rows evaluate_network(const Network& self, const Rows& inputs) {
  require_columns(inputs, self.weights.network.inputs(), "inputs");
  for (py::ssize_t i = 0; i < inputs.size(); ++i) {
    if (!std::isfinite(inputs.data()[i])) {
      throw base::BadInput("inputs: expected finite numbers only");
    }
  }
  const neural::Network& network = self.weights.network;
  neural::Workspace workspace(network);
  return answers(inputs, network.outputs(),
                 [&](auto in, auto out) { network.evaluate(in, out, workspace); });
}

void bind_network(py::module_& module) {
  py::class_<Network>(module, "Network", "The base of elsie.Network.")
      .def(py::init(&drawn), py::arg("sizes"), py::arg("seed"), py::arg("method"))
      .def(py::init([](const std::string& file) {
             return made<Network>(neural::read_weights(found(file)));
           }),
           py::arg("file"))
      .def_property_readonly(
          "sizes",
          [](const Network& self) {
            const auto sizes = self.weights.network.sizes();
            return py::tuple(py::cast(std::vector<int>(sizes.begin(), sizes.end())));
          },
          "Inputs, neurons of each hidden layer, outputs.")
      .def("_save_as", [](const Network& self,
                          const std::string& file) { neural::write_weights(self.weights, file); })
      .def("_layer", &weights_of)
      .def("_set_layer", &set_weights)
      .def("_rows", &evaluate_network)
      .def("_train_rows", &train);
}

}  // namespace

void bind_inference(py::module_& module) {
  bind_fuzzy(module);
  bind_network(module);
}

}  // namespace elsie::python
