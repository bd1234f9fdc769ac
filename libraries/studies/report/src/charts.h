// Charts of the results, for the page and for files of their own.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "elsie/picture/plot.h"
#include "elsie/report/factor_models.h"
#include "elsie/report/margins.h"

#include "figures.h"

namespace elsie::report {

struct Chart {
  std::string name;     // of its file, without a suffix: "effect-time_s-max_speed"
  std::string caption;  // a sentence
  picture::Panel panel;
  std::vector<std::string> notes{};  // what it leaves out, as sentences without a full stop
};

/// A number that is not drawn.
inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// More levels make no readable lines.
inline constexpr std::size_t kMostLines = 6;

/// The main effects of each varied factor on a response, over a common range; "" for none.
std::vector<Chart> effect_charts(const Findings& findings, const Response& response);

/// Of each pair of varied factors: the response by both, as lines where one has few levels, and as
/// tiles.
std::vector<Chart> pair_charts(const Findings& findings, const Response& response,
                               const Inks& inks);

/// How well a model fits: the residuals of a measure in each cell, or fitted against observed rates
/// of success.
Chart model_chart(const Findings& findings, const FactorModel& model);

/// The part of the runs that has not yet reached its goals, in each cell; cells that differ in the
/// coloured factor only are in one chart.
std::vector<Chart> survival_charts(const Findings& findings, const Inks& inks);

/// What happened over time, by the levels of each varied factor: distance driven, and events.
/// Reads the file.
std::vector<Chart> series_charts(const Findings& findings, const ResultsFile& file,
                                 const Inks& inks);

/// Box plots of a measure, and the rates of success, in the cells `from` to `to`.
Chart box_chart(const Findings& findings, std::size_t measure, const Inks& inks, std::size_t from,
                std::size_t to);
Chart rate_chart(const Findings& findings, const Inks& inks, std::size_t from, std::size_t to);

/// What plugins learned before the runs of a cell.
std::vector<Chart> learning_charts(const Findings& findings, std::size_t cell,
                                   const std::vector<Curve>& curves);

/// Who decided when in the runs of a cell, in at most `most` rows; the note says which. None if
/// nothing was recorded.
std::vector<Chart> decision_charts(const Findings& findings, std::size_t cell,
                                   const std::vector<Timeline>& timelines, const Inks& inks,
                                   std::size_t most);

/// The label of a cell, short enough for a row; "all" without one.
std::string row_name(const Findings& findings, std::size_t cell);

/// A text as a part of a file's name: letters, digits, and . _ - stay, others become _.
std::string file_part(const std::string& text);

/// The axis of a response.
picture::Axis axis_of(const Response& response);

/// The colours of the levels of a factor: those of the page if it is the coloured one, else none.
std::vector<std::size_t> level_colours(const VariedFactor& factor, const Inks& inks);

}  // namespace elsie::report
