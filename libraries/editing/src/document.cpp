#include "elsie/editing/document.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <utility>

#include "elsie/editing/between.h"
#include "elsie/plugin/host.h"
#include "elsie/world/attributes.h"
#include "elsie/world/data_directories.h"
#include "elsie/world/error.h"
#include "elsie/world/files.h"
#include "elsie/world/layouts.h"
#include "elsie/world/tree.h"
#include "elsie/world/values.h"

#include "drawn.h"
#include "meaning.h"
#include "rewriting.h"
#include "undo.h"

namespace elsie::editing {

using world::Concern;
using world::Files;
using world::Problems;
using world::ReadOptions;
using world::World;
using world::WorldError;

namespace fs = std::filesystem;

namespace {

constexpr int kMostAttempts = 8;

[[noreturn]] void refuse(const std::string& edit, const std::string& message) {
  throw WorldError({{"--set " + edit, 0, message}});
}

// Sorts elements that may occur only once in the order of the vocabulary; files may have any order.
void put_in_order(Element& element, const ElementSpec& spec = world::vocabulary()) {
  const bool of_plugins = spec.group && spec.children.front().plugins;
  const auto& below = spec.below();
  const auto rank = [&](const Element& child) {
    return std::find_if(below.begin(), below.end(),
                        [&](const ElementSpec& each) { return each.name == child.name; });
  };
  if (!spec.group) {
    std::stable_sort(element.children.begin(), element.children.end(),
                     [&](const Element& a, const Element& b) { return rank(a) < rank(b); });
  }
  for (Element& child : element.children) {
    const auto known = of_plugins ? below.begin() : rank(child);
    if (known != below.end()) {
      put_in_order(child, *known);
    }
  }
}

// The element with that number; null if there is none. Elements are numbered in the order of their
// start tags in the text.
const Element* element_of(const Element& tree, std::size_t object) {
  const Element* found = tree.object <= object ? &tree : nullptr;
  while (found && found->object != object) {
    const Element* next = nullptr;
    for (const Element& child : found->children) {
      if (child.object <= object && (!next || child.object > next->object)) next = &child;
    }
    found = next;
  }
  return found;
}

// Compares an edited tree with the tree that was read from its text.
class Comparison {
 public:
  Comparison(Element& wanted, Additions& additions, const std::string& edit,
             const plugin::Host& host)
      : additions_(additions), edit_(edit), host_(host) {
    // Texts that may refer to a name, and other elements with that name.
    world::for_each_element(wanted, [&](const Element& element) {
      for (const Attribute& attribute : element.attributes) {
        if (!attribute.completed) {
          used_.insert(attribute.value);
        }
      }
    });
  }

  // If they differ, notes what else the text must contain: in the additions, or as attributes of
  // `wanted` (defaults that override a template).
  bool equal(Element& wanted, const Element& found) {
    misnamed_.clear();
    if (!equal(wanted, found, Meaning::of_world())) {
      return false;
    }
    additions_.ids.insert(misnamed_.begin(), misnamed_.end());
    return misnamed_.empty();
  }

 private:
  bool equal(Element& wanted, const Element& found, const Meaning& meaning) {
    bool same = wanted.name == found.name && wanted.text == found.text;
    for (const Attribute& attribute : wanted.attributes) {
      const Attribute* other = found.find(attribute.name);
      if (other && other->value == attribute.value) {
        continue;
      }
      if (attribute.name != "id" || !attribute.completed) {
        same = false;
      } else if (!other || !other->completed || used_.contains(attribute.value)) {
        additions_.ids.insert(&wanted);
        same = false;
      } else if (used_.contains(other->value)) {
        misnamed_.push_back(&wanted);
      }
    }
    for (const Attribute& attribute : found.attributes) {
      if (!wanted.find(attribute.name)) {
        same = false;
        set_default(wanted, attribute.name, meaning);
      }
    }
    return equal_children(wanted, found, meaning) && same;
  }

