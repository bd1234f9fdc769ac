#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using elsie::test::Workplace;
using nlohmann::json;

TEST_CASE("plugins lists what was found") {
  Workplace here;
  const auto run = here.elsie("plugins");
  CHECK(run.exit_code == 0);
  for (const char* name :
       {"beam_range", "proximity", "avoid_obstacle", "turn_left", "turn_right", "wander",
        "go_to_point", "braitenberg", "arbiter_suppression", "fusion_vector_summation"}) {
    CHECK_THAT(run.out, Catch::Contains(name));
  }
  CHECK_THAT(run.out, Catch::Contains("engines, for <physics engine=\"...\">\n  ode\n  planar\n"));
  const json all = json::parse(here.elsie("plugins --json").out);
  CHECK(all.at("engines") == json({"ode", "planar"}));
  CHECK(all.at("plugins").size() >= 10);
  CHECK_FALSE(all.at("directories").empty());
}

TEST_CASE("describe prints parameters, defaults, ranges and events") {
  Workplace here;
  const auto run = here.elsie("describe go_to_point");
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.out,
             Catch::Contains("tolerance") && Catch::Contains("0.05") && Catch::Contains("arrived"));
  const json plugin = json::parse(here.elsie("describe beam_range --json").out);
  CHECK(plugin.at("kind") == "sensor");
  CHECK(plugin.at("produces")[0] == "range");
  CHECK(plugin.at("parameters")[0].at("name") == "max_range");
  CHECK(plugin.at("parameters")[0].at("default") == 1.0);
  CHECK(plugin.at("parameters")[0].at("above") == 0.0);
  CHECK_THAT(here.elsie("describe world").out, Catch::Contains("static_box"));
}

TEST_CASE("describe picks a plugin by its kind, and prints its declaration alone") {
  Workplace here;
  const std::string page = here.elsie("describe wander").out;
  CHECK(here.elsie("describe behavior wander").out == page);
  CHECK("# wander\n\n" + here.elsie("describe wander --declaration").out == page);
  CHECK_THAT(here.elsie("describe sensor wander").err,
             Catch::Contains("there is no sensor 'wander'"));
  CHECK(here.elsie("describe sensor wander").exit_code == 2);
  CHECK(here.elsie("describe wheel wander").exit_code == 2);
  CHECK(here.elsie("describe wander --json --declaration").exit_code == 2);
}

TEST_CASE("describe and plugins print nested elements") {
  Workplace here;
  const json vision = json::parse(here.elsie("describe vision --json").out);
  REQUIRE_FALSE(vision.at("elements").empty());
  const json& element = vision.at("elements")[0];
  CHECK_FALSE(element.at("meaning").get<std::string>().empty());
  CHECK(element.at("list") == 0);
  CHECK_FALSE(vision.at("default_elements").empty());
  CHECK(vision.at("holds_behaviors") == false);
  const std::string name = element.at("name");
  CHECK_THAT(here.elsie("describe vision").out, Catch::Contains("\n`<" + name + ">`: "));
  CHECK_THAT(here.elsie("plugins").out, Catch::Contains("holds <" + name + ">"));
}

TEST_CASE("The schema accepts the shipped worlds") {
  Workplace here;
  const auto run = here.sh(
      "elsie schema > world.xsd\n"
      "xmllint --noout --schema world.xsd worlds/*.xml");
  CAPTURE(run.err);
  CHECK(run.exit_code == 0);
}

TEST_CASE("check says of each world whether it is in order") {
  Workplace here;
  const auto run = here.elsie("check worlds/*.xml");
  CAPTURE(run.err);
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.out, Catch::Contains("worlds/maze.xml: in order: 1 robot, "));
  CHECK(here.elsie("check worlds/*.xml --quiet").out.empty());
}

