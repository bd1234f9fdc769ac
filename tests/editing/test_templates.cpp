// Edits of a document whose robots have a template.
#include <catch2/catch.hpp>

#include "documents.h"
#include "folder.h"

using namespace elsie;
using namespace elsie::test;

namespace {

const char* const kTemplate = R"(<robot_template format="1" max_speed="0.4">
  <body mass="2"/>
  <sensors>
    <beam id="left" yaw_deg="15" max_range="2"/>
    <eye><threshold low="0.1"/><threshold low="0.2"/><mask/></eye>
    <bumper/>
  </sensors>
  <behaviors>
    <roam priority="2"/>
    <blend id="both"><behaviors><roam speed="4"/></behaviors>
      <coordinator><sum/></coordinator></blend>
  </behaviors>
  <coordinator><sum weighted="true"/></coordinator>
</robot_template>
)";

const char* const kOfTemplate = R"(<world format="1">
  <robots>
    <robot id="r1" template="../robots/two.xml" x="1"/>
    <robot id="r2" template="../robots/two.xml" x="-1">
      <sensors>
        <beam id="left" yaw_deg="30"/>
      </sensors>
    </robot>
  </robots>
</world>
)";

// A world whose robots have a template, in a folder of its own.
class Templated {
 public:
  Templated() {
    folder_.write("robots/two.xml", kTemplate);
    folder_.write("worlds/world.xml", kOfTemplate);
  }
  ~Templated() { CHECK(text_of(path("robots/two.xml")) == kTemplate); }

  std::string path(const std::string& name) const { return folder_.file(name); }
  Document open() const { return Document::open(path("worlds/world.xml"), host(), reading()); }
  std::string change(const std::string& edit) const { return ::change(open(), edit); }
  std::string refusal(const std::string& edit) const {
    Document one = open();
    return ::refusal(one, {edit});
  }

  test::Folder folder_;
};

}  // namespace

TEST_CASE("What comes from a template is overridden in the robot's own element") {
  const Templated files;
  const auto in_r1 = [](const std::string& lines) {
    return "-    <robot id=\"r1\" template=\"../robots/two.xml\" x=\"1\"/>\n"
           "+    <robot id=\"r1\" template=\"../robots/two.xml\" x=\"1\">\n" +
           lines + "+    </robot>\n";
  };
  CHECK(files.change("robot[r1]/@max_speed=0.3") ==
        "-    <robot id=\"r1\" template=\"../robots/two.xml\" x=\"1\"/>\n"
        "+    <robot id=\"r1\" template=\"../robots/two.xml\" x=\"1\" max_speed=\"0.3\"/>\n");
  CHECK(files.change("robot[r1]/@max_speed/@remove=true") ==
        "-    <robot id=\"r1\" template=\"../robots/two.xml\" x=\"1\"/>\n"
        "+    <robot id=\"r1\" template=\"../robots/two.xml\" x=\"1\" max_speed=\"0.5\"/>\n");
  CHECK(files.change("robot[r1]/body/@mass=3") == in_r1("+      <body mass=\"3\"/>\n"));
  CHECK(files.change("robot[r1]/sensor[left]/@yaw_deg=9") ==
        in_r1("+      <sensors>\n+        <beam id=\"left\" yaw_deg=\"9\"/>\n"
              "+      </sensors>\n"));
  CHECK(
      files.change("robot[r2]/sensor[left]/@yaw_deg=9") ==
      "-        <beam id=\"left\" yaw_deg=\"30\"/>\n+        <beam id=\"left\" yaw_deg=\"9\"/>\n");
  CHECK(files.change("robot[r1]/sensor[bumper]/@remove=true") ==
        in_r1("+      <sensors>\n+        <bumper id=\"bumper\" remove=\"true\"/>\n"
              "+      </sensors>\n"));
  CHECK(files.change("robot[r2]/sensor[left]/@remove=true") ==
        "-        <beam id=\"left\" yaw_deg=\"30\"/>\n"
        "+        <beam id=\"left\" remove=\"true\"/>\n");
  CHECK(files.change("robot[r1]/coordinator/@weighted=false") ==
        in_r1("+      <coordinator>\n+        <sum weighted=\"false\"/>\n"
              "+      </coordinator>\n"));
  CHECK(files.change("robot[r1]/coordinator=<pick/>") ==
        in_r1("+      <coordinator>\n+        <pick/>\n+      </coordinator>\n"));
  CHECK(files.change("robot[r1]/behavior[both]/behavior[roam]/@speed=9") ==
        in_r1("+      <behaviors>\n+        <blend id=\"both\">\n+          <behaviors>\n"
              "+            <roam id=\"roam\" speed=\"9\"/>\n"
              "+          </behaviors>\n+        </blend>\n+      </behaviors>\n"));
}

