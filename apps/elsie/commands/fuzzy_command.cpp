// elsie fuzzy: shows a fuzzy model, evaluates it and draws it.
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "elsie/base/number_text.h"
#include "elsie/files/outputs.h"
#include "elsie/fuzzy/fcl.h"
#include "elsie/picture/fuzzy_plot.h"

#include "arguments.h"
#include "command.h"
#include "environment.h"
#include "output_files.h"
#include "streams.h"

namespace elsie::program {

namespace {

using fuzzy::Model;
using fuzzy::OutputVariable;
using fuzzy::Variable;

struct FuzzyOptions {
  std::string model;
  std::string block;
  std::vector<std::string> inputs;
  std::optional<std::string> picture;
  bool json = false;
};

struct Evaluation {
  std::vector<double> inputs;
  std::vector<double> outputs;
  std::vector<double> degrees;  // of the rules
};

/// Of an output that no rule decides and that has no last value to keep.
constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

std::string digits(double value) { return base::number_text(value, 6); }

std::string names_of(std::span<const Variable> variables) {
  std::string names;
  for (const Variable& variable : variables) {
    names += (names.empty() ? "" : ", ") + variable.name;
  }
  return names;
}

double middle(const Variable& variable) { return 0.5 * (variable.range.low + variable.range.high); }

/// The inputs in the model's order; all must be given.
std::vector<double> parse_inputs(const Model& model, const std::vector<std::string>& given) {
  std::map<std::size_t, double> values;
  for (const std::string& text : given) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const auto index = model.input_index(name);
    if (equals == std::string::npos || !index) {
      throw BadInput(
          "--input: '" + text +
          "' is not NAME=VALUE with an input of the model; it has: " + names_of(model.inputs()));
    }
    const auto value = parse_number(std::string_view(text).substr(equals + 1));
    if (!value) {
      throw BadInput("--input: '" + text + "': the value must be a finite number such as 0.5");
    }
    if (!values.emplace(*index, *value).second) {
      throw BadInput("--input: '" + name + "' is given twice");
    }
  }
  std::vector<double> inputs;
  for (std::size_t i = 0; i < model.inputs().size(); ++i) {
    if (!values.contains(i)) {
      throw BadInput("--input: the model needs a value for '" + model.inputs()[i].name + "' too");
    }
    inputs.push_back(values[i]);
  }
  return inputs;
}

Evaluation evaluate(const Model& model, const std::vector<double>& inputs) {
  fuzzy::Workspace workspace;
  Evaluation evaluation{inputs, std::vector<double>(model.outputs().size(), kNoValue),
                        std::vector<double>(model.rules().size())};
  try {
    model.evaluate(inputs, evaluation.outputs, workspace);
  } catch (const std::invalid_argument& error) {  // a formula without a value for these inputs
    throw BadInput(error.what());
  }
  model.rule_degrees(inputs, evaluation.degrees, workspace);
  return evaluation;
}

void print_variable(const char* kind, const Variable& variable) {
  out() << kind << ' ' << variable.name << " in [" << digits(variable.range.low) << ", "
        << digits(variable.range.high) << "]\n";
  for (const fuzzy::Term& term : variable.terms) {
    out() << "  " << term.name << ":";
    if (!term.formula.empty()) {
      out() << ' ' << term.formula;
    } else if (!term.linear.empty()) {
      for (std::size_t i = 0; i + 1 < term.linear.size(); ++i) {
        out() << (i > 0 ? " + " : " ") << digits(term.linear[i]) << " x" << i + 1;
      }
      out() << " + " << digits(term.linear.back());
    } else if (term.singleton) {
      out() << ' ' << digits(*term.singleton);
    } else if (constexpr std::size_t kShown = 12; term.set.points.size() > kShown) {
      out() << " a curve from " << digits(term.set.points.front().x) << " to "
            << digits(term.set.points.back().x);
    } else {
      for (const auto& point : term.set.points) {
        out() << " (" << digits(point.x) << ", " << digits(point.degree) << ')';
      }
    }
    out() << '\n';
  }
}

void print(const Model& model, const std::optional<Evaluation>& evaluation) {
  out() << "model " << model.name() << '\n';
  for (const Variable& input : model.inputs()) {
    print_variable("input", input);
  }
  for (const OutputVariable& output : model.outputs()) {
    print_variable("output", output);
  }
  out() << "rules\n";
  for (std::size_t i = 0; i < model.rules().size(); ++i) {
    const fuzzy::Rule& rule = model.rules()[i];
    out() << "  " << rule.label << ": " << rule.text;
    if (rule.weight != 1.0) {
      out() << " WITH " << digits(rule.weight);
    }
    if (evaluation) {
      out() << "   [" << digits(evaluation->degrees[i]) << ']';
    }
    out() << '\n';
  }
  if (evaluation) {
    out() << "result\n";
    for (std::size_t i = 0; i < model.outputs().size(); ++i) {
      const OutputVariable& output = model.outputs()[i];
      const bool keeps = output.keeps_last && std::isnan(evaluation->outputs[i]);
      out() << "  " << output.name << " = "
            << (keeps ? "its last value: no rule decides it, and it has DEFAULT := NC"
                      : digits(evaluation->outputs[i]))
            << '\n';
    }
  }
}

nlohmann::ordered_json to_json(const Variable& variable) {
  nlohmann::ordered_json terms = nlohmann::ordered_json::object();
  for (const fuzzy::Term& term : variable.terms) {
    auto points = nlohmann::ordered_json::array();
    for (const auto& point : term.set.points) {
      points.push_back({point.x, point.degree});
    }
    terms[term.name] = term.formula.empty() ? points : nlohmann::ordered_json(term.formula);
  }
  return {{"name", variable.name},
          {"range", {variable.range.low, variable.range.high}},
          {"terms", terms}};
}

void print_json(const Model& model, const std::optional<Evaluation>& evaluation) {
  nlohmann::ordered_json object{{"model", model.name()}};
  object["inputs"] = nlohmann::ordered_json::array();
  for (const Variable& input : model.inputs()) {
    object["inputs"].push_back(to_json(input));
  }
  object["outputs"] = nlohmann::ordered_json::array();
  for (const OutputVariable& output : model.outputs()) {
    object["outputs"].push_back(to_json(output));
    if (output.gap) {
      object["outputs"].back()["gap"] = *output.gap;
    }
  }
  object["rules"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < model.rules().size(); ++i) {
    const fuzzy::Rule& rule = model.rules()[i];
    nlohmann::ordered_json entry{{"block", rule.block}, {"label", rule.label}, {"text", rule.text}};
    entry["weight"] = rule.weight;
    if (evaluation) {
      entry["degree"] = evaluation->degrees[i];
    }
    object["rules"].push_back(entry);
  }
  object["notes"] = nlohmann::ordered_json::array();
  for (const base::Problem& note : model.notes()) {
    object["notes"].push_back({{"line", note.line}, {"note", note.message}});
  }
  if (evaluation) {
    object["result"] = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < model.outputs().size(); ++i) {
      object["result"][model.outputs()[i].name] = evaluation->outputs[i];
    }
  }
  data_out() << object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)
             << '\n';
}