TEST_CASE("check distinguishes experiments from worlds, and reports whether each is in order") {
  Workplace here;
  const auto run = here.elsie("check worlds/maze.xml experiments/four_resources.xml");
  CAPTURE(run.err);
  CHECK(run.exit_code == 0);
  CHECK(run.out ==
        "worlds/maze.xml: in order: 1 robot, 14 obstacles\n"
        "experiments/four_resources.xml: in order: 8 cells, 160 runs, 10 expectations\n");
  const auto with_set = here.elsie("check experiments/four_resources.xml --set @name=a");
  CHECK(with_set.exit_code == 2);
  CHECK_THAT(with_set.err, Catch::Contains("--set is for worlds; 'experiments/four_resources.xml' "
                                           "is an experiment"));
}

TEST_CASE("check reports all mistakes of an experiment, with their levels") {
  Workplace here;
  here.write("wrong.xml", R"(<experiment format="1">
  <worlds><world file="worlds/four_resources.xml"/></worlds>
  <vary path="robot[collector]/coordinator">
    <level><fusion_interval/></level>
    <level><arbiter_suppression/></level>
  </vary>
  <vary path="robot[collector]/coordinator/@steps" values="11; 21"/>
  <seeds from="1" to="20"/>
  <expectations>
    <expect measure="success" where="coordinator=fusion_intervall" at_least="1"/>
  </expectations>
</experiment>
)");
  const auto run = here.elsie("check wrong.xml worlds/maze.xml");
  CHECK(run.exit_code == 2);
  CHECK_THAT(run.err, Catch::Contains("wrong.xml:10: where=\"coordinator=fusion_intervall\" of "
                                      "<expect>: 'coordinator' has no level 'fusion_intervall'; "
                                      "did you mean 'fusion_interval'?\n"));
  CHECK_THAT(run.err, Catch::Contains("wrong.xml:7: ") &&
                          Catch::Contains("has no attribute 'steps'") &&
                          Catch::Contains("(with coordinator=arbiter_suppression)\n"));
  CHECK_THAT(run.err, Catch::Contains("elsie: 1 of 2 files are wrong\n"));
  CHECK_THAT(run.out, Catch::Contains("worlds/maze.xml: in order"));
}

TEST_CASE("check shows its progress with a large experiment, on terminals only") {
  Workplace here;
  here.write("many.xml", R"(<experiment format="1">
  <worlds><world file="worlds/clutter.xml"/></worlds>
  <vary path="robot[r1]/@max_speed" from="0.001" to="4" step="0.001"/>
  <seeds from="1" to="1"/>
</experiment>
)");
  const std::string found = "many.xml: in order: 4000 cells, 4000 runs, 0 expectations";
  const auto seen = here.sh("script -qec 'elsie check many.xml' /dev/null < /dev/null");
  CHECK(seen.exit_code == 0);
  CHECK_THAT(seen.out, Catch::StartsWith("\r[") &&
                           Catch::Contains(" %  of 4000 cells checked\033[K") &&
                           Catch::Contains("\r\033[K" + found));
  const auto quiet = here.sh("script -qec 'elsie check many.xml --quiet' /dev/null < /dev/null");
  CHECK(quiet.exit_code == 0);
  CHECK(quiet.out.empty());
  const auto unseen = here.elsie("check many.xml");
  CHECK(unseen.err.empty());
  CHECK(unseen.out == found + "\n");
}

TEST_CASE("schema and describe know experiments") {
  Workplace here;
  const auto run = here.sh(
      "elsie schema experiment > experiment.xsd\n"
      "xmllint --noout --schema experiment.xsd experiments/*.xml");
  CAPTURE(run.err);
  CHECK(run.exit_code == 0);
  CHECK(here.elsie("schema world").out == here.elsie("schema").out);
  CHECK(here.elsie("schema experment").exit_code == 2);
  CHECK_THAT(here.elsie("describe experiment").out,
             Catch::StartsWith("# Experiment files") && Catch::Contains("`confidence`"));
  const auto as_json = here.elsie("describe experiment --json");
  CHECK(as_json.exit_code == 2);
  CHECK_THAT(as_json.err, Catch::Contains("`elsie schema experiment` prints its schema"));
}

