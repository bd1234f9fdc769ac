#include "elsie/editing/document.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>
#include <utility>

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
#include "own_text.h"
#include "rewriting.h"

namespace elsie::editing {

using world::Concern;
using world::Files;
using world::Problems;
using world::ReadOptions;
using world::World;
using world::WorldError;

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const std::string& edit, const std::string& message) {
  throw WorldError({{"--set " + edit, 0, message}});
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

// Whether a text says what it should: all but names by position that nothing uses.
bool says(const Element& found, const Element& wanted) {
  const auto has = [](const Element& element, const Attribute& attribute) {
    const Attribute* const other = element.find(attribute.name);
    return other && (other->value == attribute.value ||
                     (attribute.name == "id" && attribute.completed && other->completed));
  };
  return found.name == wanted.name && found.text == wanted.text &&
         found.attributes.size() == wanted.attributes.size() &&
         std::all_of(found.attributes.begin(), found.attributes.end(),
                     [&](const Attribute& each) { return has(wanted, each); }) &&
         std::equal(found.children.begin(), found.children.end(), wanted.children.begin(),
                    wanted.children.end(), says);
}

}  // namespace

struct Document::State {
  std::string text;
  std::vector<ElementSpan> spans;
  Trees trees;
  World world;

  bool has(const Element& element) const {
    return element.object && *element.object < spans.size();
  }
};

class Document::Impl {
 public:
  Impl(std::string text, std::string file, const plugin::Host& host, ReadOptions options)
      : file_(std::move(file)),
        host_(host),
        options_(std::move(options)),
        files_(file_, options_.data_directories, file_, options_.files) {
    options_.edits.clear();
    now_ = with_world(read(std::move(text)));
  }

  void apply(const std::vector<std::string>& edits, Names names);
  void become(std::string text) { now_ = with_world(read(std::move(text))); }

  std::string text_for(const std::string& folder) const;

  const std::string& file() const { return file_; }
  const std::string& text() const { return now_.text; }
  const World& world() const { return now_.world; }
  const Element& tree() const { return now_.trees.merged; }
  const Element* written(const Element& element) const {
    return now_.has(element) ? element_of(now_.trees.raw, *element.object) : nullptr;
  }

 private:
  /// All of a text but its world.
  State read(std::string text) const {
    State result;
    result.text = std::move(text);
    Trees& trees = result.trees;
    trees.raw = world::tree_of_world(result.text, file_, &result.spans);
    trees.merged = trees.raw;
    Problems problems;
    world::merge_templates(trees.merged, host_, files_, problems);
    problems.raise<WorldError>(file_);
    put_in_order(trees.raw);
    put_in_order(trees.merged);
    std::size_t count = result.spans.size();
    world::for_each_element(trees.merged, [&](Element& element) {
      if (!element.object) {
        element.object = count++;
      }
    });
    return result;
  }

  World world_of(Element merged) const {
    Problems problems;
    return world::world_of_tree(std::move(merged), file_, host_, files_, options_, problems);
  }
  State with_world(State state) const {
    state.world = world_of(state.trees.merged);
    return state;
  }

  /// The field of the attribute at the end of a path; none if this world has no such attribute.
  std::optional<Field> field_at(const std::string& path) const {
    try {
      return world::Attributes(now_.world, host_, options_.data_directories)
          .find(path)
          .front()
          .field;
    } catch (const std::invalid_argument&) {
      return std::nullopt;
    }
  }
  /// The text after an edit; `wanted` receives the tree that it must have.
  State edited(const State& from, const std::string& edit, Names names, Element& wanted) const;
  /// The layout that has drawn what an edit is about; null if there is none.
  const Element* layout_of(const Element& tree, const std::string& edit) const;

  std::string file_;
  const plugin::Host& host_;
  ReadOptions options_;
  Files files_;
  State now_;
};

// The world is checked only after the last edit.
void Document::Impl::apply(const std::vector<std::string>& edits, Names names) {
  State next = now_;
  Element wanted;  // the tree after the last edit
  for (const std::string& edit : edits) {
    next = edited(next, edit, names, wanted);
  }
  try {
    now_ = with_world(std::move(next));
  } catch (const WorldError&) {
    if (edits.size() == 1) {  // with the edit as the place of its mistakes
      Problems problems;
      if (world::concern_of(edits.front()) != Concern::other) {
        world::merge_templates(wanted, host_, files_, problems);
      }
      world::world_of_tree(std::move(wanted), file_, host_, files_, options_, problems);
    }
    throw;
  }
}

// The layout that draws what the edit changes; null if none does.
const Element* Document::Impl::layout_of(const Element& tree, const std::string& edit) const {
  Element drawn = tree;
  std::optional<world::Drawn> seed;
  Problems problems;
  world::draw_layouts(drawn, file_, host_, files_, options_, seed, problems);
  world::apply_edit(drawn, edit, options_.is_running, problems);
  return problems.empty() ? layout_that_made_edited(tree, drawn, edit) : nullptr;
}

Document::State Document::Impl::edited(const State& from, const std::string& edit, Names names,
                                       Element& wanted) const {
  const bool is_raw = world::concern_of(edit) != Concern::other;
  const Element& before = is_raw ? from.trees.raw : from.trees.merged;
  wanted = before;
  Problems problems;
  world::apply_edit(wanted, edit, options_.is_running, problems);
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
  Element raw = is_raw ? wanted : OwnText(host_, files_, "--set " + edit).of(from.trees, wanted);
  give_ids(raw, names);
  State next = read(rewritten(from.text, from.spans, from.trees.raw, raw));
  if (!says(is_raw ? next.trees.raw : next.trees.merged, wanted)) {
    refuse(edit,
           "a file cannot express this: the robot has other elements from its template, which come "
           "first and cannot be replaced by new ones with their ids; remove one and add another");
  }
  return next;
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
void Document::apply(const std::vector<std::string>& edits, Names names) {
  impl_->apply(edits, names);
}
void Document::become(std::string text) { impl_->become(std::move(text)); }
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
  visit(now_.trees.raw, Meaning::of_world());
  return spliced(now_.text, std::move(splices));
}

}  // namespace elsie::editing
