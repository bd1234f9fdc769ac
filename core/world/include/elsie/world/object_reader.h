// Reads the tree of a file into objects, by a vocabulary: for files of any kind.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "elsie/world/error.h"
#include "elsie/world/markup.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// Walks the tree and the vocabulary in parallel. Unknown elements and attributes, values that are
/// not allowed and missing ones become problems; their members keep the defaults.
class ObjectReader {
 public:
  explicit ObjectReader(Problems& problems) : problems_(problems) {}
  virtual ~ObjectReader() = default;
  ObjectReader(const ObjectReader&) = delete;
  ObjectReader& operator=(const ObjectReader&) = delete;

  /// Returns whether the attributes of the element, and of the elements that describe the object
  /// further, have no mistakes.
  bool read_object(const ElementSpec& spec, const Element& element, void* object);

 protected:
  // For readers of vocabularies in which plugins are used.
  virtual bool read_use(const ElementSpec& spec, const Element& element, void* object);
  // Called before and after the object of a child is read.
  virtual void begin(const Element&) {}
  virtual void end(const ElementSpec&, const Element&, bool /*sound*/) {}
  // Called for an attribute that names something that must exist elsewhere.
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

/// Adds a problem and raises all of them when the root element is not `name` in this format: a file
/// of another format has another vocabulary. `hints` has a sentence for other root elements.
void check_root(const Element& root, const std::string& name, int format,
                const std::map<std::string, std::string>& hints, Problems& problems);

}  // namespace elsie::world