TEST_CASE("picture draws a world, as PNG or SVG") {
  Workplace here;
  CHECK(here.elsie("picture worlds/maze.xml").exit_code == 0);
  CHECK_THAT(here.read("maze.png"), Catch::StartsWith("\x89PNG"));
  CHECK(here.elsie("picture worlds/maze.xml -o m.svg --width 600").exit_code == 0);
  CHECK(here.sh("xmllint --noout m.svg").exit_code == 0);
  CHECK(here.elsie("picture worlds/maze.xml second.svg").exit_code == 0);
  CHECK_THAT(here.read("second.svg"), Catch::Contains(">x (m)</text>"));
  CHECK(here.elsie("picture worlds/maze.xml a.png -o b.png").exit_code == 2);
  const auto refused = here.elsie("picture worlds/maze.xml a.gif");
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.err, Catch::Contains("a picture's name must end in .png or .svg"));
}

TEST_CASE("A run's picture has the ways that are asked for") {
  Workplace here;
  const std::string run = "run worlds/ten_robots.xml --duration 4 --quiet --picture ";
  here.elsie(run + "all.svg");
  here.elsie(run + "some.svg --picture-robots r1,r2 --picture-from 1 --picture-to 3");
  here.elsie(run + "fading.svg --picture-fade 2");
  CHECK_THAT(here.read("all.svg"), Catch::Contains("path, from its start"));
  CHECK_THAT(here.read("some.svg"), Catch::Contains("path from 1 s to 3 s"));
  CHECK_THAT(here.read("fading.svg"), Catch::Contains("path of the last 2 s"));
  CHECK(here.read("some.svg").size() < here.read("all.svg").size());
  const auto refused = [&](const std::string& options, const std::string& why) {
    const auto wrong = here.elsie("run worlds/ten_robots.xml --duration 4 " + options);
    CHECK(wrong.exit_code == 2);
    CHECK_THAT(wrong.err, Catch::Contains(why));
  };
  refused("--picture a.png --picture-robots r1,r99", "there is no robot 'r99' in this world");
  refused("--picture a.png --picture-from 3 --picture-to 2", "cannot begin at 3 s and end at 2 s");
  refused("--picture-fade 2", "--picture");
}

TEST_CASE("fuzzy shows a model, evaluates it and draws it") {
  Workplace here;
  const std::string model = "fuzzy fuzzy_models/avoid_obstacle_left.fcl ";
  CHECK_THAT(here.elsie(model).out, Catch::Contains("input range in [") && Catch::Contains("IF "));
  const auto evaluated = here.elsie(model + "--input range=1 --input azimuth=15");
  CHECK_THAT(evaluated.out, Catch::Contains("speed = "));
  const json result = json::parse(
      here.elsie(model + "--input range=1 --input azimuth=15 --json --picture left.png").out);
  CHECK(result.at("result").at("speed").get<double>() == Approx(20).margin(2));
  CHECK(result.at("rules")[0].contains("degree"));
  CHECK_THAT(here.read("left.png"), Catch::StartsWith("\x89PNG"));
}