  bool equal_children(Element& wanted, const Element& found, const Meaning& meaning) {
    const std::size_t size = wanted.children.size();
    if (size == found.children.size()) {
      bool same = true;
      for (std::size_t i = 0; i < size; ++i) {
        Element& child = wanted.children[i];
        if (are_one(child, found.children[i])) {
          same &= equal(child, found.children[i], meaning.child(child, host_));
          continue;
        }
        same = false;
        note_place(child);
      }
      return same;
    }
    const auto is_wanted = [&](const Element& other) {
      return std::any_of(wanted.children.begin(), wanted.children.end(), [&](const Element& child) {
        return child.name == other.name && child.value("id") == other.value("id");
      });
    };
    for (const Element& child : found.children) {
      if (size < found.children.size() && child.find("id") && !is_wanted(child)) {
        additions_.removals[&wanted].push_back(child);
      }
    }
    for (const Element& child : wanted.children) {
      note_place(child);
    }
    return false;
  }

  // Whether they may be the same element with another position, and so another default name.
  static bool are_one(const Element& a, const Element& b) {
    const Attribute* const first = a.find("id");
    const Attribute* const second = b.find("id");
    return a.name == b.name && (!first || !second || first->value == second->value ||
                                (first->completed && second->completed));
  }

  // Notes that the element must be at another place.
  void note_place(const Element& element) {
    const Attribute* id = element.find("id");
    if (id && id->completed) {
      additions_.ids.insert(&element);
    }
    if (!element.object) {
      additions_.in_place.insert(&element);
    }
  }

  // The template's value applies if the robot's own element does not have the attribute.
  void set_default(Element& wanted, const std::string& attribute, const Meaning& meaning) {
    const auto field = meaning.field(attribute);
    if (!field || !field->default_value) {
      refuse(edit_, "<" + wanted.name + "> has its '" + attribute +
                        "' from the robot's template, and a file cannot restore its default; give "
                        "it a value instead");
    }
    wanted.set(attribute, world::format_value(*field->default_value), {edit_, 0});
  }

  Additions& additions_;
  const std::string& edit_;
  const plugin::Host& host_;
  std::set<std::string> used_;
  std::vector<const Element*> misnamed_;  // elements whose name refers to another element
};

// The single piece in which two texts differ, as it is in `from`.
Splice difference(const std::string& from, const std::string& to) {
  const std::size_t most = std::min(from.size(), to.size());
  std::size_t begin = 0;
  while (begin < most && from[begin] == to[begin]) {
    ++begin;
  }
  std::size_t end = 0;
  while (end < most - begin && from[from.size() - 1 - end] == to[to.size() - 1 - end]) {
    ++end;
  }
  return {begin, to.size() - end, from.substr(begin, from.size() - begin - end)};
}

}  // namespace

struct Edits::Restored {
  Splice splice;
  std::size_t hash = 0;  // of the text that it applies to
  std::vector<std::string> inverse;
};

class Document::Impl {
 public:
  Impl(std::string text, std::string file, const plugin::Host& host, ReadOptions options)
      : file_(std::move(file)),
        host_(host),
        options_(std::move(options)),
        files_(file_, options_.data_directories, file_, options_.files) {
    options_.overrides.clear();
    take(read(std::move(text)));
  }

  Edits apply(const Edits& edits) {
    const std::string old = now_.text;
    Edits inverse;
    if (edits.restored_ && edits.restored_->hash == std::hash<std::string>()(old)) {
      take(read(spliced(old, {edits.restored_->splice})));
      inverse.texts_ = edits.restored_->inverse;
    } else if (edits.restored_ && edits.texts_.empty()) {
      throw WorldError({{file_, 0, "this edit can be undone only in the text that it has made"}});
    } else {
      inverse.texts_ = apply_texts(edits.texts_);
    }
    inverse.restored_ = std::make_shared<Edits::Restored>(Edits::Restored{
        difference(old, now_.text), std::hash<std::string>()(now_.text), edits.texts_});
    return inverse;
  }

  Edits become(std::string text) {
    const World& before = world_;
    WorldText next = read(std::move(text));
    World world = world_of(next.merged);
    Edits inverse;
    inverse.texts_ = edits_from(world, before);
    inverse.restored_ = std::make_shared<Edits::Restored>(
        Edits::Restored{difference(now_.text, next.text), std::hash<std::string>()(next.text),
                        edits_from(before, world)});
    now_ = std::move(next);
    world_ = std::move(world);
    return inverse;
  }

  std::string text_for(const std::string& folder) const;

  const std::string& file() const { return file_; }
  const std::string& text() const { return now_.text; }
  const World& world() const { return world_; }
  const Element& tree() const { return now_.merged; }
  const Element* written(const Element& element) const {
    return now_.has(element) ? element_of(now_.raw, *element.object) : nullptr;
  }

