#include "elsie/world/markup.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>
#include <utility>

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
  const std::size_t key = text.find("encoding");
  if (!text.starts_with("xml") || key == std::string_view::npos) {
    return;
  }
  const std::size_t open = text.find_first_of("\"'", key);
  const std::size_t close =
      open == std::string_view::npos ? open : text.find_first_of("\"'", open + 1);
  if (close == std::string_view::npos) {
    return;
  }
  const std::string encoding(text.substr(open + 1, close - open - 1));
  std::string lower = encoding;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (lower != "utf-8" && lower != "us-ascii") {
    fail(file, declaration->GetLineNum(),
         "the encoding '" + encoding + "' is not supported; save the file as UTF-8");
  }
}

// That every element is closed by its own tag, that there is one root, and that nothing is nested
// deeper than what is parsed by recursion later can bear.
void check_nesting(const std::vector<Tag>& tags, const std::string& file, const std::string& kind) {
  constexpr std::size_t kDeepest = 50;
  std::vector<const Tag*> open;
  bool rooted = false;
  for (const Tag& tag : tags) {
    const int line = tag.line;
    const std::string name(tag.name);
    if (tag.kind == Tag::Kind::end) {
      if (open.empty()) {
        fail(file, line, "</" + name + "> closes nothing");
      }
      if (open.back()->name != tag.name) {
        const std::string expected(open.back()->name);
        fail(file, line,
             "</" + name + "> stands where </" + expected + "> was expected: <" + expected +
                 "> starts on line " + std::to_string(open.back()->line));
      }
      open.pop_back();
      continue;
    }
    if (open.empty() && rooted) {
      fail(file, line, "a second root element, <" + name + ">; a file holds one");
    }
    rooted = true;
    if (tag.kind == Tag::Kind::start) {
      open.push_back(&tag);
      if (open.size() > kDeepest) {
        fail(file, line,
             "elements are nested deeper than " + std::to_string(kDeepest) + " levels; no " + kind +
                 " needs that many");
      }
    }
  }
  if (!open.empty()) {
    const std::string name(open.back()->name);
    fail(file, open.back()->line, "<" + name + "> is never closed; expected </" + name + ">");
  }
  if (!rooted) {
    fail(file, 0,
         "there is no element in the file; expected <" + kind + " format=\"1\"> ... </" + kind +
             ">");
  }
}

Element converted(const tinyxml2::XMLElement& source, const std::string& file,
                  std::size_t& counter) {
  Element element;
  element.name = source.Name();
  element.where = {file, source.GetLineNum()};
  element.number = counter++;
  for (const auto* a = source.FirstAttribute(); a; a = a->Next()) {
    element.attributes.push_back({a->Name(), a->Value(), {file, a->GetLineNum()}});
  }
  for (const auto* node = source.FirstChild(); node; node = node->NextSibling()) {
    if (const auto* child = node->ToElement()) {
      element.children.push_back(converted(*child, file, counter));
    } else if (const auto* text = node->ToText(); text && element.text.empty()) {
      const std::string_view found = text->Value();
      const std::size_t begin = std::min(found.find_first_not_of(" \t\r\n"), found.size());
      element.text = found.substr(begin, found.find_last_not_of(" \t\r\n") + 1 - begin);
      element.text_line = text->GetLineNum();  // of the first that is not blank
    }
  }
  return element;
}

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
    return base::read_whole(file, kLargestFile);
  } catch (const std::runtime_error& why) {
    fail(file, 0, std::string("this ") + why.what() + "; expected an XML file");
  }
}

Element parse_markup(std::string_view text, const std::string& file, const std::string& kind) {
  check_characters(text, file);
  check_nesting(scan_tags(text, file), file, kind);

  tinyxml2::XMLDocument document;
  document.Parse(text.data(), text.size());
  if (document.ErrorID() == tinyxml2::XML_ERROR_PARSING_TEXT) {
    fail(file, document.ErrorLineNum(), "there is text outside of the root element");
  }
  if (document.ErrorID() == tinyxml2::XML_ERROR_PARSING_DECLARATION) {
    fail(file, document.ErrorLineNum(),
         "a processing instruction <?...?> may stand at the top of the file only");
  }
  if (document.Error() || !document.RootElement()) {
    fail(file, document.ErrorLineNum(), "this is not well-formed XML");
  }
  check_encoding(document, file);
  for (const auto* node = document.FirstChild(); node; node = node->NextSibling()) {
    if (node->ToText()) {
      fail(file, node->GetLineNum(), "there is text outside of the root element");
    }
  }
  std::size_t counter = 0;
  return converted(*document.RootElement(), file, counter);
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