TEST_CASE("fuzzy shows a model whose rules leave gaps, which no robot may use") {
  Workplace here;
  here.write("gaps.fcl",
             "FUNCTION_BLOCK gaps\nVAR_INPUT\n  range, azimuth : REAL;\nEND_VAR\nVAR_OUTPUT\n"
             "  speed : REAL;\nEND_VAR\nFUZZIFY range\n  TERM near := (0, 1) (1, 0);\n"
             "END_FUZZIFY\nDEFUZZIFY speed\n  TERM slow := FUNCTION azimuth / 2;\n"
             "END_DEFUZZIFY\nRULEBLOCK\n  RULE 1 : IF range IS near THEN speed IS slow;\n"
             "END_RULEBLOCK\nEND_FUNCTION_BLOCK\n");
  const auto shown = here.elsie("fuzzy gaps.fcl --input range=2 --input azimuth=30");
  CHECK(shown.exit_code == 0);
  CHECK_THAT(shown.err, Catch::Contains("gaps.fcl:11: The output 'speed' has no DEFAULT, but no "
                                        "rule decides it at range = 1.5: it is nan there"));
  CHECK_THAT(shown.out, Catch::Contains("slow: azimuth / 2") && Catch::Contains("speed = nan"));
  const json result =
      json::parse(here.elsie("fuzzy gaps.fcl --input range=0.5 --input azimuth=30 --json").out);
  CHECK(result.at("result").at("speed") == 15.0);
  here.write("world.xml",
             "<world format=\"1\"><robots><robot id=\"r1\"><sensors><beam_range/></sensors>"
             "<behaviors><avoid_obstacle left_model=\"gaps.fcl\"/></behaviors><coordinator>"
             "<fusion_vector_summation/></coordinator></robot></robots></world>\n");
  const auto refused = here.elsie("check world.xml");
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.err, Catch::Contains("gaps.fcl:11: The output 'speed' has no DEFAULT"));
}

TEST_CASE("fuzzy begins without a last value: DEFAULT := NC has nothing to keep") {
  Workplace here;
  const std::string model =
      "fuzzy '" + elsie::test::source_path("tests/plugins/keeps_last.fcl") + "' ";
  const std::string far = " --input range=1 --input azimuth=0";
  CHECK_THAT(here.elsie(model + "--block begins_with_7" + far).out, Catch::Contains("speed = 7\n"));
  CHECK_THAT(here.elsie(model + "--block keeps" + far).out,
             Catch::Contains("speed = its last value: no rule decides it"));
  CHECK(
      json::parse(here.elsie(model + "--block keeps --json" + far).out).at("result").at("speed") ==
      nullptr);
}

TEST_CASE("Help has examples and exit codes") {
  Workplace here;
  CHECK_THAT(here.elsie("--help").out,
             Catch::Contains("Examples:") && Catch::Contains("Exit codes:"));
  for (const char* subcommand :
       {"run", "check", "picture", "plugins", "describe", "schema", "fuzzy", "train"}) {
    const auto help = here.elsie(std::string(subcommand) + " --help");
    CHECK(help.exit_code == 0);
    CHECK_THAT(help.out, Catch::Contains("Example"));
  }
  CHECK_THAT(here.elsie("--version").out, Catch::StartsWith("elsie 0."));
}

TEST_CASE("session says that it is for windows") {
  const Workplace here;
  const auto run = here.elsie("session");
  CHECK(run.exit_code == 2);
  CHECK_THAT(run.err, Catch::Contains("`elsie session` is for windows"));
}

TEST_CASE("No name in a file commands the terminal, in words; JSON has it as it is") {
  Workplace here;
  const std::string name =
      "\xe2\x80\xae"
      "\xc2\x9b"
      "31m";  // turns the text round, colours it
  REQUIRE(here.elsie("run worlds/open_arena.xml --duration 0.1 --quiet --set \"@name=" + name +
                     "\" --record r.mcap")
              .exit_code <= 1);  // the goal may be missed
  const auto is_clean = [&](const std::string& text) {
    return text.find("\xe2\x80\xae") == std::string::npos &&
           text.find("\xc2\x9b") == std::string::npos &&
           text.find("\xef\xbf\xbd") != std::string::npos;
  };
  CHECK(is_clean(here.elsie("replay r.mcap").out));
  CHECK(is_clean(here.elsie("explain r.mcap").out));
  CHECK(json::parse(here.elsie("replay r.mcap --json").out).at("world") == name);
  here.write("wrong.xml", "<world format=\"1\"><arena length=\"" + name + "\"/></world>");
  CHECK(is_clean(here.elsie("check wrong.xml").err));
  here.write(
      "w.xml",
      "<world format=\"1\"><robots><robot id=\"r1\"/></robots><limits time=\"0.1\"/></world>");
  here.write("study.xml", "<experiment format=\"1\" name=\"" + name +
                              "\"><worlds><world file=\"w.xml\"/></worlds>"
                              "<seeds list=\"1\"/></experiment>");
  CHECK(is_clean(here.elsie("batch study.xml --workers 1").out));
}