 private:
  WorldText read(std::string text) const {
    WorldText result;
    result.text = std::move(text);
    result.raw = world::tree_of_world(result.text, file_, &result.spans);
    result.merged = result.raw;
    Problems problems;
    world::merge_templates(result.merged, host_, files_, problems);
    problems.raise<WorldError>(file_);
    put_in_order(result.raw);
    put_in_order(result.merged);
    std::size_t count = result.spans.size();
    world::for_each_element(result.merged, [&](Element& element) {
      if (!element.object) {
        element.object = count++;
      }
    });
    return result;
  }

  World world_of(const Element& merged) const {
    Problems problems;
    return world::world_of_tree(merged, file_, host_, files_, options_, problems);
  }

  void take(WorldText text) {
    world_ = world_of(text.merged);
    now_ = std::move(text);
  }

  std::vector<std::string> apply_texts(const std::vector<std::string>& edits);
  /// The edits from one world to another. If they are empty, only the text itself can be restored.
  std::vector<std::string> edits_from(const World& from, const World& to) const {
    try {
      return edits_between(from, to, host_, options_);
    } catch (const WorldError&) {
      return {};
    }
  }
  /// The field of the attribute at the end of a path; none if this world has no such attribute.
  std::optional<Field> field_at(const std::string& path) const {
    try {
      return world::Attributes(world_, host_, options_.data_directories).find(path).front().field;
    } catch (const std::invalid_argument&) {
      return std::nullopt;
    }
  }
  WorldText edited(const WorldText& from, const std::string& edit, Element& wanted,
                   std::vector<std::string>& inverse) const;
  /// The layout that has drawn what an edit is about; null if there is none.
  const Element* layout_of(const Element& tree, const std::string& edit) const;

  std::string file_;
  const plugin::Host& host_;
  ReadOptions options_;
  Files files_;
  WorldText now_;
  World world_;
};

// Makes each edit in the text; the world is checked only at the end.
std::vector<std::string> Document::Impl::apply_texts(const std::vector<std::string>& edits) {
  WorldText text = now_;
  std::vector<std::string> inverse;
  Element wanted;  // the tree after the last edit
  for (const std::string& edit : edits) {
    text = edited(text, edit, wanted, inverse);
  }
  try {
    take(std::move(text));
  } catch (const WorldError&) {
    if (edits.size() == 1) {
      Problems problems;
      Element merged = wanted;
      if (world::concern_of(edits.front()) != Concern::other) {
        world::merge_templates(merged, host_, files_, problems);
      }
      world::world_of_tree(std::move(merged), file_, host_, files_, options_, problems);
    }
    throw;
  }
  return inverse;
}

// The layout that draws what the edit changes; null if none does.
const Element* Document::Impl::layout_of(const Element& tree, const std::string& edit) const {
  Element drawn = tree;
  std::optional<world::Drawn> seed;
  Problems problems;
  world::draw_layouts(drawn, file_, host_, files_, options_, seed, problems);
  world::apply_override(drawn, edit, options_.is_running, problems);
  return problems.empty() ? layout_that_made_edited(tree, drawn, edit) : nullptr;
}

WorldText Document::Impl::edited(const WorldText& from, const std::string& edit, Element& wanted,
                                 std::vector<std::string>& inverse) const {
  const bool is_raw = world::concern_of(edit) != Concern::other;
  const Element& before = is_raw ? from.raw : from.merged;
  wanted = before;
  Problems problems;
  world::apply_override(wanted, edit, options_.is_running, problems);
  Element tree = wanted;  // looking for a path may add elements
  if (const Element* layout =
          problems.empty() ? layout_that_draws(tree, edit) : layout_of(before, edit)) {
    refuse(edit, "the layout '" + layout->value("id") +
                     "' draws this, another one from each seed; edit what " + layout->name + "[" +
                     layout->value("id") + "] says instead");
  }
  problems.raise<WorldError>(file_);
  world::remove_overridden(wanted);
  put_in_order(wanted);
  Additions additions;
  Comparison comparison(wanted, additions, edit, host_);
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    WorldText text = read(rewritten(from, before, wanted, additions, host_));
    const Element& found = is_raw ? text.raw : text.merged;
    if (comparison.equal(wanted, found)) {
      const auto steps = undoing(before, wanted, found, host_);
      inverse.insert(inverse.begin(), steps.begin(), steps.end());
      return text;
    }
  }
  refuse(edit,
         "a file cannot express this: the robot has other elements from its template, which come "
         "first and cannot be replaced by new ones with their ids; remove one and add another");
}

