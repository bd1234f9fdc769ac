#include "text_check.h"

#include <algorithm>
#include <utility>

#include "elsie/base/utf8.h"
#include "elsie/world/error.h"

namespace elsie::world {

namespace {

constexpr std::size_t kDeepest = 50;          // levels: all later steps use recursion
constexpr std::size_t kMostAttributes = 500;  // of an element: each is compared with the rest

bool is_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || c == '.' || c == ':' || static_cast<unsigned char>(c) >= 0x80;
}

class Scanner {
 public:
  Scanner(std::string_view text, const std::string& file, const std::string& kind)
      : text_(text), file_(file), kind_(kind) {}

  std::vector<ElementSpan> check() {
    check_characters();
    while (at_ < text_.size()) {
      if (text_[at_] != '<') {
        check_entity();
        ++at_;
      } else if (starts("<!--")) {
        skip_past("-->", "a comment");
      } else if (starts("<![CDATA[")) {
        skip_past("]]>", "a CDATA section");
      } else if (starts("<?")) {
        skip_past("?>", "a processing instruction");
      } else if (starts("<!")) {
        fail("document type declarations and entities are not allowed in this file; take out '" +
             std::string(text_.substr(at_, word_length(at_ + 2) + 2)) + "'");
      } else {
        tags_.push_back(tag());
      }
    }
    return nested();
  }

 private:
  struct Tag {
    enum class Kind { start, end, empty };
    Kind kind = Kind::start;
    std::string name;
    ElementSpan span{};
  };

  bool starts(std::string_view what) const { return text_.substr(at_).starts_with(what); }

  std::size_t word_length(std::size_t from) const {
    std::size_t end = from;
    while (end < text_.size() && is_name(text_[end])) {
      ++end;
    }
    return end - from;
  }

  int line_of(std::size_t place) const {
    const auto begin = text_.begin();
    return 1 + static_cast<int>(std::count(begin, begin + static_cast<long>(place), '\n'));
  }
  [[noreturn]] void fail(const std::string& message, std::size_t place) const {
    throw WorldError({{file_, line_of(place), message}});
  }
  [[noreturn]] void fail(const std::string& message) const { fail(message, at_); }

  void check_characters() const {
    if (text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF")) {
      throw WorldError({{file_, 0, "this file is in UTF-16; save it as UTF-8"}});
    }
    if (const std::size_t zero = text_.find('\0'); zero != std::string_view::npos) {
      fail("this is not an XML file: it holds a zero byte", zero);
    }
    if (const std::size_t bad = base::first_invalid(text_); bad < text_.size()) {
      fail("this is not UTF-8 text; save the file as UTF-8", bad);
    }
    for (std::size_t i = 0; i < text_.size(); ++i) {
      const auto c = static_cast<unsigned char>(text_[i]);
      if (c < 0x20 && c != '\t' && c != '\n' && c != '\r') {
        fail("this is not an XML file: it holds the control character " + std::to_string(c), i);
      }
    }
  }

  void skip_past(std::string_view end, const std::string& what) {
    const std::size_t found = text_.find(end, at_);
    if (found == std::string_view::npos) {
      fail(what + " starts here and never ends; expected '" + std::string(end) + "'");
    }
    at_ = found + end.size();
  }

  void skip_blanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

  // Of XML's own, or a character reference.
  void check_entity() const {
    if (text_[at_] != '&') {
      return;
    }
    const std::size_t end = text_.find(';', at_);
    const std::string_view entity = end == std::string_view::npos || end - at_ > 12
                                        ? text_.substr(at_, 1)
                                        : text_.substr(at_, end - at_ + 1);
    for (const std::string_view known : {"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"}) {
      if (entity == known) {
        return;
      }
    }
    const bool hex = entity.starts_with("&#x");
    const std::string_view digits =
        entity.substr(std::min<std::size_t>(hex ? 3 : 2, entity.size()));
    if (!entity.starts_with("&#") || digits.size() < 2 ||
        digits.find_first_not_of(hex ? "0123456789abcdefABCDEF" : "0123456789") !=
            digits.size() - 1) {
      fail("'" + std::string(entity) +
           "' is not an entity that XML knows; write a bare ampersand as &amp;");
    }
  }

  std::string_view name(const std::string& what) {
    const std::size_t length = word_length(at_);
    if (length == 0) {
      fail("expected " + what + "; write a bare \"<\" as &lt;");
    }
    const std::string_view found = text_.substr(at_, length);
    at_ += length;
    return found;
  }

