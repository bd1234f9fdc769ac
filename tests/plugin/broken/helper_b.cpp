// One of two libraries with a helper class of the same name; each must run its own.
#include "elsie/api/behavior.h"

class Helper {
 public:
  virtual ~Helper() = default;
  virtual double answer() const;
  static double shared() { return count_ += 2.0; }

 private:
  inline static double count_ = 0.0;
};

double Helper::answer() const { return 2.0; }

class UsesHelper final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception&) override {
    return elsie::WheelPair().motion({Helper().answer(), Helper::shared()});
  }
};

ELSIE_BEHAVIOR(UsesHelper, "helper_b", "Answers with 2");
