#include "elsie/world/markup.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include <strings.h>
#include <tinyxml2.h>

#include "elsie/base/read_whole.h"
#include "elsie/base/utf8.h"
#include "elsie/world/error.h"
#include "elsie/world/escaped.h"
#include "elsie/world/files.h"

#include "tags.h"

namespace elsie::world {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBlanks = " \t\r\n";

[[noreturn]] void fail(const std::string& file, int line, const std::string& message) {
  throw WorldError({{file, line, message}});
}

int line_of(std::string_view text, std::size_t place) {
  return 1 +
         static_cast<int>(std::count(text.begin(), text.begin() + static_cast<long>(place), '\n'));
}

void check_characters(std::string_view text, const std::string& file) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    fail(file, 0, "this file is in UTF-16; save it as UTF-8");
  }
  const std::size_t zero = text.find('\0');
  if (zero != std::string_view::npos) {
    fail(file, line_of(text, zero), "this is not an XML file: it holds a zero byte");
  }
  const std::size_t bad = base::first_invalid(text);
  if (bad < text.size()) {
    fail(file, line_of(text, bad), "this is not UTF-8 text; save the file as UTF-8");
  }
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c < 0x20 && c != '\t' && c != '\n' && c != '\r') {
      fail(file, line_of(text, i),
           "this is not an XML file: it holds the control character " + std::to_string(c));
    }
  }
}

// <?xml ... encoding="..."?>
void check_encoding(const tinyxml2::XMLDocument& document, const std::string& file) {
  const tinyxml2::XMLNode* first = document.FirstChild();
  const tinyxml2::XMLDeclaration* declaration = first ? first->ToDeclaration() : nullptr;
  const std::string_view text = declaration ? declaration->Value() : "";
  const std::size_t open = text.find_first_of("\"'", text.find("encoding"));
  const std::size_t close = text.find_first_of("\"'", open == text.npos ? open : open + 1);
  if (!text.starts_with("xml") || close == text.npos) {
    return;
  }
  const std::string encoding(text.substr(open + 1, close - open - 1));
  if (strcasecmp(encoding.c_str(), "utf-8") != 0 && strcasecmp(encoding.c_str(), "us-ascii") != 0) {
    fail(file, declaration->GetLineNum(),
         "the encoding '" + encoding + "' is not supported; save the file as UTF-8");
  }
}

// Whether tinyxml2 might accept a mistake in this text, or take very long to read it: it drops some
// wrong character references, accepts "< a>", "</ a>", "</a/>", "</a b='1'>" and "<" in values, and
// compares each attribute with all before it.
bool is_doubtful(std::string_view text) {
  if (text.find("&#") != std::string_view::npos) {
    return true;
  }
  for (std::size_t at = text.find('<'); at < text.size(); at = text.find('<', at)) {
    const bool is_end = text.substr(at + 1).starts_with('/');
    const bool has_values = !text.substr(at + 1).starts_with('!');  // comments have apostrophes
    const std::size_t name = at + (is_end ? 2 : 1);
    if (name >= text.size() || kBlanks.find(text[name]) != std::string_view::npos) {
      return true;
    }
    std::size_t equals = 0;
    char quote = '\0';
    for (at = name; at < text.size() && (quote != '\0' || text[at] != '>'); ++at) {
      const char c = text[at];
      equals += c == '=' ? 1 : 0;
      if (c == '<' || equals > kMostAttributes || (is_end && (c == '=' || c == '/'))) {
        return true;
      }
      if (c == quote) {
        quote = '\0';
      } else if (has_values && quote == '\0' && (c == '"' || c == '\'')) {
        quote = c;
      }
    }
  }
  return false;
}

// Converts tinyxml2's elements, and notes signs of mistakes that it accepts.
class Converter {
 public:
  explicit Converter(const std::string& file) : file_(file) {}

  Element element(const tinyxml2::XMLElement& source, std::size_t depth = 1) {
    Element element;
    element.name = source.Name();
    element.where = {file_, source.GetLineNum()};
    doubt_ |= depth > kDeepest;
    closed_ += source.ClosingType() == tinyxml2::XMLElement::OPEN ? 1 : 0;
    for (const auto* a = source.FirstAttribute(); a; a = a->Next()) {
      // tinyxml2 leaves names where they stand in its copy of the text.
      doubt_ |= !element.attributes.empty() && kBlanks.find(a->Name()[-1]) == kBlanks.npos;
      element.attributes.push_back({a->Name(), a->Value(), {file_, a->GetLineNum()}});
      doubt_ |= element.attributes.back().value.find('&') != std::string::npos;
    }
    for (const auto* node = source.FirstChild(); node; node = node->NextSibling()) {
      if (const auto* child = node->ToElement()) {
        element.children.push_back(this->element(*child, depth + 1));
      } else if (const auto* text = node->ToText()) {
        const std::string_view found = text->Value();
        doubt_ |= found.find('&') != std::string_view::npos;
        if (element.text.empty()) {
          const std::size_t begin = std::min(found.find_first_not_of(kBlanks), found.size());
          element.text = found.substr(begin, found.find_last_not_of(kBlanks) + 1 - begin);
          element.text_line = text->GetLineNum();  // of the first that is not blank
        }
      } else {
        doubt_ |= node->ToUnknown() != nullptr;
      }
    }
    return element;
  }

