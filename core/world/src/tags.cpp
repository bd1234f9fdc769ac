#include "tags.h"

#include <algorithm>

#include "elsie/world/error.h"

namespace elsie::world {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool is_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || c == '.' || c == ':' || static_cast<unsigned char>(c) >= 0x80;
}

// Each is compared with all before it.
constexpr std::size_t kMostAttributes = 500;

class Scanner {
 public:
  Scanner(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  std::vector<Tag> scan() {
    std::vector<Tag> tags;
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
        tags.push_back(tag());
      }
    }
    return tags;
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

  [[noreturn]] void fail(const std::string& message, std::size_t place) const {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<long>(place), '\n');
    throw WorldError({{file_, static_cast<int>(line), message}});
  }
  [[noreturn]] void fail(const std::string& message) const { fail(message, at_); }

  // Counts on from the tag before, so that a large file is gone through once.
  int line_at_tag() {
    line_ += static_cast<int>(std::count(text_.begin() + static_cast<long>(counted_),
                                         text_.begin() + static_cast<long>(at_), '\n'));
    counted_ = at_;
    return line_;
  }

  void skip_past(std::string_view end, const std::string& what) {
    const std::size_t found = text_.find(end, at_);
    if (found == std::string_view::npos) {
      fail(what + " starts here and never ends; expected '" + std::string(end) + "'");
    }
    at_ = found + end.size();
  }

  void skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) {
      ++at_;
    }
  }

  // An entity of XML's own or a character reference, or an error.
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
    if (entity.size() > 3 && entity[1] == '#') {
      const bool hex = entity[2] == 'x';
      const std::string_view digits = entity.substr(hex ? 3 : 2, entity.size() - (hex ? 4 : 3));
      const char* allowed = hex ? "0123456789abcdefABCDEF" : "0123456789";
      if (!digits.empty() && digits.find_first_not_of(allowed) == std::string_view::npos) {
        return;
      }
    }
    fail("'" + std::string(entity) +
         "' is not an entity that XML knows; write a bare ampersand as &amp;");
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
    tag.span.begin = at_;
    tag.line = line_at_tag();
    ++at_;
    if (at_ < text_.size() && text_[at_] == '/') {
      ++at_;
      tag.kind = Tag::Kind::end;
    }
    tag.name = name("the name of an element after \"<\"");
    while (true) {
      const std::size_t before = at_;
      skip_blanks();
      if (at_ >= text_.size()) {
        fail("the tag <" + std::string(tag.name) + "> starts here and never ends", tag.span.begin);
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
             " in the tag <" + std::string(tag.name) + ">, found '" + text_[at_] + "'");
      }
      if (tag.attributes.size() == kMostAttributes) {
        fail("<" + std::string(tag.name) + "> has more than " + std::to_string(kMostAttributes) +
             " attributes; no element has so many");
      }
      tag.attributes.push_back(attribute(before, tag));
    }
    tag.span.end = at_;
    return tag;
  }

  TagAttribute attribute(std::size_t before, const Tag& tag) {
    TagAttribute attribute;
    attribute.whole.begin = before;
    const std::string of = " of <" + std::string(tag.name) + ">";
    attribute.name = name("the name of an attribute" + of);
    for (const TagAttribute& other : tag.attributes) {
      if (other.name == attribute.name) {
        fail("the attribute '" + std::string(attribute.name) + "'" + of + " is given twice");
      }
    }
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != '=') {
      fail("expected =\"...\" after the attribute '" + std::string(attribute.name) + "'" + of);
    }
    ++at_;
    skip_blanks();
    const char quote = at_ < text_.size() ? text_[at_] : '\0';
    if (quote != '"' && quote != '\'') {
      fail("the value of the attribute '" + std::string(attribute.name) + "'" + of +
           " must stand in quotes");
    }
    const std::size_t end = text_.find(quote, at_ + 1);
    if (end == std::string_view::npos) {
      fail("the value of the attribute '" + std::string(attribute.name) + "'" + of +
           " has no closing quote");
    }
    attribute.value = {at_ + 1, end};
    for (++at_; at_ < end; ++at_) {
      if (text_[at_] == '<') {
        fail("the value of the attribute '" + std::string(attribute.name) + "'" + of +
             " holds a \"<\"; a quote may be missing, or write it as &lt;");
      }
      check_entity();
    }
    attribute.whole.end = at_ = end + 1;
    return attribute;
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  std::size_t counted_ = 0;  // up to here, line_ has counted
  int line_ = 1;
};

}  // namespace

std::vector<Tag> scan_tags(std::string_view text, const std::string& file) {
  return Scanner(text, file).scan();
}

}  // namespace elsie::world