TEST_CASE("What is added to a robot with a template does not override the template") {
  const Templated files;
  CHECK(files.change("robot[r2]/sensor[+]=<bumper/>") == "+        <bumper id=\"bumper_2\"/>\n");
  CHECK(files.change("robot[r2]/sensor[+]=<beam/>") == "+        <beam/>\n");
  CHECK(files.change("robot[+]=<robot id='r3' template='../robots/two.xml' x='3'/>") ==
        "+    <robot id=\"r3\" template=\"../robots/two.xml\" x=\"3\"/>\n");
  CHECK(files.change("robot[r1]/@remove=true") ==
        "-    <robot id=\"r1\" template=\"../robots/two.xml\" x=\"1\"/>\n");
  CHECK(files.change("robot[r1]/@template/@remove=true") ==
        "-    <robot id=\"r1\" template=\"../robots/two.xml\" x=\"1\"/>\n"
        "+    <robot id=\"r1\" x=\"1\"/>\n");
}

TEST_CASE("Elements of a plugin replace those of the template as a list") {
  const Templated files;
  Document d = files.open();
  d.apply({"robot[r1]/sensor[eye]/threshold[2]/@low=0.3"});
  const auto& eye = d.world().robots[0].sensors[1];
  REQUIRE(eye.elements.size() == 3);
  CHECK(std::get<double>(eye.elements[0].parameters.at("low")) == 0.1);
  CHECK(std::get<double>(eye.elements[1].parameters.at("low")) == 0.3);
}

TEST_CASE("What the robot's element cannot say is refused") {
  const Templated files;
  CHECK_THAT(files.refusal("robot[r1]/sensor[left]=<bumper/>"),
             Catch::Contains("'left' is a <beam> in the template"));
  // It would come after the other sensors of the template.
  CHECK_THAT(files.refusal("robot[r2]/sensor[left]/@id=l2"),
             Catch::Contains("a file cannot express this"));
  CHECK_THAT(files.refusal("robot[r1]/sensor[+1]=<beam/>"),
             Catch::Contains("a file cannot express this"));
}

TEST_CASE("A document is saved elsewhere with names that lead to the same files") {
  const Templated files;
  files.folder_.write("worlds/here.txt", "la");
  files.folder_.write("other/deep/place.txt", "");
  Document d = files.open();
  d.apply({"robot[r1]/behavior[both]/behavior[roam]/@song=here.txt"});
  const std::string before = d.text();
  CHECK(d.text_for(files.path("worlds")) == before);
  const std::string text = d.text_for(files.path("other/deep"));
  CHECK_THAT(text, Catch::Contains("template=\"../../robots/two.xml\"") &&
                       Catch::Contains("song=\"../../worlds/here.txt\""));
  const world::World there =
      world::parse_world(text, files.path("other/deep/copy.xml"), host(), reading());
  CHECK(there.robots[0].behaviors[1].inside.at(0).behaviors[0].parameters ==
        d.world().robots[0].behaviors[1].inside.at(0).behaviors[0].parameters);
  // Names in what is edited later, too.
  d.apply(
      {"change[+]=<change time=\"1\" path=\"robot[r1]/behavior[both]/behavior[roam]/@song\" "
       "value=\"here.txt\"/>"});
  d.apply(
      {"change[+]=<change time=\"2\" path=\"robot[+]\"><robot id=\"r9\" x=\"5\" "
       "template=\"../robots/two.xml\"/></change>"});
  d.apply(
      {"change[+]=<change time=\"3\" path=\"robot[+]\" value=\"&lt;robot id='r8' x='5' "
       "template='../robots/two.xml'/&gt;\"/>"});
  const std::string later = d.text_for(files.path("other/deep"));
  CHECK_THAT(later, Catch::Contains("value=\"../../worlds/here.txt\"") &&
                        Catch::Contains("x=\"5\" template=\"../../robots/two.xml\"") &&
                        Catch::Contains("template=&quot;../../robots/two.xml&quot;"));
  try {
    (void)d.text_for(files.path("nowhere"));
    FAIL("there is no such folder");
  } catch (const world::WorldError& error) {
    CHECK(error.problems().front().message ==
          "there is no such folder; a world is saved in one that exists");
  }
}
