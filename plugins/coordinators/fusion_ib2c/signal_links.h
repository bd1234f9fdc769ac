// Links from the activity of one behaviour to the stimulation or the inhibition of another.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "member_names.h"

struct Link {
  std::string by;
  std::string of;
  double factor = 1.0;
};

class SignalLinks {
 public:
  struct Wire {
    std::size_t by;
    std::size_t of;
    double factor;
    bool inhibits;
  };

  std::vector<Wire> wires;
  std::vector<std::size_t> order;  // of decisions: those that act on others first

  /// Links these members. Problems go to `names`.
  void make(MemberNames& names, const std::vector<Link>& stimulations,
            const std::vector<Link>& inhibitions) {
    wires.clear();
    order.clear();
    add(names, "stimulate", stimulations, false);
    add(names, "inhibit", inhibitions, true);
    sort(names);
  }

 private:
  void add(MemberNames& names, const char* element, const std::vector<Link>& links, bool inhibits) {
    for (const Link& link : links) {
      const auto by = names.find(element, "by", link.by);
      const auto of = names.find(element, "of", link.of);
      if (by && of && *by == *of) {
        names.refuse(MemberNames::text(element, "by", link.by) +
                     " links a behaviour to itself; name two behaviours");
      } else if (by && of) {
        wires.push_back({*by, *of, link.factor, inhibits});
      }
    }
  }

  /// Whether something acts on this member that is not decided yet.
  bool waits(std::size_t member, const std::vector<bool>& done, bool only_stimulation) const {
    return std::any_of(wires.begin(), wires.end(), [&](const Wire& wire) {
      return wire.of == member && !done[wire.by] && !(only_stimulation && wire.inhibits);
    });
  }

  /// A circle with an inhibition is cut there, so that this acts one step late. A circle of
  /// stimulations could never begin.
  void sort(MemberNames& names) {
    const std::size_t n = names.size();
    std::vector<bool> done(n, false);
    while (order.size() < n) {
      std::size_t next = n;
      for (const bool only_stimulation : {false, true}) {
        for (std::size_t i = 0; i < n && next == n; ++i) {
          next = !done[i] && !waits(i, done, only_stimulation) ? i : next;
        }
      }
      if (next == n) {
        const auto first = std::find(done.begin(), done.end(), false) - done.begin();
        names.refuse(circle(names, static_cast<std::size_t>(first), done));
        return;
      }
      done[next] = true;
      order.push_back(next);
    }
  }

  /// The sentence about a circle of stimulations, among the members that wait for each other.
  std::string circle(const MemberNames& names, std::size_t member,
                     const std::vector<bool>& done) const {
    std::vector<std::size_t> way;  // against the links
    while (std::find(way.begin(), way.end(), member) == way.end()) {
      way.push_back(member);
      const auto stimulates = [&](const Wire& wire) {
        return wire.of == member && !done[wire.by] && !wire.inhibits;
      };
      member = std::find_if(wires.begin(), wires.end(), stimulates)->by;
    }
    std::string text = "'" + names[member] + "'";
    for (; way.back() != member; way.pop_back()) {
      text += " stimulates '" + names[way.back()] + "'";
    }
    return "the <stimulate> links go in a circle: " + text + " stimulates '" + names[member] +
           "', so none of them could ever begin; remove one of these links";
  }
};