TEST_CASE("describe knows the elements of files by their names") {
  Workplace here;
  CHECK_THAT(here.elsie("describe reach").out,
             Catch::StartsWith("## world / goals / reach\n") && Catch::Contains("| `robot` |"));
  CHECK_THAT(here.elsie("describe goals").out, Catch::Contains("## world / goals / travel\n"));
  CHECK_THAT(here.elsie("describe seeds").out, Catch::StartsWith("## experiment / seeds\n"));
  CHECK_THAT(here.elsie("describe wander").out, Catch::StartsWith("# wander\n"));
  const auto unknown = here.elsie("describe raech");
  CHECK(unknown.exit_code == 2);
  CHECK_THAT(unknown.err, Catch::Contains("did you mean 'reach'?"));
}

TEST_CASE("check warns of goals out of reach, and of beams that look over everything") {
  Workplace here;
  const auto warnings = [&](const std::string& content) {
    here.write("w.xml", "<world format=\"1\">\n<arena length=\"8\" width=\"8\"/>" + content +
                            "<limits time=\"60\"/></world>\n");
    const auto check = here.elsie("check w.xml");
    CHECK(check.exit_code == 0);
    return check.err;
  };
  const std::string robot =
      "<robots><robot id=\"r1\" x=\"-1\" max_speed=\"0.5\"><sensors><beam_range/></sensors></robot>"
      "</robots>";
  CHECK_THAT(
      warnings(robot + "<goals>\n<travel distance=\"500\"/></goals>"),
      Catch::Contains("w.xml:3: warning: <travel> needs 500 m within 60 s, but the robot 'r1' "
                      "drives at most 0.5 m/s, which makes 30 m"));
  CHECK(warnings(robot + "<goals><travel distance=\"29\"/></goals>").empty());
  const std::string box =
      "<obstacles>\n<static_box id=\"b\" x=\"1\" length=\"1\" width=\"1\"/>"
      "</obstacles>";
  CHECK_THAT(
      warnings(box + robot + "<goals>\n<reach robot=\"r1\" x=\"1.1\" y=\"0\"/></goals>"),
      Catch::Contains("w.xml:4: warning: <reach>: no place within 0.2 m of (1.1, 0) is free: "
                      "the box 'b' stands there"));
  CHECK(warnings(box + robot + "<goals><reach robot=\"r1\" x=\"1.7\" y=\"0\"/></goals>").empty());
  CHECK_THAT(
      warnings("<obstacles>\n<static_box id=\"low\" x=\"1\" height=\"0.08\"/></obstacles>" + robot),
      Catch::Contains("w.xml:3: warning: the box 'low' is 0.08 m high, and all beams of the "
                      "robot 'r1' pass above it, at 0.09 m"));
  CHECK(warnings("<obstacles><static_box x=\"1\" height=\"0.1\"/></obstacles>" + robot).empty());
}

TEST_CASE("check warns of what nobody can carry to where it belongs") {
  Workplace here;
  const auto warnings = [&](const std::string& inside) {
    here.write("w.xml",
               "<world format=\"1\"><robots><robot id=\"r1\"/></robots>\n" + inside + "</world>");
    return here.elsie("check w.xml").err;
  };
  const auto puck = [](const std::string& more) {
    return "<resources><resource id=\"p\" x=\"1\" " + more + "/></resources>";
  };
  const std::string nest = "<nests><nest/></nests>";
  CHECK_THAT(warnings(puck("collect=\"nest\"")),
             Catch::Contains("w.xml:2: warning: the resource 'p' is to be carried to a nest, and "
                             "the world has none; add a <nest>"));
  CHECK_THAT(warnings(puck("collect=\"nest\" hands=\"2\"") + nest),
             Catch::Contains("the resource 'p' takes 2 hands, and the world has 1 robot"));
  CHECK_THAT(warnings(puck("hands=\"2\"")),
             Catch::Contains("has hands=\"2\", which counts only with collect=\"nest\""));
  CHECK(warnings(puck("collect=\"nest\"") + nest).empty());
}

