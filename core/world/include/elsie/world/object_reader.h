// Fills objects with what the tree of a file says, by a vocabulary: for files of any kind.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "elsie/world/error.h"
#include "elsie/world/markup.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// Walks the tree and the vocabulary side by side. Elements and attributes that the vocabulary does
/// not have, values that it does not allow and what is missing become problems; the members that
/// they would have filled keep their defaults.
class ObjectReader {
 public:
  explicit ObjectReader(Problems& problems) : problems_(problems) {}
  virtual ~ObjectReader() = default;
  ObjectReader(const ObjectReader&) = delete;
  ObjectReader& operator=(const ObjectReader&) = delete;

  /// Whether the object is as its element says: whether the element's own attributes are without
  /// mistakes, and those of the elements that describe it further.
  bool read_object(const ElementSpec& spec, const Element& element, void* object);

 protected:
  // For readers of vocabularies in which plugins are used.
  virtual bool read_use(const ElementSpec& spec, const Element& element, void* object);
  // The object of a child was made and is about to be read; it was read.
  virtual void begin(const Element&) {}
  virtual void end(const ElementSpec&, const Element&, bool /*sound*/) {}
  // The attribute names something that must exist elsewhere.
  virtual void mention(const AttributeSpec&, const Attribute&, const Element&) {}

  bool read_child(const ElementSpec& spec, const Element& element, void* parent);
  bool read_attribute(const ElementSpec& spec, const Element& element, const Attribute& attribute,
                      void* object);
  bool has_required(const std::vector<Field>& fields, const Element& element);
  void refuse_text(const Element& element);
  void refuse_attribute(const Element& element, const Attribute& attribute,
                        const std::vector<std::string>& names);
  Problems& problems() { return problems_; }

 private:
  bool read_children(const ElementSpec& spec, const Element& element, void* object);
  const ElementSpec* spec_of(const ElementSpec& parent, const Element& child);

  Problems& problems_;
};

/// Adds a problem and raises all when the element is not `name` in this format: a file in another
/// format has another vocabulary, and nothing else in it is looked at. `hints` says of other root
/// elements what their files are.
void check_root(const Element& root, const std::string& name, int format,
                const std::map<std::string, std::string>& hints, Problems& problems);

}  // namespace elsie::world
