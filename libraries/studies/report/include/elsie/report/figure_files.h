// Every figure of the page as a file of its own.
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "elsie/report/answers.h"
#include "elsie/report/findings.h"
#include "elsie/report/results.h"

namespace elsie::report {

/// The suffixes of figures, without the dot.
inline const std::vector<std::string> kFigureFormats = {"svg", "pdf", "png"};

/// A folder has the name of a figure that is to be written. what(): a sentence.
class FigureInTheWay : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Draws the figures of the page into a folder, which is made if there is none and there are
/// figures, each as a file of each of the formats. Files of the same names are replaced; an error
/// or an interruption leaves the folder as it was. Returns the number of figures. `cells`: as for
/// html_report(). Throws FigureInTheWay, another std::runtime_error when a file or the folder
/// cannot be written, and as ResultsFile does.
std::size_t write_figures(const Findings& findings, const ResultsFile& file, const Answers& answers,
                          const std::filesystem::path& folder,
                          const std::vector<std::string>& formats, const std::string& cells = "");

}  // namespace elsie::report