TEST_CASE("check warns of what nobody hears, and of goals about any robot that none can reach") {
  Workplace here;
  const auto warnings = [&](const std::string& content) {
    here.write("w.xml", "<world format=\"1\">\n" + content + "</world>");
    return here.elsie("check w.xml").err;
  };
  const auto talker = [](const std::string& id, const std::string& device) {
    return "<robot id=\"" + id + "\" x=\"" + std::to_string(id.size()) + "\">\n<actuators>" +
           device + "</actuators></robot>";
  };
  const auto robots = [](const std::string& all) { return "<robots>" + all + "</robots>"; };
  CHECK_THAT(
      warnings(robots(talker("a", "<radio/>") + talker("bb", "<range_and_bearing/>"))),
      Catch::Contains("w.xml:3: warning: nobody hears the robot 'a': it is the only one with "
                      "a <radio>"));
  CHECK(warnings(robots(talker("a", "<radio/>") + talker("bb", "<radio/>"))).empty());
  const std::string far = "<goals>\n<travel any=\"true\" distance=\"40\"/></goals>";
  const auto fast = [&](const std::string& second) {
    return robots("<robot id=\"a\" x=\"1\"/><robot id=\"b\" max_speed=\"" + second + "\"/>") + far;
  };
  CHECK_THAT(warnings(fast("0.5")), Catch::Contains("<travel> needs 40 m within 60 s"));
  CHECK(warnings(fast("1")).empty());
}

TEST_CASE("check refuses events that nothing raises, wherever a shipped plugin names one") {
  Workplace here;
  const auto refusal = [&](const std::string& behaviors, const std::string& rules) {
    here.write("w.xml",
               "<world format=\"1\"><fields><field id=\"pheromone\"/></fields><robots>"
               "<robot id=\"r1\"><actuators><radio/><pen/></actuators><behaviors>" +
                   behaviors + "</behaviors></robot></robots><rules>" + rules + "</rules></world>");
    return here.elsie("check w.xml").err;
  };
  const std::string meant = "did you mean 'collision'?";
  CHECK_THAT(refusal("<say event=\"colision\"/>", ""), Catch::Contains(meant));
  CHECK_THAT(refusal("<lay_trail from=\"colision\"/>", ""), Catch::Contains(meant));
  CHECK_THAT(refusal("<lay_trail until=\"colision\"/>", ""), Catch::Contains(meant));
  CHECK_THAT(refusal("", "<referee><event name=\"colision\"/></referee>"), Catch::Contains(meant));
  CHECK_THAT(refusal("<say event=\"collision\"/><lay_trail until=\"collision\"/>",
                     "<referee><event name=\"collision\"/></referee>"),
             !Catch::Contains("raises"));
}

TEST_CASE("A number with its unit is refused with the unit to leave out") {
  Workplace here;
  const auto refusal = [&](const std::string& speed) {
    return here.elsie("check worlds/maze.xml --set 'robot[*]/@max_speed=" + speed + "'").err;
  };
  CHECK_THAT(refusal("0.4 m/s"), Catch::Contains("write the number only; the unit is m/s"));
  CHECK_THAT(refusal("0.4m"), Catch::Contains("write the number only; the unit is m/s"));
  CHECK_THAT(refusal("22,5"), Catch::Contains("decimals are written with a point"));
  here.write("gather.xml",
             "<world format=\"1\"><robots><robot id=\"r1\"/><robot id=\"r2\" x=\"1\"/></robots>"
             "<goals><gather/></goals></world>");
  CHECK_THAT(here.elsie("check gather.xml").err,
             Catch::Contains("<gather> lacks the attribute 'team'; there are: red, blue"));
}
