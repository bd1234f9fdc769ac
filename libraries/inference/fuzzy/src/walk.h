// Computes the accumulated set of an output, line by line, from the degrees of its slots.
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "model_data.h"
#include "workspace.h"

namespace elsie::fuzzy {

/// Walks through the cells of an output and passes the accumulated set to a sink, line by line.
///
/// Within a cell every term is a straight line, and a cut divides it into two. Between the ends of
/// all cuts each conclusion is one straight line, and the accumulation of these consists of few:
/// the highest line at each x, or a sum.
template <class Sink>
class Walk {
 public:
  Walk(const ModelData& model, std::size_t output, Workspace::Memory& memory, Sink& sink)
      : slots_(model.slots.data()),
        output_(model.compiled_outputs[output]),
        accumulation_(model.outputs[output].accumulation),
        memory_(memory),
        sink_(sink) {}

  void run() {
    for (const Cell& cell : output_.cells) {
      gather(cell);
      if (memory_.active.size() == 1) {
        single(cell, memory_.active.front());
      } else if (!memory_.active.empty()) {
        several(cell);
      }
    }
  }

 private:
  void gather(const Cell& cell) {
    memory_.active.clear();
    for (std::size_t i = cell.first_line; i < cell.end_line; ++i) {
      const Line& line = output_.lines[i];
      for (std::size_t s = line.first_slot; s < line.end_slot; ++s) {
        const double degree = memory_.slots[s];
        if (degree <= 0.0) {
          continue;
        }
        if (slots_[s].scales) {
          memory_.active.push_back({line.y0 * degree, line.y1 * degree, kNoCut});
        } else {
          Active active{line.y0, line.y1, degree};
          const double t = split(active);
          if (t >= 1.0 && active.y1 < degree) {
            active.y1 = degree;  // only rounding keeps this end from being cut off, too
          } else if (t == 0.0 && active.y0 < degree) {
            active.y0 = degree;
          }
          memory_.active.push_back(active);
        }
      }
    }
  }

  /// The begin or end of the conclusion's cut, as a fraction of the cell; outside of (0, 1) if it
  /// is not in the cell.
  static double split(const Active& active) {
    return (active.y0 < active.cut) != (active.y1 < active.cut)
               ? (active.cut - active.y0) / (active.y1 - active.y0)
               : -1.0;
  }

  void single(const Cell& cell, const Active& active) {
    const double t = split(active);
    const double y0 = std::min(active.y0, active.cut);
    const double y1 = std::min(active.y1, active.cut);
    if (t > 0.0 && t < 1.0) {
      const double x = cell.x0 + t * (cell.x1 - cell.x0);
      line(cell.x0, x, y0, active.cut);
      line(x, cell.x1, active.cut, y1);
    } else {
      line(cell.x0, cell.x1, y0, y1);
    }
  }

  /// Accumulates several conclusions in one cell.
  void several(const Cell& cell) {
    auto& splits = memory_.splits;
    splits.clear();
    for (const Active& active : memory_.active) {
      const double t = split(active);
      if (t > 0.0 && t < 1.0) {
        splits.push_back(t);
      }
    }
    std::sort(splits.begin(), splits.end());
    splits.push_back(1.0);
    double t0 = 0.0;
    double x0 = cell.x0;
    for (const double t1 : splits) {
      const double x1 = t1 == 1.0 ? cell.x1 : cell.x0 + t1 * (cell.x1 - cell.x0);
      if (x0 < x1) {
        memory_.edges.clear();
        for (const Active& active : memory_.active) {
          const double rise = active.y1 - active.y0;
          memory_.edges.push_back(
              {std::min(active.cut, t0 == 0.0 ? active.y0 : active.y0 + t0 * rise),
               std::min(active.cut, t1 == 1.0 ? active.y1 : active.y0 + t1 * rise)});
        }
        stretch(x0, x1);
      }
      t0 = t1;
      x0 = x1;
    }
  }

  /// Accumulates straight edges from x0 to x1.
  void stretch(double x0, double x1) {
    switch (accumulation_) {
      case Accumulation::max:
        highest(x0, x1);
        break;
      case Accumulation::bounded_sum:
      case Accumulation::normalized_sum: {
        Edge sum;
        for (const Edge& edge : memory_.edges) {
          sum.y0 += edge.y0;
          sum.y1 += edge.y1;
        }
        line(x0, x1, sum.y0, sum.y1);
        break;
      }
      case Accumulation::algebraic_sum:
        sink_.polynomial(x0, x1, std::span<const Edge>(memory_.edges));
        break;
    }
  }

  /// Follows the highest line from crossing to crossing.
  void highest(double x0, double x1) {
    auto& edges = memory_.edges;
    Edge now = edges.front();
    for (const Edge& edge : edges) {
      if (edge.y0 > now.y0 || (edge.y0 == now.y0 && edge.y1 > now.y1)) {
        now = edge;
      }
    }
    double t = 0.0;
    double x = x0;
    double y = now.y0;
    while (true) {
      const Edge* next = nullptr;
      double next_t = 1.0;
      for (const Edge& edge : edges) {
        if (edge.y1 > now.y1) {  // steeper: it crosses somewhere before x1
          const double below = now.y0 - edge.y0;
          const double crossing = below / (below + (edge.y1 - now.y1));
          if (crossing < next_t || (crossing == next_t && next && edge.y1 > next->y1)) {
            next_t = crossing;
            next = &edge;
          }
        }
      }
      if (!next) {
        break;
      }
      t = std::max(t, next_t);
      const double crossing_x = x0 + t * (x1 - x0);
      const double crossing_y = now.y0 + t * (now.y1 - now.y0);
      if (crossing_x > x && crossing_x < x1) {
        sink_.line(x, crossing_x, y, crossing_y);
        x = crossing_x;
        y = crossing_y;
      }
      now = *next;
    }
    sink_.line(x, x1, y, now.y1);
  }

  /// Passes a line of the result; the bounded sum cuts it off at 1.
  void line(double x0, double x1, double y0, double y1) {
    if (accumulation_ != Accumulation::bounded_sum || (y0 <= 1.0 && y1 <= 1.0)) {
      sink_.line(x0, x1, y0, y1);
      return;
    }
    const double t = (1.0 - y0) / (y1 - y0);
    const double x = x0 + t * (x1 - x0);
    if ((y0 < 1.0 || y1 < 1.0) && x > x0 && x < x1) {
      sink_.line(x0, x, std::min(y0, 1.0), 1.0);
      sink_.line(x, x1, 1.0, std::min(y1, 1.0));
    } else {
      sink_.line(x0, x1, std::min(y0, 1.0), std::min(y1, 1.0));
    }
  }

  static constexpr double kNoCut = std::numeric_limits<double>::infinity();
  const Slot* slots_;
  const CompiledOutput& output_;
  Accumulation accumulation_;
  Workspace::Memory& memory_;
  Sink& sink_;
};

template <class Sink>
void walk(const ModelData& model, std::size_t output, Workspace::Memory& memory, Sink& sink) {
  Walk<Sink>(model, output, memory, sink).run();
}

}  // namespace elsie::fuzzy
