#include "factors.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>

#include "elsie/experiment/reader.h"
#include "elsie/experiment/split.h"
#include "elsie/world/tree.h"

#include "grid.h"

namespace elsie::experiment {

namespace {

using base::Problems;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

bool is_name(const std::string& text) {
  return !text.empty() && is_letter(text[0]) && std::all_of(text.begin(), text.end(), [](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '.';
  });
}

// The last name of a path: "max_speed" of "robot[r1]/@max_speed".
std::string end_of(const std::string& path) {
  std::string end = path.substr(path.rfind('/') + 1);
  end = end.substr(0, end.find('['));
  return end.starts_with('@') ? end.substr(1) : end;
}

// "<fusion_interval/>": fusion_interval
std::string name_of_element(const std::string& markup) {
  return markup.substr(1, markup.find_first_of(" />", 1) - 1);
}

// The reason why a value or an element does not fit the end of the path, as the end of a sentence;
// "" if it fits.
std::string why_not_at(const std::string& path, bool is_element, const std::string& value) {
  const bool to_attribute = path.substr(path.rfind('/') + 1).starts_with('@');
  return to_attribute && is_element
             ? "ends with an attribute, but an element is given; expected a value"
         : !to_attribute && !is_element && !value.starts_with('<')
             ? "leads to an element, but a value is given; expected an element, or an attribute at "
               "the end, as in robot[r1]/@max_speed"
             : "";
}

// Makes one factor. Problems have the line of its element or of the level's element.
class FactorMaker {
 public:
  FactorMaker(const FactorDraft& draft, Problems& problems) : draft_(draft), problems_(problems) {}

  Factor make() {
    Factor factor;
    factor.location = draft_.location;
    factor.name = draft_.name ? *draft_.name : draft_.path ? end_of(*draft_.path) : "";
    if (!is_name(factor.name)) {
      complain("<vary> lacks a name; expected name=\"...\", or a path at whose end there is one");
      return factor;
    }
    name_ = factor.name;
    const bool is_range = draft_.from || draft_.to || draft_.step;
    const int ways = (draft_.values ? 1 : 0) + (is_range ? 1 : 0) + (draft_.levels.empty() ? 0 : 1);
    if (ways != 1) {
      complain("the factor '" + name_ + "' " +
               (ways == 0 ? "has no levels" : "has its levels in more than one way") +
               "; expected values=\"A; B\", or from, to and step, or <level> elements");
      return factor;
    }
    if (draft_.levels.empty() && !draft_.path) {
      complain("the factor '" + name_ + "' lacks a path; expected the path that these values set");
      return factor;
    }
    if (is_range) {
      make_range(factor);
    } else if (draft_.values) {
      for (const std::string& value : split(*draft_.values, ';')) {
        if (const std::string why = why_not_at(*draft_.path, false, value); !why.empty()) {
          complain("the path of the factor '" + name_ + "' " + why);
        }
        add(factor, value, value, draft_.location);
      }
    } else {
      make_levels(factor);
    }
    check(factor);
    return factor;
  }

 private:
  void complain(const std::string& message) { problems_.add(draft_.location, message); }

  void add(Factor& factor, const std::string& label, const std::string& value,
           const Location& where) {
    factor.levels.push_back({label, {{*draft_.path, value, where}}, where});
  }

  void make_range(Factor& factor) {
    if (!draft_.from || !draft_.to || !draft_.step) {
      complain("the range of the factor '" + name_ +
               "' is not complete; expected from, to and step");
      return;
    }
    if (const std::string why = why_not_at(*draft_.path, false, ""); !why.empty()) {
      complain("the path of the factor '" + name_ + "' " + why);
    }
    try {
      for (const std::string& value : range(*draft_.from, *draft_.to, *draft_.step)) {
        add(factor, value, value, draft_.location);
      }
    } catch (const std::invalid_argument& error) {
      complain("the range of the factor '" + name_ + "': " + error.what());
    }
  }

  void make_levels(Factor& factor) {
    bool path_used = false;
    for (const LevelDraft& draft : draft_.levels) {
      Level& level = factor.levels.emplace_back();
      level.location = draft.location;
      level.label = draft.label     ? *draft.label
                    : draft.value   ? *draft.value
                    : draft.element ? name_of_element(*draft.element)
                                    : "";
      const auto& value = draft.element ? draft.element : draft.value;
      if (!draft.label && !value) {
        unnamed_.insert(&draft - draft_.levels.data());
        problems_.add(draft.location,
                      "<level> lacks a label; expected label=\"...\", or a value or an element to "
                      "be named after");
      } else if (draft.value && draft.element) {
        problems_.add(draft.location,
                      "<level> has a value and an element in it; one of them is for the path");
        path_used = true;
      } else if (value && !draft_.path) {
        problems_.add(draft.location, "this level of '" + name_ +
                                          "' has a value, but its <vary> has no path for it; "
                                          "expected <set> elements in it");
      } else if (value) {
        const std::string why = why_not_at(*draft_.path, draft.element.has_value(), *value);
        if (!why.empty()) {
          problems_.add(draft.location, "the path of the factor '" + name_ + "' " + why);
        }
        level.settings.push_back({*draft_.path, *value, draft.location});
        path_used = true;
      }
      const auto more = settings_from(draft.settings, draft.changes, problems_);
      level.settings.insert(level.settings.end(), more.begin(), more.end());
    }
    if (draft_.path && !path_used && world::end_of_path(*draft_.path) == std::string::npos) {
      complain("the path of the factor '" + name_ +
               "' is not used: none of its levels has a value or an element");
    }
  }