  Tag tag() {
    Tag tag;
    tag.span.begin = at_++;
    if (at_ < text_.size() && text_[at_] == '/') {
      ++at_;
      tag.kind = Tag::Kind::end;
    }
    tag.name = name("the name of an element after \"<\"");
    tag.span.name_end = at_;
    while (true) {
      const std::size_t before = at_;
      skip_blanks();
      if (at_ >= text_.size()) {
        fail("the tag <" + tag.name + "> starts here and never ends", tag.span.begin);
      }
      if (text_[at_] == '>') {
        ++at_;
        break;
      }
      if (starts("/>") && tag.kind == Tag::Kind::start) {
        at_ += 2;
        tag.kind = Tag::Kind::empty;
        break;
      }
      if (tag.kind == Tag::Kind::end || before == at_) {
        fail("expected " + std::string(tag.kind == Tag::Kind::end ? "\">\"" : "a blank or \">\"") +
             " in the tag <" + tag.name + ">, found '" + text_[at_] + "'");
      }
      if (tag.span.attributes.size() == kMostAttributes) {
        fail("<" + tag.name + "> has more than " + std::to_string(kMostAttributes) +
             " attributes; no element has so many");
      }
      attribute(tag);
    }
    tag.span.open_end = tag.span.end = at_;
    tag.span.empty = tag.kind == Tag::Kind::empty;
    return tag;
  }

  void attribute(Tag& tag) {
    ElementSpan::Attribute span;
    span.begin = at_;
    auto& known = tag.span.attributes;
    const std::string of = " of <" + tag.name + ">";
    const std::string_view name = this->name("the name of an attribute" + of);
    const std::string what = "the attribute '" + std::string(name) + "'" + of;
    if (std::any_of(known.begin(), known.end(), [&](const auto& other) {
          return text_.substr(other.begin, other.name_end - other.begin) == name;
        })) {
      fail(what + " is given twice");
    }
    span.name_end = at_;
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != '=') {
      fail("expected =\"...\" after " + what);
    }
    ++at_;
    skip_blanks();
    const char quote = at_ < text_.size() ? text_[at_] : '\0';
    if (quote != '"' && quote != '\'') {
      fail("the value of " + what + " must stand in quotes");
    }
    const std::size_t end = text_.find(quote, at_ + 1);
    if (end == std::string_view::npos) {
      fail("the value of " + what + " has no closing quote");
    }
    span.value = at_ + 1;
    for (++at_; at_ < end; ++at_) {
      if (text_[at_] == '<') {
        fail("the value of " + what +
             " holds a \"<\"; a quote may be missing, or write it as &lt;");
      }
      check_entity();
    }
    span.end = at_ = end + 1;
    known.push_back(span);
  }

  // Every element is closed by its own tag, nothing is nested too deeply, and there is one root.
  std::vector<ElementSpan> nested() {
    std::vector<ElementSpan> spans;
    std::vector<std::pair<std::size_t, std::string>> open;
    for (Tag& tag : tags_) {
      const std::size_t begin = tag.span.begin;
      if (tag.kind == Tag::Kind::end) {
        if (open.empty()) {
          fail("</" + tag.name + "> closes nothing", begin);
        }
        const auto& [index, name] = open.back();
        if (name != tag.name) {
          fail("</" + tag.name + "> stands where </" + name + "> was expected: <" + name +
                   "> starts on line " + std::to_string(line_of(spans[index].begin)),
               begin);
        }
        spans[index].close = begin;
        spans[index].end = tag.span.end;
        open.pop_back();
        continue;
      }
      if (open.empty() && !spans.empty()) {
        fail("a second root element, <" + tag.name + ">; a file holds one", begin);
      }
      if (!open.empty()) {
        tag.span.parent = open.back().first;
      }
      if (tag.kind == Tag::Kind::start) {
        open.emplace_back(spans.size(), tag.name);
      }
      if (open.size() > kDeepest) {
        fail("elements are nested deeper than " + std::to_string(kDeepest) + " levels; no " +
                 kind_ + " needs that many",
             begin);
      }
      spans.push_back(std::move(tag.span));
    }
    if (!open.empty()) {
      const auto& [index, name] = open.back();
      fail("<" + name + "> is never closed; expected </" + name + ">", spans[index].begin);
    }
    if (spans.empty()) {
      throw WorldError({{file_, 0,
                         "there is no element in the file; expected <" + kind_ +
                             " format=\"1\"> ... </" + kind_ + ">"}});
    }
    return spans;
  }

  std::string_view text_;
  const std::string& file_;
  const std::string& kind_;
  std::size_t at_ = 0;
  std::vector<Tag> tags_;
};

}  // namespace

std::vector<ElementSpan> check_text(std::string_view text, const std::string& file,
                                    const std::string& kind) {
  return Scanner(text, file, kind).check();
}

}  // namespace elsie::world