picture::SurfaceVariable axis(const Variable& variable) {
  return {variable.name, "", variable.range.low, variable.range.high};
}

/// The surface of one output over the first two inputs; other inputs stay in the middle of their
/// ranges.
picture::ControlSurface surface(const Model& model, std::size_t output) {
  picture::ControlSurface surface;
  surface.x = axis(model.inputs()[0]);
  if (model.inputs().size() > 1) {
    surface.y = axis(model.inputs()[1]);
  }
  surface.output = axis(model.outputs()[output]);
  std::vector<double> inputs;
  for (std::size_t i = 0; i < model.inputs().size(); ++i) {
    inputs.push_back(middle(model.inputs()[i]));
    if (i > 1) {
      surface.held.push_back({model.inputs()[i].name, "", inputs.back()});
    }
  }
  auto workspace = std::make_shared<fuzzy::Workspace>();
  surface.value = [model, output, inputs, workspace](double x, double y) mutable {
    inputs[0] = x;
    if (inputs.size() > 1) {
      inputs[1] = y;
    }
    std::vector<double> outputs(model.outputs().size(), kNoValue);
    try {
      model.evaluate(inputs, outputs, *workspace);
    } catch (const std::invalid_argument&) {
      return kNoValue;  // a formula without a value: a hole
    }
    return outputs[output];
  };
  return surface;
}

picture::MembershipPanel panel(const Variable& variable) {
  picture::MembershipPanel panel{variable.name, "", variable.range.low, variable.range.high, {}};
  for (const fuzzy::Term& term : variable.terms) {
    panel.terms.emplace_back(term.name, term.set);
  }
  return panel;
}

void draw_model(const Model& model, const std::string& file) {
  picture::FuzzyPicture picture;
  picture.title = model.name();
  for (const Variable& input : model.inputs()) {
    picture.variables.push_back(panel(input));
  }
  for (std::size_t i = 0; i < model.outputs().size(); ++i) {
    picture.variables.push_back(panel(model.outputs()[i]));
    picture.surfaces.push_back(surface(model, i));
  }
  picture::save_fuzzy_picture(picture, file);
}

int fuzzy(const FuzzyOptions& options) {
  if (options.picture) {
    files::require_apart({{"--picture", *options.picture}}, {options.model});
    require_picture(*options.picture, "--picture");
  }
  const Model model =
      elsie::fuzzy::read_fcl(options.model, options.block, elsie::fuzzy::Gaps::noted);
  for (const elsie::fuzzy::Problem& note : model.notes()) {
    spdlog::warn(note.text());
  }
  std::optional<Evaluation> evaluation;
  if (!options.inputs.empty()) {
    evaluation = evaluate(model, parse_inputs(model, options.inputs));
  }
  if (options.picture) {
    draw_model(model, *options.picture);
  }
  options.json ? print_json(model, evaluation) : print(model, evaluation);
  return kSuccess;
}

}  // namespace

void add_fuzzy_command(CLI::App& program, Job& job) {
  CLI::App* command =
      program.add_subcommand("fuzzy", "Show a fuzzy model (FCL), evaluate it, draw it");
  command->footer(
      "\nExamples:\n  elsie fuzzy fuzzy_models/avoid_obstacle_left.fcl\n"
      "  elsie fuzzy fuzzy_models/avoid_obstacle_left.fcl --input range=0.3 --input azimuth=20\n"
      "  elsie fuzzy fuzzy_models/avoid_obstacle_left.fcl --picture left.png\n");
  auto options = std::make_shared<FuzzyOptions>();
  command->add_option("MODEL", options->model, "Fuzzy model, a file in Fuzzy Control Language")
      ->required();
  command
      ->add_option("--block", options->block,
                   "Function block of the model, if the file has several")
      ->type_name("NAME");
  command
      ->add_option("--input", options->inputs,
                   "Value of an input, to evaluate the model; one for each input")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  command->add_flag("--json", options->json, "Print one JSON object, and nothing else");
  command
      ->add_option("--picture", options->picture,
                   "Draw the membership functions and the control surface")
      ->type_name("FILE.png|FILE.svg");
  command->callback([&job, options] { job = [options] { return fuzzy(*options); }; });
}

}  // namespace elsie::program
