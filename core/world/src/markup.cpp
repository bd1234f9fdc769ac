#include "elsie/world/markup.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "elsie/base/read_whole.h"
#include "elsie/plugin/parameters.h"
#include "elsie/world/error.h"
#include "elsie/world/escaped.h"
#include "elsie/world/files.h"

namespace elsie::world {
namespace {
namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& file, int line, const std::string& message) {
  throw WorldError({{file, line, message}});
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
