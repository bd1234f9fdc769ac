#include "world/words.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace elsie::desktop {
namespace {

/// The names of the vocabulary that translations know; in English, they are made into words by
/// rule.
[[maybe_unused]] constexpr const char* kTranslated[] = {
    QT_TRANSLATE_NOOP("Vocabulary", "world"),
    QT_TRANSLATE_NOOP("Vocabulary", "arena"),
    QT_TRANSLATE_NOOP("Vocabulary", "floor"),
    QT_TRANSLATE_NOOP("Vocabulary", "limits"),
    QT_TRANSLATE_NOOP("Vocabulary", "physics"),
    QT_TRANSLATE_NOOP("Vocabulary", "robots"),
    QT_TRANSLATE_NOOP("Vocabulary", "robot"),
    QT_TRANSLATE_NOOP("Vocabulary", "sensors"),
    QT_TRANSLATE_NOOP("Vocabulary", "sensor"),
    QT_TRANSLATE_NOOP("Vocabulary", "behaviors"),
    QT_TRANSLATE_NOOP("Vocabulary", "behavior"),
    QT_TRANSLATE_NOOP("Vocabulary", "coordinator"),
    QT_TRANSLATE_NOOP("Vocabulary", "drive"),
    QT_TRANSLATE_NOOP("Vocabulary", "localisation"),
    QT_TRANSLATE_NOOP("Vocabulary", "actuators"),
    QT_TRANSLATE_NOOP("Vocabulary", "actuator"),
    QT_TRANSLATE_NOOP("Vocabulary", "body"),
    QT_TRANSLATE_NOOP("Vocabulary", "obstacles"),
    QT_TRANSLATE_NOOP("Vocabulary", "static_box"),
    QT_TRANSLATE_NOOP("Vocabulary", "dynamic_box"),
    QT_TRANSLATE_NOOP("Vocabulary", "moving_box"),
    QT_TRANSLATE_NOOP("Vocabulary", "static_cylinder"),
    QT_TRANSLATE_NOOP("Vocabulary", "dynamic_cylinder"),
    QT_TRANSLATE_NOOP("Vocabulary", "moving_cylinder"),
    QT_TRANSLATE_NOOP("Vocabulary", "static_sphere"),
    QT_TRANSLATE_NOOP("Vocabulary", "dynamic_sphere"),
    QT_TRANSLATE_NOOP("Vocabulary", "moving_sphere"),
    QT_TRANSLATE_NOOP("Vocabulary", "static_prism"),
    QT_TRANSLATE_NOOP("Vocabulary", "dynamic_prism"),
    QT_TRANSLATE_NOOP("Vocabulary", "moving_prism"),
    QT_TRANSLATE_NOOP("Vocabulary", "waypoint"),
    QT_TRANSLATE_NOOP("Vocabulary", "point"),
    QT_TRANSLATE_NOOP("Vocabulary", "resources"),
    QT_TRANSLATE_NOOP("Vocabulary", "resource"),
    QT_TRANSLATE_NOOP("Vocabulary", "chargers"),
    QT_TRANSLATE_NOOP("Vocabulary", "charger"),
    QT_TRANSLATE_NOOP("Vocabulary", "nests"),
    QT_TRANSLATE_NOOP("Vocabulary", "nest"),
    QT_TRANSLATE_NOOP("Vocabulary", "lamps"),
    QT_TRANSLATE_NOOP("Vocabulary", "lamp"),
    QT_TRANSLATE_NOOP("Vocabulary", "patches"),
    QT_TRANSLATE_NOOP("Vocabulary", "patch"),
    QT_TRANSLATE_NOOP("Vocabulary", "line"),
    QT_TRANSLATE_NOOP("Vocabulary", "fields"),
    QT_TRANSLATE_NOOP("Vocabulary", "field"),
    QT_TRANSLATE_NOOP("Vocabulary", "goals"),
    QT_TRANSLATE_NOOP("Vocabulary", "goal"),
    QT_TRANSLATE_NOOP("Vocabulary", "measures"),
    QT_TRANSLATE_NOOP("Vocabulary", "rules"),
    QT_TRANSLATE_NOOP("Vocabulary", "teams"),
    QT_TRANSLATE_NOOP("Vocabulary", "team"),
    QT_TRANSLATE_NOOP("Vocabulary", "noise"),
    QT_TRANSLATE_NOOP("Vocabulary", "failure"),
    QT_TRANSLATE_NOOP("Vocabulary", "state"),
    QT_TRANSLATE_NOOP("Vocabulary", "states"),
    QT_TRANSLATE_NOOP("Vocabulary", "format"),
    QT_TRANSLATE_NOOP("Vocabulary", "name"),
    QT_TRANSLATE_NOOP("Vocabulary", "id"),
    QT_TRANSLATE_NOOP("Vocabulary", "description"),
    QT_TRANSLATE_NOOP("Vocabulary", "template"),
    QT_TRANSLATE_NOOP("Vocabulary", "colour"),
    QT_TRANSLATE_NOOP("Vocabulary", "heading_deg"),
    QT_TRANSLATE_NOOP("Vocabulary", "length"),
    QT_TRANSLATE_NOOP("Vocabulary", "width"),
    QT_TRANSLATE_NOOP("Vocabulary", "height"),
    QT_TRANSLATE_NOOP("Vocabulary", "radius"),
    QT_TRANSLATE_NOOP("Vocabulary", "mass"),
    QT_TRANSLATE_NOOP("Vocabulary", "friction"),
    QT_TRANSLATE_NOOP("Vocabulary", "bounce"),
    QT_TRANSLATE_NOOP("Vocabulary", "speed"),
    QT_TRANSLATE_NOOP("Vocabulary", "max_speed"),
    QT_TRANSLATE_NOOP("Vocabulary", "battery"),
    QT_TRANSLATE_NOOP("Vocabulary", "energy"),
    QT_TRANSLATE_NOOP("Vocabulary", "energy_cost"),
    QT_TRANSLATE_NOOP("Vocabulary", "leader"),
    QT_TRANSLATE_NOOP("Vocabulary", "coverage"),
    QT_TRANSLATE_NOOP("Vocabulary", "clearance"),
    QT_TRANSLATE_NOOP("Vocabulary", "priority"),
    QT_TRANSLATE_NOOP("Vocabulary", "weight"),
    QT_TRANSLATE_NOOP("Vocabulary", "time"),
    QT_TRANSLATE_NOOP("Vocabulary", "wall_time"),
    QT_TRANSLATE_NOOP("Vocabulary", "wall_height"),
    QT_TRANSLATE_NOOP("Vocabulary", "wall_thickness"),
    QT_TRANSLATE_NOOP("Vocabulary", "walls"),
    QT_TRANSLATE_NOOP("Vocabulary", "steps"),
    QT_TRANSLATE_NOOP("Vocabulary", "step"),
    QT_TRANSLATE_NOOP("Vocabulary", "control_steps"),
    QT_TRANSLATE_NOOP("Vocabulary", "gravity"),
    QT_TRANSLATE_NOOP("Vocabulary", "engine"),
    QT_TRANSLATE_NOOP("Vocabulary", "count"),
    QT_TRANSLATE_NOOP("Vocabulary", "distance"),
    QT_TRANSLATE_NOOP("Vocabulary", "duration"),
    QT_TRANSLATE_NOOP("Vocabulary", "start"),
    QT_TRANSLATE_NOOP("Vocabulary", "rate"),
    QT_TRANSLATE_NOOP("Vocabulary", "spread"),
    QT_TRANSLATE_NOOP("Vocabulary", "half_life"),
    QT_TRANSLATE_NOOP("Vocabulary", "cell"),
    QT_TRANSLATE_NOOP("Vocabulary", "image"),
    QT_TRANSLATE_NOOP("Vocabulary", "image_length"),
    QT_TRANSLATE_NOOP("Vocabulary", "image_width"),
    QT_TRANSLATE_NOOP("Vocabulary", "axle"),
    QT_TRANSLATE_NOOP("Vocabulary", "gap"),
    QT_TRANSLATE_NOOP("Vocabulary", "wheel_radius"),
    QT_TRANSLATE_NOOP("Vocabulary", "wheel_width"),
    QT_TRANSLATE_NOOP("Vocabulary", "wheel_mass"),
    QT_TRANSLATE_NOOP("Vocabulary", "wheel_slip"),
    QT_TRANSLATE_NOOP("Vocabulary", "wheel_torque"),
    QT_TRANSLATE_NOOP("Vocabulary", "pitch_deg"),
    QT_TRANSLATE_NOOP("Vocabulary", "yaw_deg"),
    QT_TRANSLATE_NOOP("Vocabulary", "max_pitch_deg"),
    QT_TRANSLATE_NOOP("Vocabulary", "max_yaw_deg"),
    QT_TRANSLATE_NOOP("Vocabulary", "seen_by_range_sensors"),
    QT_TRANSLATE_NOOP("Vocabulary", "hands"),
    QT_TRANSLATE_NOOP("Vocabulary", "full"),
    QT_TRANSLATE_NOOP("Vocabulary", "hitch"),
    QT_TRANSLATE_NOOP("Vocabulary", "hitch_height"),
    QT_TRANSLATE_NOOP("Vocabulary", "observe"),
    QT_TRANSLATE_NOOP("Vocabulary", "act"),
    QT_TRANSLATE_NOOP("Vocabulary", "path"),
};

}  // namespace

QString in_words(const QString& name, const QString& unit) {
  const QByteArray source = name.toUtf8();
  if (const QString word = QCoreApplication::translate("Vocabulary", source); word != name) {
    return word;
  }
  static const QRegularExpression not_letters("[^a-z0-9]+");
  QString words = name;
  if (const QString end = '_' + QString(unit).replace(not_letters, "_");
      !unit.isEmpty() && words.endsWith(end)) {
    words.chop(end.size());
  }
  words.replace('_', ' ');
  // One letter is a name, as x is.
  return words.size() > 1 ? words.left(1).toUpper() + words.mid(1) : words;
}

QString unit_in_words(const QString& unit) {
  return unit == "deg" ? QString("\u00b0") : unit == "deg/s" ? QString("\u00b0/s") : unit;
}

}  // namespace elsie::desktop
