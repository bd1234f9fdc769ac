// Reads XML with expat, which says where every event is, and turns its errors into sentences.
#include <algorithm>
#include <exception>
#include <memory>
#include <utility>

#include <expat.h>
#include <strings.h>

#include "elsie/base/utf8.h"
#include "elsie/world/error.h"
#include "elsie/world/markup.h"

namespace elsie::world {
namespace {
constexpr std::size_t kDeepest = 50;  // levels: all later steps use recursion
constexpr std::size_t kMostAttributes = 500;
constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kEndsName = " \t\r\n=/<>\"'";
constexpr auto kNowhere = std::string_view::npos;
constexpr const char* kNoDeclarations =
    "document type declarations and entities are not allowed in this file; take out '<!...>'";

// Finds the places in a start tag. If the text ends inside of it, what it misses stays zero.
ElementSpan span_of_tag(std::string_view text, std::size_t begin) {
  ElementSpan span;
  span.begin = begin;
  span.name_end = std::min(text.find_first_of(kEndsName, begin + 1), text.size());
  std::size_t at = text.find_first_not_of(kBlanks, span.name_end);
  while (at < text.size() && text[at] != '/' && text[at] != '>') {
    ElementSpan::Attribute& attribute = span.attributes.emplace_back();
    attribute.begin = at;
    attribute.name_end = std::min(text.find_first_of(kEndsName, at), text.size());
    const std::size_t quote = text.find_first_of("\"'", attribute.name_end);
    if (quote == kNowhere) break;
    attribute.value = quote + 1;
    const std::size_t end = text.find(text[quote], attribute.value);
    if (end == kNowhere) break;
    attribute.end = end + 1;
    at = text.find_first_not_of(kBlanks, attribute.end);
  }
  return span;
}

class Parser {
 public:
  Parser(std::string_view text, const std::string& file, const std::string& kind)
      : text_(text), file_(file), kind_(kind), expat_(XML_ParserCreate("UTF-8"), XML_ParserFree) {
    XML_SetUserData(expat_.get(), this);
    XML_SetXmlDeclHandler(expat_.get(), call<&Parser::declaration>);
    XML_SetElementHandler(expat_.get(), call<&Parser::start>, call<&Parser::end>);
    XML_SetCharacterDataHandler(expat_.get(), call<&Parser::text>);
    XML_SetDefaultHandler(expat_.get(), call<&Parser::other>);
  }

  Element root(std::vector<ElementSpan>* spans) {
    check_bytes();
    if (text_.starts_with("\xEF\xBB\xBF")) end_ = 3;  // a byte order mark
    const int size = static_cast<int>(text_.size());  // read_text() reads at most 256 MB
    if (XML_Parse(expat_.get(), text_.data(), size, XML_TRUE) != XML_STATUS_OK) {
      if (failure_) std::rethrow_exception(failure_);
      explain(XML_GetErrorCode(expat_.get()));
    }
    if (spans) *spans = std::move(spans_);
    return std::move(root_);
  }

 private:
  // What expat calls for an event. An exception must not pass through expat, which is C.
  template <auto kHandler, class... Given>
  static void call(void* parser, Given... given) {
    Parser& self = *static_cast<Parser*>(parser);
    if (self.failure_) return;
    XML_Parser const expat = self.expat_.get();
    self.begin_ = static_cast<std::size_t>(XML_GetCurrentByteIndex(expat));
    self.end_ = self.begin_ + static_cast<std::size_t>(XML_GetCurrentByteCount(expat));
    try {
      (self.*kHandler)(given...);
    } catch (...) {
      self.failure_ = std::current_exception();
      XML_StopParser(expat, XML_FALSE);
    }
  }

  // The line of a place; the last answer saves counting from the beginning.
  int line_of(std::size_t offset) {
    if (offset < counted_) counted_ = 0, line_ = 1;
    const std::string_view more = text_.substr(counted_, offset - counted_);
    line_ += static_cast<int>(std::count(more.begin(), more.end(), '\n'));
    counted_ = offset;
    return line_;
  }
  [[noreturn]] void fail(const std::string& message, std::size_t offset) {
    throw WorldError({{file_, line_of(offset), message}});
  }

  // Expat would read UTF-16, too.
  void check_bytes() {
    const std::size_t bad = std::min(text_.find('\0'), base::first_invalid(text_));
    if (bad >= text_.size()) return;
    const bool is_utf16 = text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF");
    fail(is_utf16             ? "this file is in UTF-16; save it as UTF-8"
         : text_[bad] == '\0' ? "this is not an XML file: it holds a zero byte"
                              : "this is not UTF-8 text; save the file as UTF-8",
         bad);
  }

