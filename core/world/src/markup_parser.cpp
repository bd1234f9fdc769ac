// Parses XML. A library would not do: documents need the place of every element and attribute in
// the text, and users sentences about the first mistake.
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <system_error>
#include <utility>

#include <strings.h>

#include "elsie/base/utf8.h"
#include "elsie/world/error.h"
#include "elsie/world/markup.h"

namespace elsie::world {
namespace {
constexpr std::size_t kDeepest = 50;          // levels: all later steps use recursion
constexpr std::size_t kMostAttributes = 500;  // of an element: each is compared with all others
constexpr std::string_view kBlanks = " \t\r\n";
constexpr auto kNowhere = std::string_view::npos;

// XML 1.0, section 2.3, without a list of the letters beyond ASCII.
bool may_begin_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':' ||
         static_cast<unsigned char>(c) >= 0x80;
}
bool is_of_name(char c) {
  return may_begin_name(c) || (c >= '0' && c <= '9') || c == '-' || c == '.';
}

// XML 1.0, section 2.2.
bool is_character(std::uint32_t code) {
  return code == '\t' || code == '\n' || code == '\r' || (code >= ' ' && code < 0xd800) ||
         (code >= 0xe000 && code < 0xfffe) || (code >= 0x10000 && code < 0x110000);
}

class Parser {
 public:
  Parser(std::string_view text, const std::string& file, const std::string& kind)
      : text_(text), file_(file), kind_(kind) {}

  Element root(std::vector<ElementSpan>* spans) {
    check_characters();
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // a byte order mark
    Element all;
    content(all);
    if (starts("</")) {
      const std::size_t begin = at_;
      fail("</" + end_tag() + "> closes nothing", begin);
    }
    if (all.children.empty()) {
      throw WorldError({{file_, 0,
                         "there is no element in the file; expected <" + kind_ +
                             " format=\"1\"> ... </" + kind_ + ">"}});
    }
    if (!all.text.empty()) {
      throw WorldError({{file_, all.text_line, "there is text outside of the root element"}});
    }
    if (spans) *spans = std::move(spans_);
    return std::move(all.children.front());
  }

 private:
  bool starts(std::string_view what) const { return text_.substr(at_).starts_with(what); }

  // The line of a place; the last answer saves counting from the beginning.
  int line_of(std::size_t offset) {
    if (offset < counted_) counted_ = 0, line_ = 1;
    const auto begin = text_.begin();
    line_ += static_cast<int>(
        std::count(begin + static_cast<long>(counted_), begin + static_cast<long>(offset), '\n'));
    counted_ = offset;
    return line_;
  }
  [[noreturn]] void fail(const std::string& message, std::size_t offset) {
    throw WorldError({{file_, line_of(offset), message}});
  }
  [[noreturn]] void fail(const std::string& message) { fail(message, at_); }

  void check_characters() {
    if (text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF")) {
      throw WorldError({{file_, 0, "this file is in UTF-16; save it as UTF-8"}});
    }
    if (const std::size_t zero = text_.find('\0'); zero != kNowhere) {
      fail("this is not an XML file: it holds a zero byte", zero);
    }
    if (const std::size_t bad = base::first_invalid(text_); bad < text_.size()) {
      fail("this is not UTF-8 text; save the file as UTF-8", bad);
    }
    const auto control = std::find_if(text_.begin(), text_.end(), [](char c) {
      return c >= '\0' && c < ' ' && kBlanks.find(c) == kNowhere;
    });
    if (control != text_.end()) {
      fail("this is not an XML file: it holds the control character " +
               std::to_string(static_cast<int>(*control)),
           static_cast<std::size_t>(control - text_.begin()));
    }
  }

  // Reads what stands in an element, or in the file, up to an end tag or the end of the file.
  void content(Element& holder) {
    while (at_ < text_.size() && !starts("</")) {
      const std::size_t begin = at_;
      if (text_[at_] != '<') {
        text(holder);
      } else if (skipped("<![CDATA[", "]]>", "a CDATA section")) {
        note_text(holder, std::string(text_.substr(begin + 9, at_ - begin - 12)), begin);
      } else if (skipped("<?", "?>", "a processing instruction")) {
        check_instruction(begin);
      } else {
        is_at_top_ = false;
        if (!skipped("<!--", "-->", "a comment")) element(holder);
      }
    }
  }

