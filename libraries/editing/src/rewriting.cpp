#include "rewriting.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "elsie/world/escaped.h"

namespace elsie::editing {

namespace {

constexpr std::string_view kBlanks = " \t\r";

// Lines and indentation of a text.
class Layout {
 public:
  explicit Layout(std::string_view text)
      : text_(text), line_end_(text.find("\r\n") == text.npos ? "\n" : "\r\n") {}

  const std::string& line_end() const { return line_end_; }

  std::size_t line_start(std::size_t place) const {
    const std::size_t end = place == 0 ? text_.npos : text_.rfind('\n', place - 1);
    return end == text_.npos ? 0 : end + 1;
  }
  bool begins_line(std::size_t place) const {
    const std::size_t start = line_start(place);
    return start > 0 && text_.substr(start, place - start).find_first_not_of(kBlanks) == text_.npos;
  }
  // The indentation of the line of a place.
  std::string indent(std::size_t place) const {
    const std::size_t start = line_start(place);
    const std::size_t end = std::min(text_.find_first_not_of(" \t", start), place);
    return std::string(text_.substr(start, end - start));
  }
  // The place after the comments that end the line of a place, or the place itself.
  std::size_t after_comments(std::size_t place) const {
    std::size_t end = place;
    for (std::size_t at = place;;) {
      at = std::min(text_.find_first_not_of(kBlanks, at), text_.size());
      if (at == text_.size() || text_[at] == '\n') {
        return end;
      }
      const std::size_t close =
          text_.substr(at).starts_with("<!--") ? text_.find("-->", at) : text_.npos;
      if (close == text_.npos || text_.substr(at, close - at).find('\n') != text_.npos) {
        return place;
      }
      end = at = close + 3;
    }
  }
  // Removes an element with its line if it is alone there, else with the blanks before it.
  Splice removal(const ElementSpan& span) const {
    const std::size_t next = text_.find_first_not_of(kBlanks, span.end);
    if (!begins_line(span.begin)) {
      const std::size_t last = text_.find_last_not_of(kBlanks, span.begin - 1);
      return {last == text_.npos ? 0 : last + 1, span.end, ""};
    }
    return next != text_.npos && text_[next] == '\n'
               ? Splice{line_start(span.begin), next + 1, ""}
               : Splice{span.begin, std::min(next, text_.size()), ""};
  }

 private:
  std::string_view text_;
  std::string line_end_;
};

class Rewriting {
 public:
  Rewriting(std::string_view text, const std::vector<ElementSpan>& spans)
      : text_(text), spans_(spans), layout_(text) {}

  void change(const Element& before, const Element& after) {
    change_attributes(*before.object, before, after);
    change_children(*before.object, before, after);
  }

  std::string result() {
    for (const auto& [holder, elements] : filled_) {
      fill(holder, elements);
    }
    return spliced(text_, std::move(splices_));
  }

 private:
  const ElementSpan& span(std::size_t element) const { return spans_[element]; }
  std::string_view piece(std::size_t begin, std::size_t end) const {
    return text_.substr(begin, end - begin);
  }
  const ElementSpan::Attribute* given(std::size_t element, const std::string& name) const {
    for (const auto& attribute : span(element).attributes) {
      if (piece(attribute.begin, attribute.name_end) == name) {
        return &attribute;
      }
    }
    return nullptr;
  }

  void change_attributes(std::size_t self, const Element& before, const Element& after) {
    for (const Attribute& attribute : after.attributes) {
      const Attribute* old = before.find(attribute.name);
      if (!attribute.completed && !(old && !old->completed && old->value == attribute.value)) {
        set(self, attribute);
      }
    }
    for (const Attribute& attribute : before.attributes) {
      const Attribute* now = after.find(attribute.name);
      if (!now || now->completed) {
        remove(self, attribute.name);
      }
    }
  }

  void set(std::size_t self, const Attribute& attribute) {
    if (const auto* known = given(self, attribute.name)) {
      splices_.push_back(
          {known->value, known->end - 1, quoted_value(attribute.value, text_[known->value - 1])});
      return;
    }
    const auto& attributes = span(self).attributes;
    const std::size_t at = attributes.empty() ? span(self).name_end : attributes.back().end;
    const bool own_line = !attributes.empty() && layout_.begins_line(attributes.back().begin);
    splices_.push_back(
        {at, at,
         (own_line ? layout_.line_end() + layout_.indent(attributes.back().begin) : " ") +
             attribute.name + "=\"" + quoted_value(attribute.value, '"') + "\""});
  }

  void remove(std::size_t self, const std::string& name) {
    if (const auto* known = given(self, name)) {
      const bool is_first = known == &span(self).attributes.front();
      splices_.push_back({is_first ? span(self).name_end : (known - 1)->end, known->end, ""});
    }
  }

  void change_children(std::size_t self, const Element& before, const Element& after) {
    std::set<std::size_t> kept;
    for (const Element& child : after.children) {
      if (child.object) {
        kept.insert(*child.object);
      }
    }
    std::optional<std::size_t> last;  // the previous element in the text
    auto old = before.children.begin();
    const auto is_gone = [&] {
      return old != before.children.end() && !kept.contains(*old->object);
    };
    const auto take_away = [&] { splices_.push_back(layout_.removal(span(*(old++)->object))); };
    for (const Element& child : after.children) {
      if (child.object) {
        while (is_gone()) {
          take_away();
        }
        last = *child.object;
        change(*old++, child);
      } else if (is_gone()) {
        last = *old->object;
        replace(*(old++)->object, child);
      } else {
        insert(self, last, child);
      }
    }
    while (is_gone()) {
      take_away();
    }
  }

