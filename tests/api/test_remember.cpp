#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/api/remember.h"

using elsie::Memory;

TEST_CASE("What is written under a name is read under it, with its type") {
  enum class Phase { none, back, turn };
  Memory memory;
  bool on = true;
  int count = -3;
  std::size_t index = 7;
  double speed = 0.1;
  Phase phase = Phase::turn;
  std::string text = "left";
  std::vector<double> list = {1.0, 2.5};
  const auto name_all = [&] {
    memory("on", on);
    memory("count", count);
    memory("index", index);
    memory("speed", speed);
    memory("phase", phase);
    memory("text", text);
    memory("list", list);
  };
  name_all();
  CHECK(memory.size() == 7);
  CHECK_FALSE(memory.recalls());
  on = false;
  count = 0;
  index = 0;
  speed = 0.0;
  phase = Phase::none;
  text.clear();
  list.clear();
  memory.begin_recall();
  CHECK(memory.recalls());
  name_all();
  CHECK(on);
  CHECK(count == -3);
  CHECK(index == 7);
  CHECK(speed == 0.1);
  CHECK(phase == Phase::turn);
  CHECK(text == "left");
  CHECK(list == std::vector<double>{1.0, 2.5});
}

TEST_CASE("What is not known, or of another type, is left as it is") {
  Memory memory;
  double speed = 0.1;
  int count = 4;
  std::string text = "left";
  memory("speed", speed);
  memory("count", count);
  memory("text", text);
  memory.begin_recall();
  int whole = 1;
  memory("speed", whole);  // not cut off to a whole number
  CHECK(whole == 1);
  double number = 2.0;
  memory("count", number);  // a whole number is a number
  CHECK(number == 4.0);
  bool flag = false;
  memory("text", flag);
  CHECK_FALSE(flag);
  double unknown = 5.0;
  memory("unknown", unknown);
  CHECK(unknown == 5.0);
  std::optional<double> wrong;
  memory("text", wrong);
  CHECK_FALSE(wrong);
}

TEST_CASE("An optional value is handed over when there is one") {
  Memory memory;
  std::optional<std::size_t> winner = 2, nobody;
  memory("winner", winner);
  memory("nobody", nobody);
  CHECK(memory.size() == 1);
  memory.begin_recall();
  std::optional<std::size_t> next, still;
  memory("winner", next);
  memory("nobody", still);
  CHECK(next == std::optional<std::size_t>(2));
  CHECK_FALSE(still);
}
