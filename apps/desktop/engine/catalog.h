// What a world may contain: the vocabulary of world files and the declarations of all plugins that
// the engine has found.
#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "engine/elements.h"

namespace elsie::desktop {

/// An attribute of an element, or a parameter of a plugin.
struct Field {
  QString name;
  QString type;  // "number", "integer", "boolean", "text", "file", "id", "colour"; see Catalog
  QString unit;
  QString default_text;  // as written in a file; "" if there is none
  QString meaning;
  QString range;        // "at least 0 and at most 1"; "" if unlimited
  QStringList choices;  // if not empty, the only values
  std::optional<double> least, most;
  bool is_required = false;
};

/// A plugin, an element that a plugin declares, or an element of the vocabulary.
struct Kind {
  QString name;
  QString description;
  std::vector<Field> fields;
  bool holds_behaviors = false;
  bool is_of_plugin = false;    // a plugin, or an element that one declares
  bool can_be_removed = false;  // has the attribute `remove`, which is not among the fields
  QStringList elements;         // names of the elements that may stand in it
  QStringList needs, produces;  // kinds of readings, such as "range"
};

class Catalog {
 public:
  Catalog() = default;
  explicit Catalog(Json answer) : answer_(std::move(answer)) {}

  const Json& json() const { return answer_; }
  bool is_empty() const { return answer_.is_null(); }
  /// All plugins of a kind, by name: "sensor", "behavior", "coordinator", "measure", "drive".
  std::vector<Kind> plugins(const QString& kind) const;
  /// The elements that may be members of a list: "static_box"... of "obstacles".
  std::vector<Kind> members(const QString& list) const;
  /// The kind of the element at a place, with all that it may be given; none if it is unknown.
  std::optional<Kind> kind_of(const ElementPlace& place) const;
  /// The same for the last of these elements, each of which stands in the one before.
  std::optional<Kind> kind_of(const QStringList& names) const;
  /// The elements of a plugin that may stand in the element at a place, at whatever depth.
  std::vector<Kind> declared_in(const ElementPlace& place) const;
  /// An element of the vocabulary by name: "robot", "physics".
  std::optional<Kind> element(const QString& name) const;

 private:
  Json answer_;
};

}  // namespace elsie::desktop
