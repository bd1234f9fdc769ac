#include "text_check.h"

#include <algorithm>
#include <utility>

#include "elsie/base/utf8.h"
#include "elsie/world/error.h"

namespace elsie::world {

namespace {

constexpr std::size_t kDeepest = 50;          // levels: all later steps use recursion
constexpr std::size_t kMostAttributes = 500;  // of an element: each is compared with all others

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
        tag();
      }
    }
    if (!open_.empty()) {
      const std::string name = name_of(open_.back());
      fail("<" + name + "> is never closed; expected </" + name + ">", spans_[open_.back()].begin);
    }
    if (spans_.empty()) {
      throw WorldError({{file_, 0,
                         "there is no element in the file; expected <" + kind_ +
                             " format=\"1\"> ... </" + kind_ + ">"}});
    }
    return std::move(spans_);
  }

 private:
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
    const auto control = std::find_if(text_.begin(), text_.end(), [](unsigned char c) {
      return c < 0x20 && c != '\t' && c != '\n' && c != '\r';
    });
    if (control != text_.end()) {
      fail("this is not an XML file: it holds the control character " + std::to_string(*control),
           static_cast<std::size_t>(control - text_.begin()));
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

  // Allows the entities of XML itself, and character references.
  void check_entity() const {
    if (text_[at_] != '&') return;
    const std::size_t end = text_.find(';', at_);
    const std::string_view entity = end == std::string_view::npos || end - at_ > 12
                                        ? text_.substr(at_, 1)
                                        : text_.substr(at_, end - at_ + 1);
    for (const std::string_view known : {"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"}) {
      if (entity == known) return;
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

  // Reads a start tag or an end tag.
  void tag() {
    ElementSpan span;
    span.begin = at_++;
    const bool is_end = starts("/");
    at_ += is_end ? 1 : 0;
    const std::string name(this->name("the name of an element after \"<\""));
    span.name_end = at_;
    while (true) {
      const std::size_t before = at_;
      skip_blanks();
      if (at_ >= text_.size()) {
        fail("the tag <" + name + "> starts here and never ends", span.begin);
      }
      span.empty = !is_end && starts("/>");
      if (span.empty || text_[at_] == '>') {
        at_ += span.empty ? 2 : 1;
        break;
      }
      if (is_end || before == at_) {
        fail("expected " + std::string(is_end ? "\">\"" : "a blank or \">\"") + " in the tag <" +
             name + ">, found '" + text_[at_] + "'");
      }
      if (span.attributes.size() == kMostAttributes) {
        fail("<" + name + "> has more than " + std::to_string(kMostAttributes) +
             " attributes; no element has so many");
      }
      attribute(name, span.attributes);
    }
    span.open_end = span.end = at_;
    if (is_end) {
      close(name, span.begin);
    } else {
      open(name, std::move(span));
    }
  }

  void attribute(const std::string& element, std::vector<ElementSpan::Attribute>& known) {
    ElementSpan::Attribute span;
    span.begin = at_;
    const std::string of = " of <" + element + ">";
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

  std::string name_of(std::size_t element) const {
    const ElementSpan& span = spans_[element];
    return std::string(text_.substr(span.begin + 1, span.name_end - span.begin - 1));
  }

  void open(const std::string& name, ElementSpan span) {
    if (open_.empty() && !spans_.empty()) {
      fail("a second root element, <" + name + ">; a file holds one", span.begin);
    }
    if (!open_.empty()) {
      span.parent = open_.back();
    }
    if (!span.empty) {
      open_.push_back(spans_.size());
    }
    if (open_.size() > kDeepest) {
      fail("elements are nested deeper than " + std::to_string(kDeepest) + " levels; no " + kind_ +
               " needs that many",
           span.begin);
    }
    spans_.push_back(std::move(span));
  }

  // Checks that every element is closed by its own tag.
  void close(const std::string& name, std::size_t begin) {
    if (open_.empty()) {
      fail("</" + name + "> closes nothing", begin);
    }
    const std::string expected = name_of(open_.back());
    ElementSpan& span = spans_[open_.back()];
    if (name != expected) {
      fail("</" + name + "> stands where </" + expected + "> was expected: <" + expected +
               "> starts on line " + std::to_string(line_of(span.begin)),
           begin);
    }
    span.close = begin;
    span.end = at_;
    open_.pop_back();
  }

  std::string_view text_;
  const std::string& file_;
  const std::string& kind_;
  std::size_t at_ = 0;
  std::vector<ElementSpan> spans_;
  std::vector<std::size_t> open_;  // elements, outermost first
};

}  // namespace

std::vector<ElementSpan> check_text(std::string_view text, const std::string& file,
                                    const std::string& kind) {
  return Scanner(text, file, kind).check();
}

}  // namespace elsie::world
