#include "text_check.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <system_error>
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

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

std::size_t first_control(std::string_view text) {
  const auto found = std::find_if(text.begin(), text.end(),
                                  [](char c) { return c >= '\0' && c < ' ' && !is_blank(c); });
  return static_cast<std::size_t>(found - text.begin());
}

// XML 1.0, section 2.2.
bool is_character(std::uint32_t code) {
  return code == '\t' || code == '\n' || code == '\r' || (code >= ' ' && code < 0xd800) ||
         (code >= 0xe000 && code < 0xfffe) || (code >= 0x10000 && code < 0x110000);
}

std::size_t name_end(std::string_view text, std::size_t begin) {
  while (begin < text.size() && is_name(text[begin])) ++begin;
  return begin;
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
      } else if (!skipped("<!--", "-->", "a comment") &&
                 !skipped("<![CDATA[", "]]>", "a CDATA section") &&
                 !skipped("<?", "?>", "a processing instruction")) {
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

  int line_of(std::size_t offset) const {
    const auto begin = text_.begin();
    return 1 + static_cast<int>(std::count(begin, begin + static_cast<long>(offset), '\n'));
  }
  [[noreturn]] void fail(const std::string& message, std::size_t offset) const {
    throw WorldError({{file_, line_of(offset), message}});
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
    if (const std::size_t control = first_control(text_); control < text_.size()) {
      fail("this is not an XML file: it holds the control character " +
               std::to_string(static_cast<int>(text_[control])),
           control);
    }
  }

  bool skipped(std::string_view begin, std::string_view end, const std::string& what) {
    if (!starts(begin)) return false;
    const std::size_t found = text_.find(end, at_ + begin.size());
    if (found == std::string_view::npos) {
      fail(what + " starts here and never ends; expected '" + std::string(end) + "'");
    }
    at_ = found + end.size();
    return true;
  }

  void skip_blanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

  // Allows the entities of XML itself, and character references.
  void check_entity() const {
    if (text_[at_] != '&') return;
    const std::size_t end = text_.find(';', at_);
    const std::string_view entity =
        text_.substr(at_, end == text_.npos || end - at_ > 12 ? 1 : end - at_ + 1);
    for (const std::string_view known : {"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"}) {
      if (entity == known) return;
    }
    const bool hex = entity.starts_with("&#x");
    const char* const last = entity.data() + entity.size() - 1;
    std::uint32_t code = 0;
    const auto read =
        std::from_chars(std::min(entity.data() + (hex ? 3 : 2), last), last, code, hex ? 16 : 10);
    if (!entity.starts_with("&#") || read.ptr != last || read.ec == std::errc::invalid_argument) {
      fail("'" + std::string(entity) +
           "' is not an entity that XML knows; write a bare ampersand as &amp;");
    }
    if (read.ec != std::errc() || !is_character(code)) {
      fail("'" + std::string(entity) + "' stands for a character that XML forbids; take it out");
    }
  }

  std::string_view name(const std::string& what) {
    const std::size_t begin = std::exchange(at_, name_end(text_, at_));
    if (at_ == begin) fail("expected " + what + "; write a bare \"<\" as &lt;");
    return text_.substr(begin, at_ - begin);
  }

  // Reads a start tag or an end tag.
  void tag() {
    if (starts("<!")) {
      fail("document type declarations and entities are not allowed in this file; take out '" +
           std::string(text_.substr(at_, name_end(text_, at_ + 2) - at_)) + "'");
    }
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
    is_end ? close(name, span.begin) : open(name, std::move(span));
  }

  void attribute(const std::string& element, std::vector<ElementSpan::Attribute>& known) {
    ElementSpan::Attribute span;
    span.begin = at_;
    const std::string of = " of <" + element + ">";
    const std::string_view name = this->name("the name of an attribute" + of);
    const std::string what = "the attribute '" + std::string(name) + "'" + of;
    for (const ElementSpan::Attribute& other : known) {
      const auto other_name = text_.substr(other.begin, other.name_end - other.begin);
      if (other_name == name) fail(what + " is given twice");
    }
    span.name_end = at_;
    skip_blanks();
    if (!starts("=")) fail("expected =\"...\" after " + what);
    ++at_;
    skip_blanks();
    const char quote = at_ < text_.size() ? text_[at_] : '\0';
    if (quote != '"' && quote != '\'') fail("the value of " + what + " must stand in quotes");
    const std::size_t end = text_.find(quote, at_ + 1);
    if (end == text_.npos) fail("the value of " + what + " has no closing quote");
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
    if (!open_.empty()) span.parent = open_.back();
    if (!span.empty) open_.push_back(spans_.size());
    if (open_.size() > kDeepest) {
      fail("elements are nested deeper than " + std::to_string(kDeepest) + " levels; no " + kind_ +
               " needs that many",
           span.begin);
    }
    spans_.push_back(std::move(span));
  }

  // Checks that every element is closed by its own tag.
  void close(const std::string& name, std::size_t begin) {
    if (open_.empty()) fail("</" + name + "> closes nothing", begin);
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

bool is_plain(std::string_view text) {
  if (base::first_invalid(text) < text.size() || first_control(text) < text.size()) return false;
  bool in_value = false;
  std::size_t values = 0;  // since the last "<"
  std::size_t depth = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    const char next = at + 1 < text.size() ? text[at + 1] : '\0';
    if (c == '"') {
      in_value = !in_value;
      const bool is_apart = in_value || is_blank(next) || next == '/' || next == '>';
      if (!is_apart || (!in_value && ++values > kMostAttributes)) return false;
    } else if (c == '&' || (c == '<' && in_value) || (c == '\'' && !in_value)) {
      return false;
    } else if (c == '/' && next == '>' && !in_value) {
      if (depth-- == 0) return false;
    } else if (c == '<') {
      values = 0;
      const bool is_comment = text.substr(at).starts_with("<!--");
      if (is_comment || next == '?') {
        at = is_comment ? text.find("-->", at + 4) : text.find("?>", at + 2);
        if (at == text.npos) return false;
      } else if (next == '/') {
        at = text.find_first_not_of(" \t\r\n", name_end(text, at + 2));
        if (at == text.npos || text[at] != '>' || depth-- == 0) return false;
      } else if (!is_name(next) || ++depth > kDeepest) {
        return false;
      }
    }
  }
  return !in_value;
}

std::vector<ElementSpan> check_text(std::string_view text, const std::string& file,
                                    const std::string& kind) {
  return Scanner(text, file, kind).check();
}

}  // namespace elsie::world