  void check(const Factor& factor) {
    if (draft_.path && world::end_of_path(*draft_.path) != std::string::npos) {
      complain("the path of the factor '" + name_ +
               "' holds a \"=\" outside brackets; expected what to vary only");
    }
    if (factor.levels.size() > kMostLevels) {
      complain("the factor '" + name_ + "' has " + std::to_string(factor.levels.size()) +
               " levels; a factor has at most " + std::to_string(kMostLevels));
    }
    std::map<std::string, const Level*> known;
    for (const Level& level : factor.levels) {
      const std::string why = why_no_label(level.label);
      if (unnamed_.contains(&level - factor.levels.data())) {
        continue;  // already reported
      }
      if (!why.empty()) {
        problems_.add(
            level.location,
            "'" + level.label + "' cannot be a level of '" + name_ + "': " + why +
                (draft_.values ? how_to_separate(factor) : "") +
                (draft_.values && !level.label.empty()
                     ? "; label it with <level label=\"...\" value=\"" + level.label + "\"/>"
                     : ""));
      } else if (!known.emplace(level.label, &level).second) {
        problems_.add(level.location,
                      "the factor '" + name_ + "' has two levels that are called '" + level.label +
                          "'" + (draft_.levels.empty() ? "" : "; give one of them another label"));
      }
    }
  }

  const FactorDraft& draft_;
  Problems& problems_;
  std::string name_;
  std::set<std::ptrdiff_t> unnamed_;  // levels, by index
};

}  // namespace

std::string why_no_label(const std::string& text) {
  return text.empty()                                        ? "a label may not be empty"
         : text != trimmed(text)                             ? "a label has no blanks around it"
         : text.find_first_of("\n\r\t") != std::string::npos ? "a label stands on one line"
         : text.find_first_of(",;|*") != std::string::npos   ? "a label is without , ; | and *"
                                                             : "";
}

std::string how_to_separate(const Factor& factor) {
  const bool is_one_for_several =
      factor.levels.size() == 1 && factor.levels[0].label.find_first_of(" ,") != std::string::npos;
  return is_one_for_several ? "; the levels of values are separated by ';'" : "";
}

std::vector<Setting> settings_from(const std::vector<SettingDraft>& drafts,
                                   const std::vector<AtDraft>& changes, Problems& problems) {
  std::vector<Setting> settings;
  for (const SettingDraft& draft : drafts) {
    if (draft.value && draft.element) {
      problems.add(draft.location,
                   "<set> has a value and an element in it; expected one of them: a value for an "
                   "attribute, an element for an element");
    } else if (!draft.value && !draft.element) {
      problems.add(draft.location,
                   "<set> lacks what to set; expected value=\"...\", or an element in it");
    } else if (world::end_of_path(draft.path) != std::string::npos) {
      problems.add(draft.location, "path=\"" + draft.path +
                                       "\" of <set>: a path holds no \"=\"; the value has an "
                                       "attribute of its own");
    } else if (const std::string why =
                   why_not_at(draft.path, draft.element.has_value(), draft.value.value_or(""));
               !why.empty()) {
      problems.add(draft.location, "path=\"" + draft.path + "\" of <set> " + why);
    } else {
      settings.push_back(
          {draft.path, draft.element ? *draft.element : *draft.value, draft.location});
    }
  }
  for (const AtDraft& at : changes) {
    for (Setting& setting : settings_from(at.settings, {}, problems)) {
      setting.at_s = at.time;
      settings.push_back(std::move(setting));
    }
  }
  return settings;
}

std::vector<Factor> factors_from(const std::vector<FactorDraft>& drafts, Problems& problems) {
  std::vector<Factor> factors;
  std::map<std::string, int> lines;
  for (const FactorDraft& draft : drafts) {
    Factor factor = FactorMaker(draft, problems).make();
    if (factor.name == kWorldFactor) {
      problems.add(draft.location,
                   "a factor cannot be called 'world': that is what the worlds are; give it "
                   "another name");
    } else if (const auto [known, is_new] = lines.emplace(factor.name, draft.location.line);
               !is_new && !factor.name.empty()) {
      problems.add(draft.location, "the factor on line " + std::to_string(known->second) +
                                       " is called '" + factor.name +
                                       "', too; give this one another name");
    }
    factors.push_back(std::move(factor));
  }
  return factors;
}

}  // namespace elsie::experiment