  // After the root was converted: whether all else is as it should be.
  bool accepts(const tinyxml2::XMLDocument& document, std::string_view text) {
    std::size_t end_tags = 0;
    for (std::size_t at = text.find("</"); at < text.size(); at = text.find("</", at + 2)) {
      ++end_tags;
    }
    for (const auto* node = document.FirstChild(); node; node = node->NextSibling()) {
      doubt_ |= node->ToUnknown() || (node->ToElement() && node != document.RootElement());
    }
    return !doubt_ && end_tags == closed_;  // tinyxml2 stops at an end tag that closes nothing
  }

 private:
  const std::string& file_;
  bool doubt_ = false;
  std::size_t closed_ = 0;  // elements with an end tag
};

}  // namespace

const Attribute* Element::find(std::string_view attribute) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const Attribute& a) { return a.name == attribute; });
  return found == attributes.end() ? nullptr : &*found;
}

std::string Element::value(std::string_view attribute) const {
  const Attribute* found = find(attribute);
  return found ? found->value : std::string();
}

void Element::set(std::string_view attribute, std::string value, const Location& place) {
  for (Attribute& a : attributes) {
    if (a.name == attribute) {
      a.value = std::move(value);
      a.where = place;
      return;
    }
  }
  attributes.push_back({std::string(attribute), std::move(value), place});
}

void Element::erase(std::string_view attribute) {
  std::erase_if(attributes, [&](const Attribute& a) { return a.name == attribute; });
}

Element* Element::child(std::string_view child_name) {
  return const_cast<Element*>(std::as_const(*this).child(child_name));
}

const Element* Element::child(std::string_view child_name) const {
  const auto found = std::find_if(children.begin(), children.end(),
                                  [&](const Element& e) { return e.name == child_name; });
  return found == children.end() ? nullptr : &*found;
}

std::string read_text(const std::string& file) {
  if (file.empty()) {
    fail("''", 0, "the name of a file is missing; expected that of an XML file");
  }
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) {
    std::error_code ignored;
    if (fs::is_symlink(file, ignored)) {
      fail(file, 0,
           error == std::errc::too_many_symbolic_link_levels
               ? "this is a link that leads back to itself; expected an XML file"
               : "this is a link to '" + fs::read_symlink(file, ignored).string() +
                     "', but there is no such file");
    }
    const std::string near = near_file(file);
    fail(file, 0,
         "there is no such file" +
             (near.empty() ? "" : "; did you mean '" + fs::path(near).filename().string() + "'?"));
  }
  try {
    return base::read_whole(file, 32'000'000);
  } catch (const std::runtime_error& why) {
    fail(file, 0, std::string("this ") + why.what() + "; expected an XML file");
  }
}

Element parse_markup(std::string_view text, const std::string& file, const std::string& kind) {
  check_characters(text, file);
  if (is_doubtful(text)) {
    check_tags(text, file, kind);
  }
  tinyxml2::XMLDocument document;
  document.Parse(text.data(), text.size());
  if (document.Error() || !document.RootElement()) {
    check_tags(text, file, kind);
    fail(file, document.ErrorLineNum(),
         document.ErrorID() == tinyxml2::XML_ERROR_PARSING_TEXT
             ? "there is text outside of the root element"
         : document.ErrorID() == tinyxml2::XML_ERROR_PARSING_DECLARATION
             ? "a processing instruction <?...?> may stand at the top of the file only"
             : "this is not well-formed XML");
  }
  Converter converter(file);
  Element root = converter.element(*document.RootElement());
  if (!converter.accepts(document, text)) {
    check_tags(text, file, kind);
  }
  check_encoding(document, file);
  for (const auto* node = document.FirstChild(); node; node = node->NextSibling()) {
    if (node->ToText()) {
      fail(file, node->GetLineNum(), "there is text outside of the root element");
    }
  }
  return root;
}

std::string in_words(const Attribute& attribute, const Element& element) {
  return attribute.name + "=\"" + attribute.value + "\" of <" + element.name + ">";
}

std::string markup_of(const Element& element) {
  std::string text = "<" + element.name;
  for (const Attribute& attribute : element.attributes) {
    text += " " + attribute.name + "=\"" + escaped_attribute(attribute.value) + "\"";
  }
  if (element.children.empty() && element.text.empty()) {
    return text + "/>";
  }
  text += ">" + escaped_attribute(element.text);
  for (const Element& child : element.children) {
    text += markup_of(child);
  }
  return text + "</" + element.name + ">";
}

}  // namespace elsie::world
