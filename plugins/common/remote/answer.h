// What a program answers: reading an object field by field, and refusing what is not expected.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <elsie/api/behavior.h>

#include "perceived.h"

namespace remote {

/// Thrown by what reads an answer: the end of the sentence "it answered '...': ".
class Unexpected : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An object of an answer. Every function throws Unexpected for a field of another type.
class Answer {
 public:
  /// `where`: how sentences about it begin, "in 'acts', "; empty: it is the whole line.
  explicit Answer(const Json& object, std::string where = {});

  bool has(const std::string& name) const { return object_->contains(name); }
  std::optional<double> number(const std::string& name);
  /// In [0, 1].
  double degree(const std::string& name, double otherwise);
  bool flag(const std::string& name);
  std::string text(const std::string& name, const std::string& otherwise = {});
  /// A list of so many numbers of at least 0; empty if it is not there.
  std::vector<double> weights(const std::string& name, std::size_t size);
  /// The objects of a list.
  std::vector<Answer> list(const std::string& name);
  std::vector<std::string> texts(const std::string& name);
  /// All numbers of an object that is a field.
  elsie::NamedNumbers numbers(const std::string& name);
  /// All fields that have not been read, which are numbers.
  elsie::NamedNumbers rest();
  /// The motion that "forward", "lateral" and "turn", or "left" and "right" command.
  std::optional<elsie::Motion> motion(const elsie::WheelPair& wheels);
  elsie::Status status();
  /// Refuses fields that have not been read.
  void finish();

 private:
  const Json* find(const std::string& name);
  [[noreturn]] void refuse(const std::string& problem) const;
  [[noreturn]] void refuse(const std::string& name, const Json& found,
                           const std::string& expected) const;

  const Json* object_;
  std::string where_;
  std::vector<std::string> read_;
};

/// A behaviour's answer.
elsie::Response response(Answer& answer, const elsie::WheelPair& wheels);

}  // namespace remote