  std::string lines(const Element& element, const std::string& indent,
                    const std::string& step) const {
    Element shown = element;
    std::erase_if(shown.attributes, [](const Attribute& each) { return each.completed; });
    std::string text = start_tag(shown);
    if (element.children.empty() && element.text.empty()) {
      return text + "/>";
    }
    text += ">" + world::escaped(element.text);
    for (const Element& child : element.children) {
      text += layout_.line_end() + indent + step + lines(child, indent + step, step);
    }
    return text + layout_.line_end() + indent + "</" + element.name + ">";
  }

  // The additional indentation of an element inside its parent.
  std::string step_below(std::size_t holder) const {
    const std::size_t parent = span(holder).parent;
    const std::string inner = layout_.indent(span(holder).begin);
    const std::string outer =
        parent == ElementSpan::kNone ? "" : layout_.indent(span(parent).begin);
    return inner.size() > outer.size() && inner.starts_with(outer) ? inner.substr(outer.size())
                                                                   : "  ";
  }

  void replace(std::size_t self, const Element& element) {
    splices_.push_back(
        {span(self).begin, span(self).end,
         lines(element, layout_.indent(span(self).begin), step_below(span(self).parent))});
  }

  // Inserts an element behind `last`, a child of the holder in the text, or before all children.
  void insert(std::size_t holder, std::optional<std::size_t> last, const Element& element) {
    const std::size_t first = holder + 1;
    const bool is_filled = first < spans_.size() && span(first).parent == holder;
    if (!last && !is_filled) {
      filled_[holder].push_back(element);
      return;
    }
    const std::size_t neighbour = last.value_or(first);
    const bool own_line = layout_.begins_line(span(neighbour).begin);
    const std::string indent = layout_.indent(span(neighbour).begin);
    std::size_t at = last       ? span(neighbour).end
                     : own_line ? span(holder).open_end
                                : span(neighbour).begin;
    if (own_line) {
      at = layout_.after_comments(at);
    }
    splices_.push_back({at, at,
                        (own_line ? layout_.line_end() + indent : "") +
                            lines(element, indent, step_below(holder))});
  }

  // Adds the first elements to an element that has none.
  void fill(std::size_t holder, const std::vector<Element>& elements) {
    const ElementSpan& self = span(holder);
    const std::string indent = layout_.indent(self.begin);
    const std::string step = step_below(holder);
    const bool own_line = !self.empty && layout_.begins_line(self.close);
    std::string text;
    for (const Element& element : elements) {
      const std::string line = indent + step + lines(element, indent + step, step);
      text += own_line ? line + layout_.line_end() : layout_.line_end() + line;
    }
    if (own_line) {
      const std::size_t at = layout_.line_start(self.close);
      splices_.push_back({at, at, text});
    } else if (self.empty) {
      const std::size_t at = self.attributes.empty() ? self.name_end : self.attributes.back().end;
      splices_.push_back({at, self.end,
                          ">" + text + layout_.line_end() + indent + "</" +
                              std::string(piece(self.begin + 1, self.name_end)) + ">"});
    } else {
      splices_.push_back({self.close, self.close, text + layout_.line_end() + indent});
    }
  }

  std::string_view text_;
  const std::vector<ElementSpan>& spans_;
  const Layout layout_;
  std::vector<Splice> splices_;
  std::map<std::size_t, std::vector<Element>> filled_;
};

}  // namespace

std::string spliced(std::string_view text, std::vector<Splice> splices) {
  std::stable_sort(splices.begin(), splices.end(), [](const Splice& a, const Splice& b) {
    return std::pair(a.begin, a.end) < std::pair(b.begin, b.end);
  });
  std::string result;
  std::size_t at = 0;
  for (const Splice& splice : splices) {
    const std::size_t begin = std::max(at, splice.begin);
    result.append(text.substr(at, begin - at)).append(splice.text);
    at = std::max(begin, splice.end);
  }
  return result.append(text.substr(at));
}

std::string quoted_value(const std::string& value, char quote) {
  std::string text = world::escaped_attribute(value);
  for (std::size_t at = 0; quote == '\'' && (at = text.find('\'', at)) != text.npos;) {
    text.replace(at, 1, "&apos;");
  }
  return text;
}

std::string rewritten(std::string_view text, const std::vector<ElementSpan>& spans,
                      const Element& before, const Element& after) {
  Rewriting rewriting(text, spans);
  rewriting.change(before, after);
  return rewriting.result();
}

bool alike(const Element& a, const Element& b) {
  const auto has = [](const Element& element, const Attribute& attribute) {
    const Attribute* found = element.find(attribute.name);
    return found && found->value == attribute.value;
  };
  return a.name == b.name && a.text == b.text && a.attributes.size() == b.attributes.size() &&
         std::all_of(a.attributes.begin(), a.attributes.end(),
                     [&](const Attribute& each) { return has(b, each); }) &&
         std::equal(a.children.begin(), a.children.end(), b.children.begin(), b.children.end(),
                    alike);
}

}  // namespace elsie::editing
