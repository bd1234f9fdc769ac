#include "elsie/world/document.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "elsie/base/write_whole.h"
#include "elsie/world/error.h"
#include "elsie/world/escaped.h"
#include "elsie/world/markup.h"

#include "ids.h"
#include "path.h"
#include "tags.h"

namespace elsie::world {

namespace {

// An element in the text: its start tag, and its end tag, which is the same when it is empty.
struct ElementTags {
  Tag start;
  Tag end;
};

// By Element::number.
std::vector<ElementTags> elements_of(const std::vector<Tag>& tags) {
  std::vector<ElementTags> elements;
  std::vector<std::size_t> open;
  for (const Tag& tag : tags) {
    if (tag.kind == Tag::Kind::end) {
      elements[open.back()].end = tag;
      open.pop_back();
      continue;
    }
    if (tag.kind == Tag::Kind::start) {
      open.push_back(elements.size());
    }
    elements.push_back({tag, tag});
  }
  return elements;
}

struct Edit {
  Span span;
  std::string text;
};

std::string edited(std::string text, std::vector<Edit> edits) {
  std::sort(edits.begin(), edits.end(),
            [](const Edit& a, const Edit& b) { return a.span.begin > b.span.begin; });
  for (const Edit& edit : edits) {
    text.replace(edit.span.begin, edit.span.end - edit.span.begin, edit.text);
  }
  return text;
}

Element parse_with_ids(const std::string& text, const std::string& file) {
  Element root = parse_markup(text, file);
  complete_world_ids(root);
  return root;
}

// What `edit_of` makes of each element in the text that the path leads to; those that only the path
// takes for granted are not there to be edited.
template <class EditOf>
std::vector<Edit> edits_at(const std::string& text, const std::string& file, const Path& path,
                           EditOf edit_of) {
  Element root = parse_with_ids(text, file);
  const std::vector<ElementTags> elements = elements_of(scan_tags(text, file));
  std::vector<Edit> edits;
  for (const Element* element : select(root, path)) {
    if (element->number == Element::kMade) {
      continue;
    }
    if (std::optional<Edit> edit = edit_of(elements[element->number])) {
      edits.push_back(std::move(*edit));
    }
  }
  return edits;
}

const Element& select_one(Element& root, const Path& path, std::string_view in_words) {
  const std::vector<Element*> elements = select(root, path);
  if (elements.size() != 1) {
    throw std::invalid_argument("the path '" + std::string(in_words) +
                                "' leads to more than one element");
  }
  return *elements.front();
}

Path attribute_path(std::string_view text) {
  Path path = parse_path(text);
  if (path.attribute.empty()) {
    throw std::invalid_argument("the path '" + std::string(text) +
                                "' leads to an element; expected an attribute at its end");
  }
  return path;
}

Path element_path(std::string_view text) {
  Path path = text.empty() ? Path{} : parse_path(text);
  if (!path.attribute.empty()) {
    throw std::invalid_argument("the path '" + std::string(text) +
                                "' leads to an attribute; expected an element at its end");
  }
  return path;
}

const Element* parent_of(const Element& root, const Element& element) {
  for (const Element& child : root.children) {
    if (&child == &element) {
      return &root;
    }
    if (const Element* found = parent_of(child, element)) {
      return found;
    }
  }
  return nullptr;
}

const TagAttribute* attribute_of(const Tag& tag, const std::string& name) {
  const auto found = std::find_if(tag.attributes.begin(), tag.attributes.end(),
                                  [&](const TagAttribute& a) { return a.name == name; });
  return found == tag.attributes.end() ? nullptr : &*found;
}

std::size_t line_start(const std::string& text, std::size_t place) {
  const std::size_t newline = place == 0 ? std::string::npos : text.rfind('\n', place - 1);
  return newline == std::string::npos ? 0 : newline + 1;
}

// The blanks that the line begins with.
std::string indent_at(const std::string& text, std::size_t place) {
  const std::size_t begin = line_start(text, place);
  const std::size_t end = std::min(text.find_first_not_of(" \t", begin), text.size());
  return text.substr(begin, std::min(end, place) - begin);
}

bool is_blank_before(const std::string& text, std::size_t place) {
  return line_start(text, place) + indent_at(text, place).size() == place;
}

std::string indented(std::string_view markup, const std::string& indent) {
  std::string result = indent;
  for (const char c : markup) {
    result += c;
    if (c == '\n') {
      result += indent;
    }
  }
  return result;
}

}  // namespace

Document::Document(std::string text, std::string file)
    : text_(std::move(text)), file_(std::move(file)) {
  parse_markup(text_, file_);
}

Document Document::load(const std::string& file) { return {read_text(file), file}; }

std::optional<std::string> Document::attribute(std::string_view path) const {
  const Path parsed = attribute_path(path);
  Element root = parse_with_ids(text_, file_);
  const Attribute* found = select_one(root, parsed, path).find(parsed.attribute);
  return found ? std::optional(found->value) : std::nullopt;
}

void Document::set(std::string_view path, std::string_view value) {
  const Path parsed = attribute_path(path);
  Document changed = *this;
  changed.add_missing(parsed);
  const std::string quoted = "\"" + escaped_attribute(value) + "\"";
  const auto with_value = [&](const ElementTags& element) {
    const Tag& tag = element.start;
    if (const TagAttribute* there = attribute_of(tag, parsed.attribute)) {
      return std::optional(Edit{{there->value.begin - 1, there->value.end + 1}, quoted});
    }
    const std::size_t end = tag.attributes.empty() ? tag.span.begin + 1 + tag.name.size()
                                                   : tag.attributes.back().whole.end;
    return std::optional(Edit{{end, end}, " " + parsed.attribute + "=" + quoted});
  };
  replace(edited(changed.text_, edits_at(changed.text_, file_, parsed, with_value)));
}

void Document::reset(std::string_view path) {
  const Path parsed = attribute_path(path);
  const auto without = [&](const ElementTags& element) {
    const TagAttribute* there = attribute_of(element.start, parsed.attribute);
    return there ? std::optional(Edit{there->whole, ""}) : std::nullopt;
  };
  replace(edited(text_, edits_at(text_, file_, parsed, without)));
}

void Document::insert(std::string_view path, std::string_view markup) {
  const Path parsed = element_path(path);
  Document changed = *this;
  changed.add_missing(parsed);
  Element root = parse_with_ids(changed.text_, file_);
  changed.insert_into(select_one(root, parsed, path), markup);
  *this = std::move(changed);
}

void Document::erase(std::string_view path) {
  const Path parsed = element_path(path);
  const auto without = [&](const ElementTags& element) {
    Span span{element.start.span.begin, element.end.span.end};
    const std::size_t next = text_.find_first_not_of(" \t\r", span.end);
    if (is_blank_before(text_, span.begin) && next != std::string::npos && text_[next] == '\n') {
      span = {line_start(text_, span.begin), next + 1};
    }
    return std::optional(Edit{span, ""});
  };
  replace(edited(text_, edits_at(text_, file_, parsed, without)));
}

void Document::save(const std::string& file) const {
  if (const int error = base::write_whole(file, text_); error != 0) {
    throw WorldError(
        {{file, 0, "the file cannot be written: " + std::generic_category().message(error)}});
  }
}

// Adds the elements on the way that the path may take for granted.
void Document::add_missing(const Path& path) {
  while (true) {
    Element root = parse_with_ids(text_, file_);
    const std::vector<Element*> elements = select(root, path);
    const auto made = std::find_if(elements.begin(), elements.end(), [](const Element* element) {
      return element->number == Element::kMade;
    });
    if (made == elements.end()) {
      return;
    }
    const Element* missing = *made;
    const Element* parent = parent_of(root, *missing);
    while (parent->number == Element::kMade) {
      missing = parent;
      parent = parent_of(root, *missing);
    }
    insert_into(*parent, "<" + missing->name + "/>");
  }
}

void Document::insert_into(const Element& parent, std::string_view markup) {
  const auto tags = elements_of(scan_tags(text_, file_));
  const ElementTags& both = tags[parent.number];
  const std::string outer = indent_at(text_, both.start.span.begin);
  const std::string lines = indented(markup, outer + "  ") + "\n";
  Edit edit;
  if (both.start.kind == Tag::Kind::empty) {
    const std::size_t end = both.start.span.end;
    edit = {{end - 2, end}, ">\n" + lines + outer + "</" + parent.name + ">"};
  } else if (const std::size_t end = both.end.span.begin; is_blank_before(text_, end)) {
    edit = {{line_start(text_, end), line_start(text_, end)}, lines};
  } else {
    edit = {{end, end}, "\n" + lines + outer};
  }
  replace(edited(text_, {edit}));
}

void Document::replace(std::string text) {
  try {
    parse_markup(text, file_);
  } catch (const WorldError& error) {
    throw std::invalid_argument("this change would not leave well-formed XML: " +
                                error.problems().front().message);
  }
  text_ = std::move(text);
}

}  // namespace elsie::world
