// Pictures of fuzzy models: membership functions and control surfaces.
//
// The model is passed as plain data and a function, so that any source of fuzzy sets can be drawn.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elsie/base/fuzzy_set.h"
#include "elsie/picture/plot.h"
#include "elsie/picture/size.h"

namespace elsie::picture {

/// A variable with its terms by name.
struct MembershipPanel {
  std::string variable{};
  std::string unit{};
  double low = 0.0;
  double high = 1.0;
  std::vector<std::pair<std::string, FuzzySet>> terms{};
};

/// A variable with its range.
struct SurfaceVariable {
  std::string name{};
  std::string unit{};
  double low = 0.0;
  double high = 1.0;
};

/// An input that is not drawn, and its constant value.
struct HeldInput {
  std::string name{};
  std::string unit{};
  double value = 0.0;
};

/// One output over one or two inputs.
struct ControlSurface {
  SurfaceVariable x{};
  std::optional<SurfaceVariable> y{};  // none: the output is drawn as a curve over x
  SurfaceVariable output{};
  std::vector<HeldInput> held{};  // named in the title
  /// The output at (x, y); y is 0 when there is no second input. NaN where it is undefined.
  std::function<double(double x, double y)> value;
};

/// A whole model on one page: the variables, then each surface as a heat map and a mesh.
struct FuzzyPicture {
  std::string title{};
  std::vector<std::string> subtitles{};
  std::vector<MembershipPanel> variables{};
  std::vector<ControlSurface> surfaces{};
};

/// The page of the picture, for use with other pages and panels. Evaluates the surfaces. Throws
/// std::invalid_argument when a variable's low is not below its high.
Page fuzzy_page(const FuzzyPicture& picture);

/// Writes one file; errors as in save_page().
void save_fuzzy_picture(const FuzzyPicture& picture, const std::filesystem::path& file,
                        const Size& size = {});

}  // namespace elsie::picture
