#include "engine/workbench.h"

// The run.

namespace elsie::desktop {
namespace {

constexpr double kHair_s = 1e-6;  // rounding errors in sums of steps

}  // namespace

void Workbench::set_run(Run run) {
  if (run_ != run) {
    run_ = run;
    if (run == Run::none || run == Run::ready) {
      latest_s_ = 0.0;
    }
    engine_.set_live(run == Run::running);
    if (run != Run::running) {
      pace_ = 0.0;
    }
    Q_EMIT run_changed();
  }
}

/// Sends an order that continues the run. If it is refused, the run stays as it is.
void Workbench::go(Json order) {
  Q_EMIT about_to_change();
  deaths_ = 0;
  in_turn([this, order = std::move(order)] {
    const bool may_go_on = run_ == Run::ready || run_ == Run::paused;
    if (may_go_on || (run_ == Run::running && order.contains("until_s"))) {
      const bool is_step = order.value("do", std::string()) == "step";
      is_stepping_ = is_stepping_ || is_step;
      engine_.ask(order, [this, is_step, before = run_](const Json& answer) {
        if (is_step) is_stepping_ = false;
        if (answer.contains("refused")) {
          if (run_ == Run::running) set_run(before);
          Q_EMIT refused(problems_of(answer));
        } else if (is_step && run_ == Run::ready) {
          set_run(Run::paused);
        }
      });
      Q_EMIT went_on();
      if (!is_step) set_run(Run::running);
    }
    end_change();
  });
}

bool Workbench::is_at_halt() const { return halt_s_ && latest_s_ >= *halt_s_ - kHair_s; }

void Workbench::run() {
  Json order{{"do", "run"}};
  if (halt_s_ && !is_at_halt()) {
    order.update({{"until_s", *halt_s_}, {"paced", true}});
  }
  go(std::move(order));
}

void Workbench::run_until(double time_s) { go({{"do", "run"}, {"until_s", time_s}}); }

void Workbench::step() { go({{"do", "step"}}); }

void Workbench::pause() {
  if (run_ == Run::running) {
    engine_.ask({{"do", "pause"}}, [this](const Json&) {
      if (run_ == Run::running) {
        set_run(Run::paused);
      }
    });
  }
}

void Workbench::reset(std::uint64_t seed) {
  Q_EMIT about_to_change();
  deaths_ = 0;
  in_turn([this, seed] {
    if (!is_right()) {  // the text is opened with this seed once it is valid
      seed_ = seed;
      Q_EMIT run_changed();
      end_change();
      return;
    }
    order({{"do", "reset"}, {"seed", seed}}, [this, seed](const Json& answer) {
      if (answer.contains("refused")) {
        Q_EMIT settings_changed();  // views show the previous seed again
        end_change(problems_of(answer));
        return;
      }
      seed_ = seed;
      scene_ = answer.value("scene", Json());
      epoch_ = answer.value("epoch", std::uint64_t{0});
      time_s_ = latest_s_ = 0.0;
      set_run(Run::ready);
      Q_EMIT described();
      Q_EMIT run_changed();
      end_change();
    });
  });
}

void Workbench::set_speed(double factor) {
  speed_ = factor;
  engine_.ask({{"do", "speed"}, {"factor", factor}});
  Q_EMIT settings_changed();
}

}  // namespace elsie::desktop
