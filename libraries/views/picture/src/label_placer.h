// Finds room for labels beside marks, without covering more than needed.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "canvas.h"

namespace elsie::picture {

class LabelPlacer {
 public:
  explicit LabelPlacer(const Rect& frame);

  /// What labels should keep off; the larger the weight, the more.
  void avoid(const Rect& rect, double weight);
  /// A spot of a line, which a label may cover if need be.
  void avoid_spot(const Vector2& spot);

  struct Place {
    Rect rect;
    bool apart = false;  // so far off that a line should lead to its mark
  };
  /// The best place for a label of this size beside a mark of this radius. The place is taken
  /// afterwards.
  /// None when every place is on another label: then the label is left out, and counted.
  std::optional<Place> place(const Vector2& mark, double radius, double width, double height);
  std::size_t left_out() const { return left_out_; }

 private:
  double cost(const Rect& rect, const Vector2& mark) const;

  struct Obstacle {
    Rect rect;
    double weight;
  };
  Rect frame_;
  std::vector<Obstacle> obstacles_;
  std::vector<Rect> labels_;
  struct Leader {
    Vector2 from, to;
  };
  std::vector<Leader> leaders_;
  std::size_t left_out_ = 0;
  std::size_t columns_, rows_;
  std::vector<int> spots_;  // counts over cells of kCell units
};

}  // namespace elsie::picture
