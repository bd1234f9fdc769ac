#include "watch/graph_panel.h"

#include <QPaintEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "elsie/picture/graph_picture.h"
#include "elsie/recording/graph_json.h"

#include "paint/chart.h"
#include "paint/figures.h"
#include "watch/state.h"

namespace elsie::desktop {
namespace {

constexpr double kLeast = 0.6;  // of the size in which texts have the window's

QString words_of(NodeState state) {
  switch (state) {
    case NodeState::running:
      return GraphPanel::tr("running");
    case NodeState::success:
      return GraphPanel::tr("success");
    case NodeState::failure:
      return GraphPanel::tr("failure");
    case NodeState::dark:
      break;
  }
  return {};
}

}  // namespace

/// The drawing.
class GraphPanel::Page : public QWidget, public ShowsFigures {
 public:
  void forget() {
    is_known_ = false;
    graphs_.clear();
    lights_.clear();
    layout_.reset();
    problem_.clear();
    update();
  }

  /// Returns whether there are other graphs than before.
  bool take(const Json& listed) {
    std::vector<picture::NamedGraph> graphs;
    picture::GraphLights lights;
    try {
      for (const Json& each : listed) {
        graphs.push_back({text_of(each, "path").toStdString(), recording::graph_of(each)});
        lights.push_back(recording::lights_of(each, graphs.back().graph.nodes.size()));
      }
    } catch (const std::exception& error) {
      forget();
      problem_ = QString::fromUtf8(error.what());
      return true;
    }
    const bool are_new = !is_known_ || graphs != graphs_;
    if (!are_new && lights == lights_) return false;
    is_known_ = true;
    graphs_ = std::move(graphs);
    lights_ = std::move(lights);
    if (are_new) lay_out();
    update();
    return are_new;
  }

  /// Gives the page the room that the graphs need beyond that which there is.
  void fit(const QSize& room) {
    const double natural = fontMetrics().height() / kTextLine;
    zoom_ = natural;
    QSize needed;
    if (layout_) {
      zoom_ = std::min({natural, room.width() / layout_->width, room.height() / layout_->height});
      zoom_ = std::max(zoom_, kLeast * natural);
      needed = QSize(static_cast<int>(std::ceil(zoom_ * layout_->width)),
                     static_cast<int>(std::ceil(zoom_ * layout_->height)));
    }
    setMinimumSize(needed.width() > room.width() ? needed.width() : 0,
                   needed.height() > room.height() ? needed.height() : 0);
    update();
  }

  QString number_of_node(std::size_t graph, std::size_t node) const {
    return robot + u'/' + QString::fromStdString(graphs_[graph].path) +
           QStringLiteral("/nodes/%1").arg(node);
  }

  /// Calls `see` for each node, with its graph and its state at the shown time.
  template <class See>
  void visit(const See& see) const {
    for (std::size_t g = 0; g < graphs_.size(); ++g) {
      for (std::size_t i = 0; i < graphs_[g].graph.nodes.size(); ++i) see(g, i, state(g, i));
    }
  }

  const std::string& label(std::size_t graph, std::size_t node) const {
    return graphs_[graph].graph.nodes[node].label;
  }

  QString notice() const {
    if (robot.isEmpty()) {
      return tr("Select a robot to see the states or the tree of its coordinator");
    }
    if (!problem_.isEmpty()) return problem_;
    if (!is_known_) {
      return tr("Nothing from %1 yet: this panel is updated only while it is visible").arg(robot);
    }
    return layout_ ? QString()
                   : tr("The coordinator of %1 shows no graph; arbiter_states and arbiter_tree do")
                         .arg(robot);
  }

  Figures figures() const override {
    Figures figures{{tr("coordinator"), tr("node"), tr("state")}, {}};
    visit([&](std::size_t g, std::size_t i, NodeState state) {
      figures.rows.push_back({QString::fromStdString(graphs_[g].path),
                              QString::fromStdString(label(g, i)), words_of(state)});
    });
    return figures;
  }

  QString robot;
  const Samples* samples = nullptr;
  std::optional<double> looked_back_to_s;

