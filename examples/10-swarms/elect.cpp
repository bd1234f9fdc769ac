// Leader election: each robot draws a number, and all tell their neighbours the largest that they
// know, until nobody hears of a larger one (flooding; Lynch 1996, chapter 4).
#include <elsie/api/behavior.h>
#include <elsie/commands/led.h>

struct Candidate {
  static constexpr const char* kind = "candidate";
  double number = 0.0;

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("number", number);
  }
};

class Elect final : public elsie::Behavior {
 public:
  double settled = 2.0;  // s

  void reset(elsie::Random& random) override {
    own_ = largest_ = random.uniform();
    news_s_ = 0.0;
    is_over_ = false;
  }

  elsie::Response respond(const elsie::Perception& now) override {
    for (const auto& heard : now.heard<Candidate>()) {
      if (heard->number <= largest_) continue;
      largest_ = heard->number;
      news_s_ = now.time_s();
    }
    elsie::Response response;
    response.say(Candidate{largest_});
    if (!is_over_ && now.time_s() - news_s_ >= settled) {
      is_over_ = true;
      const bool leads = largest_ == own_;
      response.events.push_back({leads ? "leads" : "follows"});
      response.act(
          elsie::LedCommand{leads ? elsie::Colour{230, 40, 40} : elsie::Colour{60, 120, 230}, 1.0});
    }
    return response;
  }

  double largest() const { return largest_; }

 private:
  double own_ = 0.0;
  double largest_ = 0.0;
  double news_s_ = 0.0;  // when it last heard of a larger one
  bool is_over_ = false;
};

ELSIE_BEHAVIOR(Elect, "elect", "Elects a leader with all robots that it can reach",
               elsie::only_acts(), elsie::commands<elsie::SayCommand>(),
               elsie::commands<elsie::LedCommand>(), elsie::hears<Candidate>(),
               elsie::raises("leads", "the election is over, and this robot is the leader"),
               elsie::raises("follows", "the election is over, and another robot is the leader"),
               elsie::parameter("settled", &Elect::settled,
                                {.unit = "s",
                                 .above = 0,
                                 .max = 1000,
                                 .meaning = "without news, after which the election is over"}),
               elsie::publishes("largest", &Elect::largest,
                                {.meaning = "the largest number that it knows"}));
