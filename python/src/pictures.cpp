// Binds pictures of worlds and runs, and charts.
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "elsie/base/error.h"
#include "elsie/picture/plot.h"
#include "elsie/picture/top_view.h"
#include "elsie/recording/run_picture.h"
#include "elsie/recording/sensor_pictures.h"

#include "image_array.h"
#include "simulation.h"

namespace elsie::python {
namespace {

/// Plugins that fail to draw are left out.
picture::TopView view_of(Simulation& self) {
  return recording::view_of(self.now(), self.tracks(), [](const std::string& sentence) {
    if (PyErr_WarnEx(PyExc_RuntimeWarning, sentence.c_str(), 1) != 0) {
      throw py::error_already_set();
    }
  });
}

picture::TopView titled(picture::TopView view, const std::vector<std::string>& subtitles,
                        bool bare) {
  view.subtitles = subtitles;
  view.bare = bare;
  return view;
}

void save(const picture::TopView& view, const std::string& file, int width) {
  picture::save_top_view(view, file, {width, 0});
}

/// A copy of the last picture of a sensor.
py::array image_of(Simulation& self, std::size_t robot, const std::string& sensor,
                   const std::string& name) {
  const simulation::Simulation& now = self.now();
  if (robot >= now.robots()) {
    throw base::BadInput("there is no robot " + std::to_string(robot) + "; there are " +
                         std::to_string(now.robots()));
  }
  for (std::size_t i = 0; i < now.sensors(robot); ++i) {
    if (now.sensor(robot, i).id != sensor) continue;
    py::object found = py::none();
    recording::visit_pictures(now, robot, i, [&](std::string_view each, const Image& image) {
      if (each == name) found = array_of(image);
    });
    if (!found.is_none()) return found;
    throw base::BadInput("the sensor '" + sensor + "' has no picture '" + name +
                         "' now; pictures are taken in the first step");
  }
  throw base::BadInput("the robot '" + now.robot(robot).description->id + "' has no sensor '" +
                       sensor + "'");
}

/// Curves of as many points as `x` has, by their names.
void save_chart(const std::string& file, const std::vector<double>& x,
                const std::vector<std::pair<std::string, std::vector<double>>>& curves,
                const std::vector<std::string>& labels) {
  picture::LineChart chart;
  chart.x.label = labels[0];
  chart.y.label = labels[1];
  for (const auto& [name, y] : curves) {
    picture::Series& series = chart.series.emplace_back();
    series.name = name;
    for (std::size_t i = 0; i < x.size(); ++i) series.points.push_back({x[i], y[i]});
  }
  picture::Page page;
  page.title = labels[2];
  page.rows.emplace_back().panels.emplace_back(std::move(chart));
  page.rows.back().aspect = 0.5;
  picture::save_page(page, file);
}

}  // namespace

void bind_pictures(py::module_& module) {
  module.def("svg_of_world", [](const World& world, int width) {
    return picture::top_view_svg({world.description()}, {width, 0});
  });
  module.def("save_world", [](const World& world, const std::string& file, int width) {
    save({world.description()}, file, width);
  });
  module.def("svg_of_run",
             [](Simulation& self, const std::vector<std::string>& subtitles, int width) {
               return picture::top_view_svg(titled(view_of(self), subtitles, false), {width, 0});
             });
  module.def("save_run", [](Simulation& self, const std::string& file,
                            const std::vector<std::string>& subtitles, int width) {
    save(titled(view_of(self), subtitles, false), file, width);
  });
  module.def("render_run", [](Simulation& self, int width, int height, bool bare) {
    return array_of(picture::top_view_image(titled(view_of(self), {}, bare), {width, height}));
  });
  module.def("image_of", &image_of);
  module.def("save_chart", &save_chart);
}

}  // namespace elsie::python
