"""Plugins that fail: named in the exception; what was seen and recorded until then is kept."""
import pytest

import elsie
from worlds import ARENA

TIRED = """#include <stdexcept>
#include <elsie/api/behavior.h>
class Tired final : public elsie::Behavior {
 public:
  double after = 1.0;
  elsie::Response respond(const elsie::Perception& now) override {
    if (now.time_s() > after) throw std::runtime_error("so tired");
    return now.self().wheels.motion({5, 5});
  }
};
ELSIE_BEHAVIOR(Tired, "tired", "Drives on for a while",
               elsie::parameter("after", &Tired::after, {.unit = "s", .min = 0, .meaning = "when it tires"}));
"""


@pytest.fixture(scope="module")
def plugin(tmp_path_factory):
    folder = tmp_path_factory.mktemp("plugin")
    (folder / "tired.cpp").write_text(TIRED)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("ELSIE_CACHE", str(folder / "cache"))
        yield folder / "tired.cpp"


@pytest.fixture
def tired(plugin):
    return elsie.World.parse(ARENA.replace("<behaviors><wander/></behaviors>", "<behaviors><tired/></behaviors>"), plugins=[plugin])


def test_a_fault_names_plugin_robot_and_step(tired, tmp_path):
    run = elsie.Simulation(tired)
    run.record(tmp_path / "run.csv")
    with pytest.raises(elsie.PluginFault, match="so tired") as caught:
        run.run()
    fault = caught.value
    assert (fault.plugin, fault.id, fault.robot, fault.exit_code) == ("tired", "tired", "r2", 3)
    assert fault.step == pytest.approx(1 / run.step_s, abs=3)
    assert (tmp_path / "run.csv").read_text().count("\n") > 10


def test_steps_after_a_fault_raise_it_again(tired):
    run = elsie.Simulation(tired)
    for _ in range(3):
        with pytest.raises(elsie.PluginFault, match="so tired"):
            run.step(1000)
    run.close()


def test_what_was_seen_until_then_stays(tired):
    with pytest.raises(elsie.PluginFault), elsie.Simulation(tired) as run:
        run.run()
    result = run.result()
    assert result.outcome == "fault" and "so tired" in result.reason
    assert result.trace("r1")["to_s"][-1] == pytest.approx(run.time, abs=2 * run.step_s)
    assert run.poses.shape == (2, 3)


def test_views_show_the_instant_of_the_fault(tired):
    run = elsie.Simulation(tired)
    poses = run.poses
    start = poses.copy()
    with pytest.raises(elsie.PluginFault):
        run.run()
    assert (poses[:, :2] != start[:, :2]).any(axis=1).all()


def test_a_reset_run_begins_anew(tired):
    run = elsie.Simulation(tired)
    with pytest.raises(elsie.PluginFault):
        run.run()
    run.reset()
    run["robot[r2]/behavior[tired]/@after"] = 10
    assert run.run().outcome == "time_limit"


def test_a_study_ends_with_the_fault_of_a_run(tired):
    with pytest.raises(elsie.PluginFault, match="so tired"):
        elsie.run(tired, range(8), workers=2)


def test_a_source_with_mistakes_gives_the_messages_of_the_compiler(tmp_path, monkeypatch):
    monkeypatch.setenv("ELSIE_CACHE", str(tmp_path / "cache"))
    (tmp_path / "wrong.cpp").write_text("int main() { return nowhere; }")
    with pytest.raises(elsie.PluginError, match="nowhere"):
        elsie.World.parse(ARENA, plugins=[tmp_path / "wrong.cpp"])
