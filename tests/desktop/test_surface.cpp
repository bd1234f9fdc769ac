// Fuzzy models over the plane of two inputs.
#include <QApplication>
#include <QComboBox>
#include <QTest>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/fuzzy/fcl.h"

#include "model_file.h"
#include "waiting.h"
#include "watch/control_surface.h"
#include "watch/fuzzy_instant.h"

using namespace elsie::desktop;

namespace {

constexpr const char* kTwoInputs = R"(FUNCTION_BLOCK m
VAR_INPUT range : REAL; angle : REAL; END_VAR
VAR_OUTPUT speed : REAL; END_VAR
FUZZIFY range RANGE := (0 .. 1); TERM near := (0, 1) (1, 0); TERM far := (0, 0) (1, 1); END_FUZZIFY
FUZZIFY angle RANGE := (0 .. 100); TERM ahead := (0, 1) (100, 0); TERM aside := (0, 0) (100, 1);
END_FUZZIFY
DEFUZZIFY speed RANGE := (0 .. 1); TERM slow := (0, 1) (1, 0); TERM fast := (0, 0) (1, 1);
METHOD : COG; DEFAULT := 0; END_DEFUZZIFY
RULEBLOCK r
RULE 1 : IF range IS near AND angle IS ahead THEN speed IS slow;
RULE 2 : IF range IS far OR angle IS aside THEN speed IS fast;
END_RULEBLOCK
END_FUNCTION_BLOCK
)";

}  // namespace

TEST_CASE("fuzzy: a control surface over two inputs, the others held") {
  const auto model = elsie::fuzzy::read_fcl(ModelFile(kTwoInputs).name());
  const FuzzyGrid grid = fuzzy_grid(model, 0, 0, 1, {0.0, 0.0});
  REQUIRE(grid.rows == FuzzyGrid::kAcross);
  REQUIRE(grid.values.size() == FuzzyGrid::kAcross * FuzzyGrid::kAcross);
  std::vector<double> out(1);
  elsie::fuzzy::Workspace workspace;
  model.evaluate(std::vector<double>{0.25, 75.0}, out, workspace);
  CHECK(grid.values[30 * FuzzyGrid::kAcross + 10] == out[0]);

  ControlSurface surface;
  surface.set_model(&model);
  surface.resize(500, 400);
  surface.set_inputs({0.25, 75.0});
  auto* across = surface.findChild<QComboBox*>(QStringLiteral("surface_across"));
  auto* up = surface.findChild<QComboBox*>(QStringLiteral("surface_up"));
  CHECK(across->currentText() == QStringLiteral("range"));
  CHECK(up->currentText() == QStringLiteral("angle"));
  up->setFocus();
  QTest::keyClick(up, Qt::Key_Up);  // to the one that lies across, which gives way
  CHECK(up->currentText() == QStringLiteral("range"));
  CHECK(across->currentText() == QStringLiteral("angle"));
  CHECK(surface.grid().values[10 * FuzzyGrid::kAcross + 30] == out[0]);
}

TEST_CASE("fuzzy: the mark of a surface moves at once; the grid waits for other held inputs") {
  class Paints : public QObject {
   public:
    int count = 0;
    bool eventFilter(QObject*, QEvent* event) override {
      count += event->type() == QEvent::Paint ? 1 : 0;
      return false;
    }
  };
  QString text(kTwoInputs);
  text.replace("angle : REAL;", "angle : REAL; load : REAL;")
      .replace("DEFUZZIFY speed",
               "FUZZIFY load RANGE := (0 .. 1); TERM full := (0, 0) (1, 1); "
               "END_FUZZIFY\nDEFUZZIFY speed")
      .replace("range IS far OR", "range IS far OR load IS full OR");
  const auto model = elsie::fuzzy::read_fcl(ModelFile(text.toLatin1().constData()).name());
  ControlSurface surface;
  surface.set_model(&model);
  surface.show();
  surface.set_inputs({0.1, 10.0, 0.5});  // held in the middle, as computed
  REQUIRE(wait_for([&] { return QTest::qWaitForWindowExposed(&surface); }));
  QTest::qWait(0);
  const double* const grid = surface.grid().values.data();
  Paints paints;
  surface.installEventFilter(&paints);
  surface.set_inputs({0.9, 90.0, 0.5});
  QApplication::processEvents();
  CHECK(paints.count == 1);
  QTest::qWait(300);  // longer than between two grids
  CHECK(surface.grid().values.data() == grid);
  surface.set_inputs({0.9, 90.0, 0.25});
  CHECK(wait_for([&] { return surface.grid().values.data() != grid; }));
}

TEST_CASE("fuzzy: a formula without a value is said, not thrown") {
  const auto model = elsie::fuzzy::read_fcl(ModelFile(kTwoInputs).name());
  const FuzzyInstant now = fuzzy_instant(model, {std::numeric_limits<double>::infinity(), 0.0});
  CHECK_FALSE(now.problem.isEmpty());
  CHECK(now.degrees.empty());
}
