// Documents for tests, and what an edit changes in their text.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/editing/document.h"

#include "../world/equal.h"
#include "../world/fixture.h"

namespace elsie::test {

using editing::Document;

inline const std::string kWorld =
    R"(<?xml version="1.0"?>
<!-- A world with much that a writer would lose. -->
<world  format='1'   name="odd" >
  <obstacles>
    <static_box id="wall" x="1"/>   <!-- in the way -->
    <dynamic_box id='crate'
                 x='2'
                 y='0.5' />

    <!-- the next one has no id -->
    <static_box x="3"/><static_box x="4"/>
  </obstacles>
  <robots>
    <robot id="r1" max_speed="0.30">
      <sensors>
        <beam id="left" yaw_deg="20"/>
        <eye>
          <threshold low="0.1"/>
          <mask/>
          <threshold low="0.2"/>
        </eye>
      </sensors>
      <behaviors>
        <roam/>
        <blend id="both">
          <behaviors><roam/></behaviors>
          <coordinator><sum/></coordinator>
        </blend>
      </behaviors>
      <coordinator><sum weighted="true"/></coordinator>
    </robot>
    <robot id="r2" x="-1" y="1"><sensors/></robot>
  </robots>
  <!-- nothing to reach -->
</world>
)";

inline std::string file() { return kFolder + "world.xml"; }

// The first document's options: no objects are made of plugins.
inline world::ReadOptions reading() {
  world::ReadOptions reading = options();
  reading.check_plugins = false;
  return reading;
}

inline Document document(const std::string& text = kWorld) {
  return Document(text, file(), host(), reading());
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

// The lines between the first and the last that differ, as a diff shows them.
inline std::string diff(const std::string& from, const std::string& to) {
  auto old = lines_of(from);
  auto now = lines_of(to);
  while (!old.empty() && !now.empty() && old.back() == now.back()) {
    old.pop_back();
    now.pop_back();
  }
  std::size_t same = 0;
  while (same < old.size() && same < now.size() && old[same] == now[same]) {
    ++same;
  }
  std::string text;
  for (std::size_t i = same; i < old.size(); ++i) {
    text += "-" + old[i] + "\n";
  }
  for (std::size_t i = same; i < now.size(); ++i) {
    text += "+" + now[i] + "\n";
  }
  return text;
}

// What an edit changes in a text.
inline std::string change(Document document, const std::string& edit) {
  const std::string before = document.text();
  document.apply({edit});
  const std::string after = document.text();
  CHECK(same(Document(after, document.file(), host(), reading()).world(), document.world()));
  return diff(before, after);
}
inline std::string change(const std::string& edit) { return change(document(), edit); }

inline std::string refusal(Document& document, const std::vector<std::string>& edits) {
  const std::string before = document.text();
  const world::World world = document.world();
  try {
    document.apply(edits);
  } catch (const world::WorldError& error) {
    CHECK(document.text() == before);
    CHECK(same(document.world(), world));
    return error.problems().front().message;
  }
  return "";
}
inline std::string refusal(const std::string& edit) {
  Document one = document();
  return refusal(one, {edit});
}

}  // namespace elsie::test
