#include "coverage.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "text.h"

namespace elsie::fuzzy {

namespace {

/// Bounds of a degree over a box of inputs.
struct Bounds {
  double low = 0.0;
  double high = 0.0;
  bool positive = false;  // above zero in the whole interior of the box

  bool zero() const { return high <= 0.0; }
};

/// A piece of an input's axis: a single x, or the open interval between two neighbouring points of
/// its terms. All terms are straight lines there, so each is zero everywhere or nowhere in it.
struct Piece {
  double x0 = 0.0;
  double x1 = 0.0;
  bool splits = false;         // an interval, not a point or a flat end
  std::vector<double> y0;      // of each leaf of the input, at x0
  std::vector<double> y1;      // at x1
  std::vector<char> positive;  // whether each leaf is above zero inside
};

/// The part of an input that is examined now: of a piece, or the whole axis.
struct View {
  const Piece* piece = nullptr;
  double from = 0.0;  // fractions of the piece
  double to = 1.0;
};

class Search {
 public:
  Search(const ModelData& model, std::size_t output) : model_(model), bounds_(model.leaves.size()) {
    for (const CompiledRule& rule : model.compiled_rules) {
      const bool concludes =
          std::any_of(rule.targets.begin(), rule.targets.end(),
                      [output](const Target& target) { return target.output == output; });
      if (concludes && rule.weight > 0.0) {
        rules_.push_back(&rule);
      }
    }
    collect_leaves();
    for (std::size_t i = 0; i < model.inputs.size(); ++i) {
      pieces_.push_back(cut(i));
    }
    views_.resize(model.inputs.size());
    for (std::size_t i = 0; i < model.inputs.size(); ++i) {
      look_at_all(i);
    }
  }

  std::optional<Gap> run() {
    if (!search(0)) {
      return std::nullopt;
    }
    return Gap{certain_, example()};
  }

 private:
  void collect_leaves() {
    leaves_of_.resize(model_.inputs.size());
    std::set<std::size_t> used;
    for (const CompiledRule* rule : rules_) {
      for (const Instruction& instruction : rule->condition) {
        if (instruction.op == Operator::leaf) {
          used.insert(instruction.argument);
        } else if (instruction.op == Operator::bounded_difference) {
          degrees_matter_ = true;
        }
      }
    }
    for (const std::size_t leaf : used) {
      leaves_of_[model_.leaves[leaf].input].push_back(leaf);
    }
  }

  /// Divides an input's axis into pieces, without those that equal an earlier one.
  std::vector<Piece> cut(std::size_t input) {
    const Variable& variable = model_.inputs[input];
    const std::vector<std::size_t>& leaves = leaves_of_[input];
    std::set<double> places;
    for (const std::size_t leaf : leaves) {
      for (const Leaf::Knot& knot : model_.leaves[leaf].knots) {
        if (!variable.range_given ||
            (knot.x > variable.range.low && knot.x < variable.range.high)) {
          places.insert(knot.x);
        }
      }
    }
    places.insert({variable.range.low, variable.range.high});
    std::vector<Piece> pieces;
    std::set<std::vector<char>> seen;
    const auto add = [&](double x0, double x1, bool flat) {
      Piece piece{x0, x1, x0 < x1 && !flat, {}, {}, {}};
      for (const std::size_t index : leaves) {
        const Leaf& leaf = model_.leaves[index];
        const bool point = x0 == x1;
        piece.y0.push_back(point ? leaf.degree(x0) : leaf.after(x0));
        piece.y1.push_back(point ? leaf.degree(x1) : leaf.before(x1));
        piece.positive.push_back(piece.y0.back() > 0.0 || piece.y1.back() > 0.0);
      }
      if (degrees_matter_ || seen.insert(piece.positive).second) {
        pieces.push_back(std::move(piece));
      }
    };
    if (!variable.range_given) {
      add(*places.begin() - 1.0, *places.begin(), true);
      add(*places.rbegin(), *places.rbegin() + 1.0, true);
    }
    for (auto place = places.begin(); place != places.end(); ++place) {
      add(*place, *place, true);
      if (std::next(place) != places.end()) {
        add(*place, *std::next(place), false);
      }
    }
    return pieces;
  }

  void look_at_all(std::size_t input) {
    views_[input] = {};
    for (std::size_t i = 0; i < leaves_of_[input].size(); ++i) {
      Bounds all{1.0, 0.0, true};
      for (const Piece& piece : pieces_[input]) {
        all.low = std::min({all.low, piece.y0[i], piece.y1[i]});
        all.high = std::max({all.high, piece.y0[i], piece.y1[i]});
        all.positive = all.positive && piece.positive[i];
      }
      bounds_[leaves_of_[input][i]] = all;
    }
  }

  void look_at(std::size_t input, const View& view) {
    views_[input] = view;
    const Piece& piece = *view.piece;
    for (std::size_t i = 0; i < leaves_of_[input].size(); ++i) {
      const double rise = piece.y1[i] - piece.y0[i];
      const double a = piece.y0[i] + view.from * rise;
      const double b = piece.y0[i] + view.to * rise;
      bounds_[leaves_of_[input][i]] = {std::min(a, b), std::max(a, b), piece.positive[i] != 0};
    }
  }

