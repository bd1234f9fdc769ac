// The test library with Catch2 2.13 or 3: expectations are Catch2 matchers; this header lets Catch2
// print what they check.
//
//   CHECK_THAT(shy.respond(now), turns_left());
//   CHECK_THAT(trace, equals_golden("shy.golden"));
//   CHECK_THAT(check_plugin(PluginKind::behavior, "shy"), finds_nothing());
#pragma once

#include <string>
#include <vector>

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;  // as in Catch2 2.13, so that a test compiles with both
#else
#include <catch2/catch.hpp>
#endif

#include "elsie/testing/testing.h"

namespace Catch {

template <>
struct StringMaker<elsie::Motion> {
  static std::string convert(const elsie::Motion& motion) { return elsie::testing::text(motion); }
};

template <>
struct StringMaker<elsie::Response> {
  static std::string convert(const elsie::Response& response) {
    return elsie::testing::text(response);
  }
};

template <>
struct StringMaker<elsie::testing::Trace> {
  static std::string convert(const elsie::testing::Trace& trace) {
    return "a trace of " + std::to_string(trace.rows.size()) + " steps";
  }
};

template <>
struct StringMaker<elsie::testing::Verdict> {
  static std::string convert(const elsie::testing::Verdict& verdict) {
    return verdict.holds ? "as it should be" : verdict.sentence;
  }
};

}  // namespace Catch

namespace elsie::testing {

/// Matches a trace that equals its golden file; see compare_with_golden().
class EqualsGolden {
 public:
  EqualsGolden(std::string file, double tolerance)
      : file_(std::move(file)), tolerance_(tolerance) {}
  bool match(const Trace& trace) const {
    verdict_ = compare_with_golden(trace, file_, tolerance_);
    return verdict_.holds;
  }
  std::string toString() const {
    return "should be as in " + file_ + (verdict_ ? "" : ": " + verdict_.sentence);
  }

 private:
  std::string file_;
  double tolerance_;
  mutable Verdict verdict_;
};
inline EqualsGolden equals_golden(std::string file, double tolerance = 1e-6) {
  return {std::move(file), tolerance};
}

/// Matches a checker's result without findings.
class FindsNothing {
 public:
  bool match(const std::vector<std::string>& findings) const { return findings.empty(); }
  std::string toString() const { return "should be nothing"; }
};
inline FindsNothing finds_nothing() { return {}; }

}  // namespace elsie::testing
