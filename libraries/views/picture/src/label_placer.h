// Finds places for labels next to marks that cover as little as possible.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "canvas.h"

namespace elsie::picture {

class LabelPlacer {
 public:
  explicit LabelPlacer(const Rect& frame);

  /// An area that labels should avoid; the larger the weight, the more.
  void avoid(const Rect& rect, double weight);
  /// A point of a line, which a label may cover if necessary.
  void avoid_spot(const Vector2& spot);

  struct Place {
    Rect rect;
    bool apart = false;  // so far away that a line should connect it with its mark
  };
  /// The best place for a label of this size next to a mark of this radius; it is then occupied.
  /// None when every place would cover another label: the label is left out, and counted.
  std::optional<Place> place(const Vector2& mark, double radius, double width, double height);
  /// Counts labels that are not even tried.
  void leave_out(std::size_t count) { left_out_ += count; }
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
  std::vector<int> spots_;  // counts per cell of kCell units
};

}  // namespace elsie::picture