  void declaration(const XML_Char* /*version*/, const XML_Char* encoding, int /*standalone*/) {
    if (encoding && strcasecmp(encoding, "utf-8") != 0 && strcasecmp(encoding, "us-ascii") != 0) {
      fail("the encoding '" + std::string(encoding) + "' is not supported; save the file as UTF-8",
           begin_);
    }
  }

  void start(const XML_Char* name, const XML_Char** given) {
    ElementSpan span = span_of_tag(text_.substr(0, end_), begin_);
    span.open_end = end_;
    span.empty = text_[end_ - 2] == '/';
    span.parent = inside_;
    if (span.attributes.size() > kMostAttributes) {
      fail("<" + std::string(name) + "> has more than 500 attributes; no element has so many",
           span.attributes[kMostAttributes].begin);
    }
    if (!span.empty && open_.size() == kDeepest) {
      fail("elements are nested deeper than 50 levels; no " + kind_ + " needs that many", begin_);
    }
    Element& made = open_.empty() ? root_ : open_.back()->children.emplace_back();
    made.name = name;
    made.where = {file_, line_of(begin_)};
    for (const ElementSpan::Attribute& attribute : span.attributes) {
      made.attributes.push_back({given[0], given[1], {file_, line_of(attribute.begin)}});
      given += 2;
    }
    inside_ = spans_.size();
    open_.push_back(&made);
    spans_.push_back(std::move(span));
  }

  void end(const XML_Char* /*name*/) {
    std::string& text = open_.back()->text;
    text.erase(text.find_last_not_of(kBlanks) + 1);
    ElementSpan& span = spans_[inside_];
    if (!span.empty) span.close = begin_;
    span.end = end_;
    inside_ = span.parent;
    open_.pop_back();
  }

  // Text comes in pieces: lines, and the characters that entities stand for.
  void text(const XML_Char* begin, int size) {
    const std::string_view piece(begin, static_cast<std::size_t>(size));
    Element& holder = *open_.back();
    const std::size_t first = holder.text.empty() ? piece.find_first_not_of(kBlanks) : 0;
    if (first == kNowhere) return;
    if (holder.text.empty()) holder.text_line = line_of(begin_ + first);
    holder.text += piece.substr(first);
  }

  // Comments, instructions, what declarations consist of, and blanks outside of the root.
  void other(const XML_Char* begin, int size) {
    if (std::string_view(begin, static_cast<std::size_t>(size)) == "<!DOCTYPE") {
      fail(kNoDeclarations, begin_);
    }
  }

  std::string name_at(std::size_t begin) const {
    return std::string(text_.substr(begin, text_.find_first_of(kEndsName, begin) - begin));
  }

  // Says what is wrong with the markup after the last event. Expat gives up at `at`.
  [[noreturn]] void explain(XML_Error error) {
    const auto at = static_cast<std::size_t>(XML_GetCurrentByteIndex(expat_.get()));
    const std::size_t begin = std::min(text_.find_first_not_of(kBlanks, end_), text_.size());
    const std::string_view markup = text_.substr(begin);
    if (error == XML_ERROR_NO_ELEMENTS) explain_end();
    if (error == XML_ERROR_UNCLOSED_CDATA_SECTION) explain_unclosed(text_.rfind("<![CDATA[", at));
    if (at >= text_.size()) fail("expat fails: " + std::string(XML_ErrorString(error)), 0);
    if (open_.empty() && (!markup.starts_with('<') || markup.starts_with("<!["))) {
      fail("there is text outside of the root element", begin);
    }
    if (text_[at] >= '\0' && text_[at] < ' ' && kBlanks.find(text_[at]) == kNowhere) {
      fail("this is not an XML file: it holds a control character; take it out", at);
    }
    if (error == XML_ERROR_UNCLOSED_TOKEN && markup.starts_with('<')) explain_unclosed(begin);
    if (markup.starts_with("<!--")) fail("a comment holds \"--\"; take one \"-\" out", at);
    if (markup.starts_with("<!")) fail(kNoDeclarations, begin);
    if (markup.starts_with("<?")) {
      fail(R"(expected <?xml version="1.0" encoding="UTF-8"?> at the beginning of the file)",
           begin);
    }
    explain_entity(error, begin, at);
    if (markup.starts_with('<')) explain_tag(error, begin, at);
    fail("text cannot hold \"]]>\" or a character that XML forbids; write \"]]>\" as ]]&gt;", at);
  }

  [[noreturn]] void explain_end() {
    if (open_.empty()) {
      throw WorldError({{file_, 0,
                         "there is no element in the file; expected <" + kind_ +
                             " format=\"1\"> ... </" + kind_ + ">"}});
    }
    const std::string& name = open_.back()->name;
    fail("<" + name + "> is never closed; expected </" + name + ">", spans_[inside_].begin);
  }