  bool skipped(std::string_view begin, std::string_view end, const std::string& what) {
    if (!starts(begin)) return false;
    const std::size_t found = text_.find(end, at_ + begin.size());
    if (found == kNowhere) {
      fail(what + " starts here and never ends; expected '" + std::string(end) + "'");
    }
    at_ = found + end.size();
    return true;
  }

  // <?xml ... encoding="..."?>
  void check_instruction(std::size_t begin) {
    if (!is_at_top_) {
      fail("a processing instruction <?...?> may stand at the top of the file only", begin);
    }
    const std::string_view found = text_.substr(begin, at_ - begin);
    const std::size_t open = found.find_first_of("\"'", found.find("encoding"));
    const std::size_t close = found.find_first_of("\"'", open == kNowhere ? open : open + 1);
    if (!found.starts_with("<?xml") || close == kNowhere) return;
    const std::string encoding(found.substr(open + 1, close - open - 1));
    if (strcasecmp(encoding.c_str(), "utf-8") != 0 &&
        strcasecmp(encoding.c_str(), "us-ascii") != 0) {
      fail("the encoding '" + encoding + "' is not supported; save the file as UTF-8", begin);
    }
  }

  void text(Element& holder) {
    const std::size_t end = std::min(text_.find('<', at_), text_.size());
    const std::size_t begin = text_.find_first_not_of(kBlanks, at_);
    if (begin < end) {
      note_text(holder, decoded(begin, end), begin);
    }
    at_ = end;
  }

  // Keeps the first text that is not blank.
  void note_text(Element& holder, const std::string& text, std::size_t offset) {
    const std::size_t begin = text.find_first_not_of(kBlanks);
    if (begin == kNowhere || !holder.text.empty()) return;
    holder.text = text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
    holder.text_line = line_of(offset);
  }

  // A piece of the text with its entities replaced, and a line feed for each end of a line.
  std::string decoded(std::size_t begin, std::size_t end) {
    std::string result;
    for (at_ = begin; at_ < end;) {
      if (text_[at_] == '&') {
        result += entity();
        continue;
      }
      const bool is_return = text_[at_] == '\r';
      result += is_return ? '\n' : text_[at_];
      at_ += is_return && starts("\r\n") ? 2 : 1;
    }
    return result;
  }

  // Reads one of the entities of XML itself, or a character reference.
  std::string entity() {
    const std::size_t end = text_.find(';', at_);
    const std::string_view entity =
        text_.substr(at_, end == kNowhere || end - at_ > 12 ? 1 : end - at_ + 1);
    constexpr std::pair<std::string_view, const char*> kKnown[] = {
        {"&amp;", "&"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}};
    for (const auto& [known, meaning] : kKnown) {
      if (entity == known) {
        at_ += entity.size();
        return meaning;
      }
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
    at_ += entity.size();
    return base::utf8_of(code);
  }

  void skip_blanks() { at_ = std::min(text_.find_first_not_of(kBlanks, at_), text_.size()); }

  // `of`: the element whose attribute it names, if it does.
  std::string name(const Element* of = nullptr) {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_of_name(text_[at_])) ++at_;
    if (at_ == begin || !may_begin_name(text_[begin])) {
      fail("expected the name of an " +
               (of ? "attribute of <" + of->name + ">" : "element after \"<\"") +
               "; write a bare \"<\" as &lt;",
           begin);
    }
    return std::string(text_.substr(begin, at_ - begin));
  }

  void element(Element& holder) {
    if (starts("<!")) {
      const auto end =
          std::find_if_not(text_.begin() + static_cast<long>(at_) + 2, text_.end(), is_of_name);
      fail("document type declarations and entities are not allowed in this file; take out '" +
           std::string(text_.begin() + static_cast<long>(at_), end) + "'");
    }
    const std::size_t number = spans_.size();
    ElementSpan span;
    span.begin = at_;
    Element made;
    made.where = {file_, line_of(at_++)};
    made.name = name();
    span.name_end = at_;
    if (open_.empty() && number > 0) {
      fail("a second root element, <" + made.name + ">; a file holds one", span.begin);
    }
    while (more_in_tag(made.name, span.begin, false)) attribute(made, span);
    span.empty = starts("/>");
    at_ += span.empty ? 2 : 1;
    span.open_end = span.end = at_;
    if (!open_.empty()) span.parent = open_.back();
    const std::size_t begin = span.begin;
    const bool is_empty = span.empty;
    spans_.push_back(std::move(span));
    if (!is_empty) inside(made, number, begin);
    holder.children.push_back(std::move(made));
  }

