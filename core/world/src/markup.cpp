#include "elsie/world/markup.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include <strings.h>
#include <tinyxml2.h>

#include "elsie/base/read_whole.h"
#include "elsie/plugin/parameters.h"
#include "elsie/world/error.h"
#include "elsie/world/escaped.h"
#include "elsie/world/files.h"

#include "text_check.h"

namespace elsie::world {
namespace {
namespace fs = std::filesystem;

constexpr std::string_view kBlanks = " \t\r\n";
constexpr const char* kTextOutside = "there is text outside of the root element";

[[noreturn]] void fail(const std::string& file, int line, const std::string& message) {
  throw WorldError({{file, line, message}});
}

// <?xml ... encoding="..."?>
void check_encoding(const tinyxml2::XMLDocument& document, const std::string& file) {
  const tinyxml2::XMLNode* first = document.FirstChild();
  const tinyxml2::XMLDeclaration* declaration = first ? first->ToDeclaration() : nullptr;
  const std::string_view text = declaration ? declaration->Value() : "";
  const std::size_t open = text.find_first_of("\"'", text.find("encoding"));
  const std::size_t close = text.find_first_of("\"'", open == text.npos ? open : open + 1);
  if (!text.starts_with("xml") || close == text.npos) return;
  const std::string encoding(text.substr(open + 1, close - open - 1));
  if (strcasecmp(encoding.c_str(), "utf-8") != 0 && strcasecmp(encoding.c_str(), "us-ascii") != 0) {
    fail(file, declaration->GetLineNum(),
         "the encoding '" + encoding + "' is not supported; save the file as UTF-8");
  }
}

Element element_of(const tinyxml2::XMLElement& source, const base::SharedText& file) {
  Element element;
  element.name = source.Name();
  element.where = {file, source.GetLineNum()};
  for (const auto* a = source.FirstAttribute(); a; a = a->Next()) {
    element.attributes.push_back({a->Name(), a->Value(), {file, a->GetLineNum()}});
  }
  for (const auto* node = source.FirstChild(); node; node = node->NextSibling()) {
    if (const auto* child = node->ToElement()) {
      element.children.push_back(element_of(*child, file));
    } else if (const auto* text = node->ToText(); text && element.text.empty()) {
      const std::string_view found = text->Value();
      const std::size_t begin = std::min(found.find_first_not_of(kBlanks), found.size());
      element.text = found.substr(begin, found.find_last_not_of(kBlanks) + 1 - begin);
      element.text_line = text->GetLineNum();  // the line of the first non-blank text
    }
  }
  return element;
}
}  // namespace

const Attribute* Element::find(std::string_view attribute) const {
  return plugin::find_declared(attributes, attribute);
}

std::string Element::value(std::string_view attribute) const {
  const Attribute* found = find(attribute);
  return found ? found->value : std::string();
}

void Element::set(std::string_view attribute, std::string value, const Location& location) {
  if (const Attribute* known = find(attribute)) {
    attributes[static_cast<std::size_t>(known - attributes.data())] = {known->name,
                                                                       std::move(value), location};
  } else {
    attributes.push_back({std::string(attribute), std::move(value), location});
  }
}

void Element::erase(std::string_view attribute) {
  std::erase_if(attributes, [&](const Attribute& a) { return a.name == attribute; });
}

Element* Element::child(std::string_view child_name) {
  return const_cast<Element*>(std::as_const(*this).child(child_name));
}

const Element* Element::child(std::string_view child_name) const {
  return plugin::find_declared(children, child_name);
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
    const fs::path path(file);
    fail(file, 0,
         "there is no such file" +
             did_you_mean_file(path.filename().string(), {path.parent_path().string()}));
  }
  try {
    return base::read_whole(file, 256'000'000);
  } catch (const std::runtime_error& why) {
    fail(file, 0, std::string("this ") + why.what() + "; expected an XML file");
  }
}

Element parse_markup(std::string_view text, const std::string& file, const std::string& kind,
                     std::vector<ElementSpan>* spans) {
  std::vector<ElementSpan> places;
  if (spans || !is_plain(text)) places = check_text(text, file, kind);
  if (spans) *spans = std::move(places);
  tinyxml2::XMLDocument document;
  document.Parse(text.data(), text.size());
  const tinyxml2::XMLElement* root = document.RootElement();
  if (document.Error() || !root || root->NextSiblingElement()) {
    check_text(text, file, kind);  // which knows more about most mistakes
    fail(file, document.ErrorLineNum(),
         document.ErrorID() == tinyxml2::XML_ERROR_PARSING_TEXT ? kTextOutside
         : document.ErrorID() == tinyxml2::XML_ERROR_PARSING_DECLARATION
             ? "a processing instruction <?...?> may stand at the top of the file only"
             : "this is not well-formed XML");
  }
  check_encoding(document, file);
  for (const auto* node = document.FirstChild(); node; node = node->NextSibling()) {
    if (node->ToText()) {
      fail(file, node->GetLineNum(), kTextOutside);
    }
  }
  return element_of(*root, file);
}

std::string in_words(const Attribute& attribute, const Element& element) {
  return attribute.name + "=\"" + attribute.value + "\" of <" + element.name + ">";
}

std::string start_tag(const Element& element) {
  std::string text = "<" + element.name;
  for (const Attribute& attribute : element.attributes) {
    text += " " + attribute.name + "=\"" + escaped_attribute(attribute.value) + "\"";
  }
  return text;
}

std::string markup_of(const Element& element) {
  if (element.children.empty() && element.text.empty()) return start_tag(element) + "/>";
  std::string text = start_tag(element) + ">" + escaped_attribute(element.text);
  for (const Element& child : element.children) {
    text += markup_of(child);
  }
  return text + "</" + element.name + ">";
}

}  // namespace elsie::world
