// What robots say to each other.
//
// A message is a plain struct that names itself, like a reading:
//
//   struct Offer {
//     static constexpr const char* kind = "offer";
//     double x = 0.0, y = 0.0;
//     template <class Visitor>
//     void visit(Visitor&& visitor) const { visitor("x", x, "m"); visitor("y", y, "m"); }
//   };
//
// A behaviour says it: response.say(Offer{1.0, 2.0}). An actuator sends it (radio,
// range_and_bearing), and robots with the same actuator hear it: now.heard<Offer>().
#pragma once

#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "elsie/api/geometry.h"
#include "elsie/api/reading.h"

namespace elsie {

/// A message without the type of its content.
class AnyMessage {
 public:
  /// Throws std::invalid_argument with a sentence if a number of the content is not finite.
  template <class Content>
  explicit AnyMessage(Content content)
      : kind_(ReadingKind::of<Content>()),
        content_(std::make_shared<const Content>(std::move(content))),
        visit_([](const void* of, const FieldVisit& visit) {
          elsie::visit_fields(*static_cast<const Content*>(of), visit);
        }) {
    static_assert(std::is_trivially_copyable_v<Content>,
                  "a message is a plain struct: numbers, and arrays of a fixed length");
    if constexpr (kListsFields<Content>) {
      detail::ReadingCheck check;
      static_cast<const Content*>(content_.get())->visit(check);
      if (!check.is_finite) {
        throw std::invalid_argument(std::string("its message of the kind '") + kind_.name +
                                    "' has a number that is not finite");
      }
    }
  }

  /// The same for content whose struct is made at run time, out of numbers. The name of the kind
  /// lives as long as the content.
  AnyMessage(const ReadingKind& kind, std::shared_ptr<const void> content,
             std::function<void(const void*, const FieldVisit&)> visit)
      : kind_(kind), content_(std::move(content)), visit_(std::move(visit)) {}

  const ReadingKind& kind() const { return kind_; }
  const void* content() const { return content_.get(); }
  /// Its size on the air: that of the struct.
  std::size_t bytes() const { return kind_.size; }
  void visit_fields(const FieldVisit& visit) const { visit_(content_.get(), visit); }

 private:
  ReadingKind kind_;
  std::shared_ptr<const void> content_;
  std::function<void(const void*, const FieldVisit&)> visit_;
};

/// The command of actuators that send messages.
struct SayCommand {
  static constexpr const char* kind = "say";
  std::shared_ptr<const AnyMessage> message{};  // null: silence
  std::string to{};                             // the id of a robot; empty: whoever hears it

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    const double bytes = message ? static_cast<double>(message->bytes()) : 0.0;
    visitor("bytes", bytes);
  }
};

/// How many messages a robot has sent and heard. One that several robots hear is sent once.
struct Talk {
  int sent = 0;
  int heard = 0;
};

/// A message that a robot hears in this control period, without the type of its content.
struct HeardMessage {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  std::shared_ptr<const AnyMessage> message{};
  std::string_view device{};  // the id of the actuator that hears it
  std::string_view from{};    // the id of the robot that said it; empty: the device does not tell
  double age_s = 0.0;         // since it was said
  // Of the sender, from the device that hears it, as range_and_bearing tells; else kUnknown.
  double distance_m = kUnknown;
  double bearing_rad = kUnknown;    // from the device's forward axis, positive to the left
  double elevation_rad = kUnknown;  // positive upwards
  Vector3 sender_at{};              // in the world, when it is heard: for viewers
};

/// One of them, whose type is known: `heard->x`, `heard.from()`.
template <class Content>
class Heard {
 public:
  explicit Heard(const HeardMessage& heard) : heard_(&heard) {}
  const Content& operator*() const {
    return *static_cast<const Content*>(heard_->message->content());
  }
  const Content* operator->() const { return &**this; }
  std::string_view device() const { return heard_->device; }
  std::string_view from() const { return heard_->from; }
  double age_s() const { return heard_->age_s; }
  double distance_m() const { return heard_->distance_m; }
  double bearing_rad() const { return heard_->bearing_rad; }
  double elevation_rad() const { return heard_->elevation_rad; }

 private:
  const HeardMessage* heard_;
};

/// The messages of one type among those that were heard, to loop over: ordered by the ids of the
/// senders.
template <class Content>
class HeardMessages {
 public:
  class Iterator {
   public:
    using value_type = Heard<Content>;
    using difference_type = std::ptrdiff_t;
    Iterator() = default;
    Iterator(const HeardMessage* at, const HeardMessage* end) : at_(at), end_(end) { seek(); }
    Heard<Content> operator*() const { return Heard<Content>(*at_); }
    Iterator& operator++() {
      ++at_;
      seek();
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_ == b.at_; }

   private:
    void seek() {
      while (at_ != end_ && !(at_->message->kind() == ReadingKind::of<Content>())) ++at_;
    }

    const HeardMessage* at_ = nullptr;
    const HeardMessage* end_ = nullptr;
  };

  explicit HeardMessages(std::span<const HeardMessage> all) : all_(all) {}
  Iterator begin() const { return {all_.data(), all_.data() + all_.size()}; }
  Iterator end() const { return {all_.data() + all_.size(), all_.data() + all_.size()}; }
  bool empty() const { return begin() == end(); }

 private:
  std::span<const HeardMessage> all_;
};

}  // namespace elsie
