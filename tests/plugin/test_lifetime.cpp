// A library stays as long as the host or any object of it, and no longer.
#include <optional>
#include <utility>

#include <catch2/catch.hpp>

#include "elsie/api/behavior.h"

#include "support.h"

using namespace elsie;
using namespace elsie::plugin;
using namespace elsie::plugin::test;

TEST_CASE("Objects outlive their host, and the library goes with the last of them") {
  Folder folder;
  folder.with("good");
  std::optional<Host> host = host_of(folder);
  auto first = host->create<Behavior>(PluginKind::behavior, "good");
  auto second = host->create<Behavior>(PluginKind::behavior, "good");
  auto coordinator = host->create<Component>(PluginKind::coordinator, "good");
  host.reset();
  CHECK(answer(*first).left == 3.0);
  first = {};
  CHECK(is_loaded(folder / "good.so"));
  coordinator = {};
  CHECK(answer(*second).left == 3.0);
  CHECK(is_loaded(folder / "good.so"));
  second = {};
  CHECK_FALSE(is_loaded(folder / "good.so"));
}

TEST_CASE("An object can be handed over to another owner") {
  Folder folder;
  folder.with("good");
  Object<Component> owner;
  {
    const Host host = host_of(folder);
    Object<Behavior> behavior = host.create<Behavior>(PluginKind::behavior, "good");
    owner = std::move(behavior);
  }
  CHECK(is_loaded(folder / "good.so"));
  owner = {};
  CHECK_FALSE(is_loaded(folder / "good.so"));
}

TEST_CASE("A library with an inline static in a template goes, and starts afresh when it returns") {
  Folder folder;
  folder.with("inline_static");
  for (int round = 0; round < 2; ++round) {
    {
      const Host host = host_of(folder);
      const auto object = host.create<Behavior>(PluginKind::behavior, "inline_static");
      // One object was made for the declaration, one is this.
      CHECK(answer(*object).left == 2.0);
    }
    CHECK_FALSE(is_loaded(folder / "inline_static.so"));
  }
}

TEST_CASE("Two hosts share a library and do not know of each other") {
  Folder folder;
  folder.with("good").with("twin_a");
  std::optional<Host> first = host_of(folder);
  const Host second = host_of(folder);
  first.reset();
  CHECK(answer(*second.create<Behavior>(PluginKind::behavior, "good")).left == 3.0);
  CHECK(second.report().warnings.empty());
}