  // Reads the content of an element and its end tag.
  void inside(Element& element, std::size_t number, std::size_t begin) {
    if (open_.size() == kDeepest) {
      fail("elements are nested deeper than " + std::to_string(kDeepest) + " levels; no " + kind_ +
               " needs that many",
           begin);
    }
    open_.push_back(number);
    content(element);
    open_.pop_back();
    if (at_ == text_.size()) {
      fail("<" + element.name + "> is never closed; expected </" + element.name + ">", begin);
    }
    const std::size_t close = at_;
    if (const std::string found = end_tag(); found != element.name) {
      fail("</" + found + "> stands where </" + element.name + "> was expected: <" + element.name +
               "> starts on line " + std::to_string(line_of(begin)),
           close);
    }
    spans_[number].close = close;
    spans_[number].end = at_;
  }

  // Reads an end tag; returns its name.
  std::string end_tag() {
    const std::size_t begin = at_;
    at_ += 2;
    std::string name = this->name();
    more_in_tag(name, begin, true);
    ++at_;
    return name;
  }

  // Whether an attribute follows in this tag, instead of its end.
  bool more_in_tag(const std::string& name, std::size_t begin, bool is_end) {
    const std::size_t before = at_;
    skip_blanks();
    if (at_ == text_.size()) fail("the tag <" + name + "> starts here and never ends", begin);
    if (text_[at_] == '>' || (!is_end && starts("/>"))) return false;
    if (is_end || before == at_) {
      fail("expected " + std::string(is_end ? "\">\"" : "a blank or \">\"") + " in the tag <" +
           name + ">, found '" + text_[at_] + "'");
    }
    return true;
  }

  void attribute(Element& element, ElementSpan& of) {
    if (element.attributes.size() == kMostAttributes) {
      fail("<" + element.name + "> has more than " + std::to_string(kMostAttributes) +
           " attributes; no element has so many");
    }
    ElementSpan::Attribute span;
    span.begin = at_;
    std::string name = this->name(&element);
    const auto what = [&] { return "the attribute '" + name + "' of <" + element.name + ">"; };
    if (element.find(name)) fail(what() + " is given twice");
    span.name_end = at_;
    skip_blanks();
    if (!starts("=")) fail("expected =\"...\" after " + what());
    ++at_;
    skip_blanks();
    const char quote = at_ < text_.size() ? text_[at_] : '\0';
    if (quote != '"' && quote != '\'') fail("the value of " + what() + " must stand in quotes");
    const std::size_t end = text_.find(quote, at_ + 1);
    if (end == kNowhere) fail("the value of " + what() + " has no closing quote");
    span.value = at_ + 1;
    if (const std::size_t tag = text_.find('<', span.value); tag < end) {
      fail("the value of " + what() + " holds a \"<\"; a quote may be missing, or write it as &lt;",
           tag);
    }
    element.attributes.push_back(
        {std::move(name), decoded(span.value, end), {file_, line_of(span.begin)}});
    span.end = at_ = end + 1;
    of.attributes.push_back(span);
  }

  std::string_view text_;
  const base::SharedText file_;
  const std::string& kind_;
  std::size_t at_ = 0;
  bool is_at_top_ = true;  // there was no element or comment so far
  std::size_t counted_ = 0;
  int line_ = 1;  // of the byte `counted_`
  std::vector<ElementSpan> spans_;
  std::vector<std::size_t> open_;  // elements, outermost first
};
}  // namespace

Element parse_markup(std::string_view text, const std::string& file, const std::string& kind,
                     std::vector<ElementSpan>* spans) {
  return Parser(text, file, kind).root(spans);
}

}  // namespace elsie::world
