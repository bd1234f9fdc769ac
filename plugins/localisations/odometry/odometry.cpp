// Dead reckoning from the wheels: it drifts.
#include "dead_reckoning.h"

namespace {

class Odometry final : public elsie::Localisation, public OdometryErrors {
 public:
  elsie::Belief start(const elsie::Belief& truth, elsie::Random& random) override {
    reckoning_.start(*this, random);
    return truth;
  }
  elsie::Belief update(const elsie::Belief& before,
                       const elsie::LocalisationContext& now) override {
    return reckoning_.update(*this, before, now);
  }

 private:
  DeadReckoning reckoning_;
};

}  // namespace

ELSIE_LOCALISATION(Odometry, "odometry", "Adds up the turns of the wheels, with their errors",
                   ODOMETRY_ERROR_PARAMETERS(Odometry));