Document::Document(std::string text, std::string file, const plugin::Host& host,
                   ReadOptions options)
    : impl_(std::make_unique<Impl>(std::move(text), std::move(file), host, std::move(options))) {}
Document::Document(Document&&) noexcept = default;
Document& Document::operator=(Document&&) noexcept = default;
Document::~Document() = default;

Document Document::open(const std::string& file, const plugin::Host& host, ReadOptions options) {
  const std::string found = world::find_document(file, options.data_directories);
  return {world::read_text(found), found, host, std::move(options)};
}

const std::string& Document::file() const { return impl_->file(); }
const std::string& Document::text() const { return impl_->text(); }
const World& Document::world() const { return impl_->world(); }
const Element& Document::tree() const { return impl_->tree(); }
const Element* Document::written(const Element& element) const { return impl_->written(element); }
Edits Document::apply(const Edits& edits) { return impl_->apply(edits); }
Edits Document::become(std::string text) { return impl_->become(std::move(text)); }
std::string Document::text_for(const std::string& folder) const { return impl_->text_for(folder); }

// Replaces names of files, so that they lead to the same files from the other folder.
std::string Document::Impl::text_for(const std::string& folder) const {
  std::error_code error;
  if (!fs::is_directory(folder.empty() ? "." : folder, error)) {
    throw WorldError({{folder, 0, "there is no such folder; a world is saved in one that exists"}});
  }
  const std::string elsewhere = (fs::path(folder) / fs::path(file_).filename()).string();
  const Files there(elsewhere, options_.data_directories, elsewhere, {});
  // The new name of the file that an attribute names; none if it does not name a file.
  const auto renamed = [&](const Element& element, const std::string& name,
                           const Meaning& meaning) -> std::optional<std::string> {
    const auto field = element.name == "change" && name == "value" ? field_at(element.value("path"))
                                                                   : meaning.field(name);
    const bool is_schema = name == "xsi:noNamespaceSchemaLocation";
    const std::string value = element.value(name);
    if (value.empty() || !(is_schema || (field && field->type == ParameterType::file))) {
      return std::nullopt;
    }
    const auto file = files_.find(value, element.where);
    if (!file) {
      return std::nullopt;  // a schema that does not exist
    }
    return is_schema ? fs::path(Files::absolute(*file))
                           .lexically_relative(Files::absolute(folder.empty() ? "." : folder))
                           .generic_string()
                     : there.name_for_world(*file, value);
  };
  const std::function<void(Element&, const Meaning&)> rename = [&](Element& element,
                                                                   const Meaning& meaning) {
    for (Attribute& attribute : element.attributes) {
      attribute.value = renamed(element, attribute.name, meaning).value_or(attribute.value);
    }
    for (Element& child : element.children) {
      rename(child, meaning.child(child, host_));
    }
  };
  std::vector<Splice> splices;
  const std::function<void(const Element&, const Meaning&)> visit = [&](const Element& element,
                                                                        const Meaning& meaning) {
    for (const auto& span : now_.has(element) ? now_.spans[*element.object].attributes
                                              : std::vector<ElementSpan::Attribute>()) {
      const std::string name = now_.text.substr(span.begin, span.name_end - span.begin);
      const std::string value = element.value(name);
      auto other = renamed(element, name, meaning);
      if (element.name == "change" && name == "value" && value.starts_with('<')) {
        Element given = world::parse_markup(value, file_);
        rename(given, Meaning::of_name(given.name, host_));
        other = markup_of(given);
      }
      if (other && *other != value) {
        splices.push_back(
            {span.value, span.end - 1, quoted_value(*other, now_.text[span.value - 1])});
      }
    }
    for (const Element& child : element.children) {
      visit(child, element.name == "change" ? Meaning::of_name(child.name, host_)
                                            : meaning.child(child, host_));
    }
  };
  visit(now_.raw, Meaning::of_world());
  return spliced(now_.text, std::move(splices));
}

}  // namespace elsie::editing