  Bounds bounds(const CompiledRule& rule) {
    stack_.clear();
    for (const Instruction& instruction : rule.condition) {
      if (instruction.op == Operator::leaf) {
        stack_.push_back(bounds_[instruction.argument]);
        continue;
      }
      const bool needs_all = instruction.op == Operator::min || instruction.op == Operator::product;
      Bounds result = stack_[stack_.size() - instruction.argument];
      for (std::size_t i = instruction.argument - 1; i > 0; --i) {
        const Bounds& operand = stack_[stack_.size() - i];
        result.low = combine(instruction.op, result.low, operand.low);
        result.high = combine(instruction.op, result.high, operand.high);
        result.positive =
            needs_all ? result.positive && operand.positive : result.positive || operand.positive;
        if (instruction.op == Operator::bounded_difference) {
          result.positive = result.low > 0.0;
        }
      }
      stack_.resize(stack_.size() - instruction.argument);
      stack_.push_back(result);
    }
    return stack_.front();
  }

  enum class Finding { covered, gap, open };

  Finding look() {
    bool all_zero = true;
    for (const CompiledRule* rule : rules_) {
      const Bounds found = bounds(*rule);
      if (found.positive) {
        return Finding::covered;
      }
      all_zero = all_zero && found.zero();
    }
    effort_ += rules_.size();
    return all_zero ? Finding::gap : Finding::open;
  }

  bool give_up() {
    certain_ = certain_ && effort_ < kMostEffort;
    return !certain_;
  }

  /// Examines the pieces of the inputs from this one on; returns whether there is a gap.
  bool search(std::size_t input) {
    const Finding finding = look();
    if (finding != Finding::open || give_up()) {
      return finding != Finding::covered;
    }
    if (input == views_.size()) {
      return divide(0);
    }
    for (const Piece& piece : pieces_[input]) {
      look_at(input, {&piece, 0.0, 1.0});
      if (search(input + 1)) {
        return true;
      }
    }
    look_at_all(input);
    return false;
  }

  /// With the bounded difference, the degrees themselves decide whether a rule fires: halves the
  /// box until each part is decided.
  bool divide(int depth) {
    const Finding finding = look();
    if (finding != Finding::open) {
      return finding == Finding::gap;
    }
    const std::vector<View> box = views_;
    for (std::size_t i = 0; i < box.size(); ++i) {
      const double middle = 0.5 * (box[i].from + box[i].to);
      look_at(i, {box[i].piece, middle, middle});
    }
    if (look() == Finding::gap) {
      return true;
    }
    std::size_t widest = box.size();
    double width = 0.0;
    for (std::size_t i = 0; i < box.size(); ++i) {
      look_at(i, box[i]);
      if (box[i].piece->splits && !leaves_of_[i].empty() && box[i].to - box[i].from > width) {
        widest = i;
        width = box[i].to - box[i].from;
      }
    }
    if (give_up() || depth >= kDeepest || widest == box.size()) {
      certain_ = false;
      return true;
    }
    const View& view = box[widest];
    const double middle = 0.5 * (view.from + view.to);
    for (const View& half :
         {View{view.piece, view.from, middle}, View{view.piece, middle, view.to}}) {
      look_at(widest, half);
      if (divide(depth + 1)) {
        return true;
      }
    }
    look_at(widest, view);
    return false;
  }

  std::string example() const {
    std::string text;
    for (std::size_t i = 0; i < views_.size(); ++i) {
      if (leaves_of_[i].empty()) {
        continue;  // does not matter
      }
      const View view = views_[i].piece ? views_[i] : View{&pieces_[i].front(), 0.0, 1.0};
      const double t = 0.5 * (view.from + view.to);
      const double x = view.piece->x0 + t * (view.piece->x1 - view.piece->x0);
      text += (text.empty() ? "" : ", ") + model_.inputs[i].name + " = " + number_text(x);
    }
    return text.empty() ? "any input" : text;
  }

  static constexpr std::size_t kMostEffort = 10'000'000;  // conditions examined: about a second
  static constexpr int kDeepest = 40;

  const ModelData& model_;
  std::vector<const CompiledRule*> rules_;           // that decide the output
  std::vector<std::vector<std::size_t>> leaves_of_;  // by input: those that the rules use
  std::vector<std::vector<Piece>> pieces_;           // by input
  std::vector<View> views_;                          // by input
  std::vector<Bounds> bounds_;                       // by leaf, for the views
  std::vector<Bounds> stack_;
  bool degrees_matter_ = false;
  bool certain_ = true;
  std::size_t effort_ = 0;
};

}  // namespace

std::optional<Gap> find_gap(const ModelData& model, std::size_t output) {
  return Search(model, output).run();
}

}  // namespace elsie::fuzzy
