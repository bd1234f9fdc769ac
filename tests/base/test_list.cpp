// A list whose copies share its items.
#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/list.h"

using List = elsie::base::List<std::string>;

namespace {
std::vector<std::string> content(const List& list) { return {list.begin(), list.end()}; }
}  // namespace

TEST_CASE("A copy of a list has the same items until one of the two is changed") {
  List first{"a", "b", "c"};
  const List second = first;
  CHECK(second.is(first));
  CHECK(&std::as_const(first)[1] == &second[1]);
  CHECK(first.is_shared(1));
  first[1] = "changed";
  CHECK_FALSE(second.is(first));
  CHECK(content(first) == std::vector<std::string>{"a", "changed", "c"});
  CHECK(content(second) == std::vector<std::string>{"a", "b", "c"});
  CHECK(&std::as_const(first)[0] == &second[0]);  // the others are still shared
  CHECK_FALSE(first.is_shared(1));
  const std::string* const own = &std::as_const(first)[1];
  first[1] = "again";
  CHECK(&std::as_const(first)[1] == own);  // what nobody shares is changed in place
}

TEST_CASE("A list takes items of another one, and keeps what it has when the other one grows") {
  List from{"a", "b"};
  List to;
  CHECK(to.empty());
  to.share(from, 1);
  CHECK(&std::as_const(to)[0] == &std::as_const(from)[1]);
  from.push_back("c");
  from.back() += "d";
  from.front() = "first";
  CHECK(content(to) == std::vector<std::string>{"b"});
  CHECK(content(from) == std::vector<std::string>{"first", "b", "cd"});
  const auto kept = from.kept(2);
  from[2] = "other";
  CHECK(*kept == "cd");
  CHECK_THROWS_AS(std::as_const(to).at(1), std::out_of_range);
}

TEST_CASE("A list is gone through like a vector") {
  List list = std::vector<std::string>{"c", "a", "b"};
  const List copy = list;
  for (std::string& each : list) each += "!";
  std::sort(list.begin(), list.end());
  CHECK(content(list) == std::vector<std::string>{"a!", "b!", "c!"});
  CHECK(content(copy) == std::vector<std::string>{"c", "a", "b"});
  CHECK(std::find(copy.begin(), copy.end(), "b") - copy.begin() == 2);
  list.resize(1);
  list.resize(2);
  CHECK(content(list) == std::vector<std::string>{"a!", ""});
  list.clear();
  CHECK(list.size() == 0);
}
