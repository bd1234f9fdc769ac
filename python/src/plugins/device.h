// What sensors and actuators in Python share: a struct with a layout of run time.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "elsie/api/disturbance.h"
#include "elsie/base/error.h"

#include "scripted.h"
#include "struct_layout.h"

namespace elsie::python {

/// A Sensor or Actuator that a script implements, with its reading or command. It does what
/// elsie::Holding does for structs of C++.
template <class Base>
class ScriptedDevice : public ScriptedPlugin<Base> {
 public:
  ScriptedDevice(ScriptClassRef of, std::shared_ptr<const StructLayout> layout)
      : ScriptedPlugin<Base>(std::move(of)), layout_(std::move(layout)), value_(layout_->blank()) {}

  ReadingKind kind() const final { return layout_->kind(); }
  const void* value() const final { return value_.get(); }
  void* own_value() final { return value_.get(); }
  const void* undisturbed() const final { return (undisturbed_ ? undisturbed_ : value_).get(); }
  void forget() final {
    layout_->clear(value_.get());
    if (undisturbed_) layout_->clear(undisturbed_.get());
  }
  bool fit_value() final {
    if (this->disturbances().empty()) {
      undisturbed_.reset();
    } else if (!undisturbed_) {
      undisturbed_ = layout_->blank();
      layout_->copy(value_.get(), undisturbed_.get());
    }
    return false;  // arrays have sizes of the class
  }
  void visit_fields(const void* value, const FieldVisit& visit) const final {
    layout_->visit(value, visit);
  }
  std::shared_ptr<void> new_value() const final { return layout_->blank(); }
  void copy_value(const void* from, void* to) const final { layout_->copy(from, to); }

 protected:
  const StructLayout& layout() const { return *layout_; }
  void* in_work() { return (undisturbed_ ? undisturbed_ : value_).get(); }
  void check(const void* value) const { layout_->check(value, this->value_name()); }

 private:
  std::shared_ptr<const StructLayout> layout_;
  std::shared_ptr<void> value_;
  std::shared_ptr<void> undisturbed_;  // null: the present struct is
};

}  // namespace elsie::python