  [[noreturn]] void explain_unclosed(std::size_t begin) {
    const std::string start = "<" + name_at(begin + 1);
    const std::string end = start.starts_with("<!--")  ? "'-->'"
                            : start.starts_with("<![") ? "']]>'"
                            : start.starts_with("<?")  ? "'?>'"
                                                       : "'>' after it, or a closing quote";
    fail("'" + start + "' starts here and never ends; expected " + end, begin);
  }

  void explain_entity(XML_Error error, std::size_t begin, std::size_t at) {
    constexpr std::string_view kKnown = "&amp;&lt;&gt;&quot;&apos;";
    std::size_t ampersand = text_.rfind('&', at);
    const auto entity = [&] {
      return text_.substr(ampersand, text_.find(';', ampersand) + 1 - ampersand);
    };
    if (error == XML_ERROR_UNDEFINED_ENTITY) {  // expat says only in which tag or text it is
      ampersand = text_.find('&', begin);
      while (entity().starts_with("&#") || kKnown.find(entity()) != kNowhere) {
        ampersand = text_.find('&', ampersand + 1);
      }
    } else if (ampersand == kNowhere || ampersand < begin || text_.find(';', ampersand) < at) {
      return;
    }
    const bool is_forbidden = error == XML_ERROR_BAD_CHAR_REF;
    const bool is_whole = is_forbidden || error == XML_ERROR_UNDEFINED_ENTITY || text_[at] == ';';
    fail("'" + std::string(is_whole ? entity() : "&") +
             (is_forbidden ? "' stands for a character that XML forbids; take it out"
                           : "' is not an entity that XML knows; write a bare ampersand as &amp;"),
         ampersand);
  }

  [[noreturn]] void explain_tag(XML_Error error, std::size_t begin, std::size_t at) {
    const bool is_end = text_[begin + 1] == '/';
    const std::string name = name_at(begin + (is_end ? 2 : 1));
    if (is_end && open_.empty()) fail("</" + name + "> closes nothing", begin);
    if (error == XML_ERROR_TAG_MISMATCH) {
      const Element& open = *open_.back();
      fail("</" + name + "> stands where </" + open.name + "> was expected: <" + open.name +
               "> starts on line " + std::to_string(open.where.line),
           begin);
    }
    if (error == XML_ERROR_JUNK_AFTER_DOC_ELEMENT) {
      fail("a second root element, <" + name + ">; a file holds one", begin);
    }
    if (at == begin + (is_end ? 2 : 1)) {
      fail("expected the name of an element after \"<\"; write a bare \"<\" as &lt;", begin);
    }
    explain_attribute(error, "<" + name + ">", begin, at);
  }

  [[noreturn]] void explain_attribute(XML_Error error, const std::string& tag, std::size_t begin,
                                      std::size_t at) {
    const auto what = [&](std::size_t attribute) {
      return "the attribute '" + name_at(attribute) + "' of " + tag;
    };
    if (error == XML_ERROR_DUPLICATE_ATTRIBUTE) fail(what(at) + " is given twice", at);
    const auto attributes = span_of_tag(text_.substr(0, at), begin).attributes;
    if (attributes.empty() || attributes.back().end > 0) {
      const std::string found(text_.substr(at, base::character_at(text_, at).bytes));
      fail("expected " + std::string(text_[begin + 1] == '/' ? "" : "a blank or ") +
               "\">\" in the tag " + tag + ", found '" + found + "'",
           at);
    }
    const std::size_t name = attributes.back().begin;
    const std::string value = "the value of " + what(name);
    if (attributes.back().value == 0) {
      fail(value + " must stand in quotes: " + name_at(name) + "=\"...\"", at);
    }
    fail(value + " holds a \"<\"; a quote may be missing, or write it as &lt;", at);
  }

  std::string_view text_;
  const base::SharedText file_;
  const std::string& kind_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> expat_;
  std::exception_ptr failure_;  // what a handler has thrown
  std::size_t begin_ = 0;       // of the event
  std::size_t end_ = 0;
  std::size_t counted_ = 0;
  int line_ = 1;  // of the byte `counted_`
  Element root_;
  std::vector<ElementSpan> spans_;
  std::vector<Element*> open_;               // outermost first
  std::size_t inside_ = ElementSpan::kNone;  // the span of the innermost
};
}  // namespace

Element parse_markup(std::string_view text, const std::string& file, const std::string& kind,
                     std::vector<ElementSpan>* spans) {
  return Parser(text, file, kind).root(spans);
}

}  // namespace elsie::world