 protected:
  void paintEvent(QPaintEvent* event) override {
    QPainter painter(this);
    if (const QString words = notice(); !words.isEmpty()) {
      painter.setPen(palette().color(QPalette::PlaceholderText));
      painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, words);
      return;
    }
    picture::GraphLights lights = lights_;
    visit([&](std::size_t g, std::size_t i, NodeState state) { lights[g][i] = state; });
    const QPointF middle = QRectF(rect()).center();
    const QPointF corner = middle - 0.5 * zoom_ * QPointF(layout_->width, layout_->height);
    const QRect part = event->rect();
    const QPointF from = (part.topLeft() - corner) / zoom_;
    draw_pixels(painter, part, [&](const QSize& size, double ratio) {
      return picture::screen_graphs(*layout_, lights, {from.x(), from.y()}, size.width(),
                                    size.height(), ratio * zoom_, style_of(palette()));
    });
  }

 private:
  NodeState state(std::size_t graph, std::size_t node) const {
    if (!looked_back_to_s) return lights_[graph][node];
    const float then = samples ? samples->at(number_of_node(graph, node), *looked_back_to_s) : 0.0F;
    const bool is_one = then >= 1.0F && then <= 3.0F;  // NaN: nothing was decided yet
    return is_one ? static_cast<NodeState>(static_cast<int>(then)) : NodeState::dark;
  }

  void lay_out() {
    layout_.reset();
    problem_.clear();
    std::size_t count = 0;
    for (const picture::NamedGraph& each : graphs_) count += each.graph.nodes.size();
    if (count == 0) return;
    if (count > picture::kMostGraphNodes) {
      problem_ = tr("%1 nodes are too many to be drawn; of a recording, elsie explain lists them")
                     .arg(count);
      return;
    }
    try {
      layout_ = picture::lay_out(graphs_);
    } catch (const std::exception& error) {
      problem_ = QString::fromUtf8(error.what());
    }
  }

  bool is_known_ = false;  // a state has said what there is
  std::vector<picture::NamedGraph> graphs_;
  picture::GraphLights lights_;  // of the present
  std::optional<picture::GraphLayout> layout_;
  QString problem_;
  double zoom_ = 1.0;  // pixels of the window for a unit of the layout
};

GraphPanel::GraphPanel(QWidget* parent) : QScrollArea(parent), page_(new Page) {
  setObjectName(QStringLiteral("graph"));
  page_->setObjectName(QStringLiteral("graph_page"));
  page_->setAccessibleName(tr("States or tree of the coordinators"));
  page_->setBackgroundRole(QPalette::Base);
  offer_figures(page_);
  setWidgetResizable(true);
  setWidget(page_);
}

GraphPanel::~GraphPanel() = default;

void GraphPanel::set_robot(const QString& id) {
  if (id == page_->robot) return;
  page_->robot = id;
  page_->forget();
  page_->fit(maximumViewportSize());
}

void GraphPanel::clear() {
  page_->looked_back_to_s.reset();
  page_->forget();
  page_->fit(maximumViewportSize());
}

void GraphPanel::set_samples(const Samples& samples) {
  page_->samples = &samples;
  if (page_->looked_back_to_s) page_->update();
}

void GraphPanel::look_back(std::optional<double> time_s) {
  if (page_->looked_back_to_s != time_s) {
    page_->looked_back_to_s = time_s;
    page_->update();
  }
}

void GraphPanel::add(const Json& state) {
  const Json& robot = robot_of(state, page_->robot);
  if (!robot.contains("graphs")) return;
  if (page_->take(robot["graphs"])) page_->fit(maximumViewportSize());
}

QStringList GraphPanel::numbers() const {
  QStringList names;
  page_->visit(
      [&](std::size_t g, std::size_t i, NodeState) { names << page_->number_of_node(g, i); });
  return names;
}

QStringList GraphPanel::running() const {
  QStringList labels;
  page_->visit([&](std::size_t g, std::size_t i, NodeState state) {
    if (state == NodeState::running) labels << QString::fromStdString(page_->label(g, i));
  });
  return labels;
}

QString GraphPanel::notice() const { return page_->notice(); }

void GraphPanel::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  page_->fit(maximumViewportSize());
}

}  // namespace elsie::desktop
