#include "control_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QSet>
#include <QSlider>
#include <QStyleOptionSlider>
#include <QToolButton>
#include <QToolTip>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/workbench.h"
#include "look/icons.h"
#include "paint/boxes.h"

namespace elsie::desktop {
namespace {

constexpr std::array kSpeeds{0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 0.0};  // 0: as fast as possible
constexpr int kTicks = 10'000;                                          // of the time line
constexpr double kHandle_px = 6.0;  // from the slider's end to the outermost place of its handle
const QSet<int> kTimeKeys{Qt::Key_Left,   Qt::Key_Right, Qt::Key_Comma,
                          Qt::Key_Period, Qt::Key_Home,  Qt::Key_End};
constexpr int kBetweenPictures_ms = 40;  // while the past is played
constexpr double kAtOnce_s = 0.05;       // events nearer to the shown time than this are at it

}  // namespace

ControlBar::ControlBar(Workbench& workbench, QWidget* parent)
    : QWidget(parent), workbench_(workbench) {
  setObjectName("control_bar");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(4, 0, 4, 0);
  row->setSpacing(2);
  const auto button = [&](const char* name, const QString& text, const QString& tip) {
    auto* made = new QToolButton;
    made->setObjectName(name);
    made->setText(text);
    made->setIcon(icon(name));
    made->setIconSize({style()->pixelMetric(QStyle::PM_ToolBarIconSize),
                       style()->pixelMetric(QStyle::PM_ToolBarIconSize)});
    made->setAutoRaise(true);
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    row->addWidget(made);
    return made;
  };
  run_ = button("run", tr("Start"),
                tr("Start or continue the run; after its end, start it again (F5)"));
  run_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  const QString wider = tr("Pause");  // so that the buttons next to it do not move
  const QString start = run_->text();
  run_->setText(wider);
  const int width = run_->sizeHint().width();
  run_->setText(start);
  run_->setMinimumWidth(std::max(width, run_->sizeHint().width()));
  step_ = button("step", tr("Step"), tr("Run one control period (F10)"));
  reset_ =
      button("reset", tr("Reset"), tr("Back to the start, with the world as it is now (Ctrl+R)"));
  row->addSpacing(fontMetrics().averageCharWidth());
  connect(run_, &QToolButton::clicked, this, &ControlBar::run_wished);
  connect(step_, &QToolButton::clicked, &workbench_, &Workbench::step);
  connect(reset_, &QToolButton::clicked, this, [this] { workbench_.reset(workbench_.seed()); });

  auto* speed_label = new QLabel(tr("S&peed"));
  speed_label->setContentsMargins(0, 0, fontMetrics().averageCharWidth() / 2, 0);
  row->addWidget(speed_label);
  speed_ = new QComboBox;
  speed_->setObjectName("speed");
  speed_->setAccessibleName(tr("Speed"));
  quiet_wheel(speed_);
  speed_label->setBuddy(speed_);
  speed_->setToolTip(tr("Simulated seconds for each second on the clock"));
  for (const double speed : kSpeeds) {
    speed_->addItem(speed > 0.0 ? QString::number(speed) + "x" : tr("maximum"), speed);
  }
  speed_->setCurrentIndex(speed_->findData(1.0));
  connect(speed_, &QComboBox::activated, this,
          [this](int index) { workbench_.set_speed(speed_->itemData(index).toDouble()); });
  row->addWidget(speed_);

  row->addSpacing(fontMetrics().averageCharWidth());
  auto* seed_label = new QLabel(tr("See&d"));
  seed_label->setContentsMargins(0, 0, fontMetrics().averageCharWidth() / 2, 0);
  row->addWidget(seed_label);
  seed_ = new QLineEdit("1");
  seed_label->setBuddy(seed_);
  seed_->setObjectName("seed");
  seed_->setAccessibleName(tr("Seed"));
  seed_->setToolTip(tr("Seed of all random numbers; a new one starts the run again"));
  seed_->setMaximumWidth(10 * fontMetrics().averageCharWidth() + 20);
  connect(seed_, &QLineEdit::editingFinished, this, [this] {
    bool is_right = false;
    const std::uint64_t seed = seed_->text().toULongLong(&is_right);
    if (!is_right) {
      Q_EMIT workbench_.noted(
          tr("'%1' is not a seed; expected a whole number of at most 19 digits.")
              .arg(seed_->text()));
      show_seed();
    } else if (seed != workbench_.seed()) {
      Q_EMIT seed_wished(seed);
    }
  });
  // A seed that the engine refuses is replaced by the present one.
  connect(&workbench_, &Workbench::refused, this, &ControlBar::show_seed);
  row->addWidget(seed_);
  row->addStretch(1);
  connect(&workbench_, &Workbench::run_changed, this, &ControlBar::show_state);
  connect(&workbench_, &Workbench::settings_changed, this, &ControlBar::show_state);
  show_state();
}

void ControlBar::show_state() {
  const Workbench::Run run = workbench_.run_state();
  const bool is_running = run == Workbench::Run::running || past_ == Past::plays;
  run_->setText(is_running ? tr("Pause") : tr("Start"));
  run_->setIcon(icon(is_running ? "pause" : "run"));
  run_->setEnabled(is_running || past_ != Past::none || run != Workbench::Run::none);
  step_->setEnabled(run == Workbench::Run::ready || run == Workbench::Run::paused);
  reset_->setEnabled(run != Workbench::Run::none);
  if (speed_->findData(workbench_.speed()) < 0) {
    speed_->addItem(QString::number(workbench_.speed()) + "x", workbench_.speed());
  }
  speed_->setCurrentIndex(speed_->findData(workbench_.speed()));
  if (!seed_->hasFocus()) {
    seed_->setText(QString::number(workbench_.seed()));
  }
}

void ControlBar::show_seed() { seed_->setText(QString::number(workbench_.seed())); }

void ControlBar::show_past(Past past) {
  past_ = past;
  show_state();
}

TimeLine::TimeLine(Workbench& workbench, QWidget* parent) : QWidget(parent), workbench_(workbench) {
  setObjectName("time_line");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(4, 0, 4, 6);
  slider_ = new QSlider(Qt::Horizontal);
  slider_->setObjectName("time");
  slider_->setAccessibleName(tr("Time of the run"));
  slider_->setRange(0, kTicks);
  slider_->installEventFilter(this);
  setFocusProxy(slider_);
  row->addWidget(slider_, 1);
  label_ = new QLabel("0.00 s");
  label_->setObjectName("shown_time");
  label_->setMinimumWidth(14 * fontMetrics().averageCharWidth());
  row->addWidget(label_);
  now_ = new QToolButton;
  now_->setObjectName("now");
  now_->setText(tr("Now"));
  now_->setToolTip(tr("Back to the present (End)"));
  row->addWidget(now_);
  connect(slider_, &QSlider::valueChanged, this,
          [this](int value) { go_to(span_s() * value / kTicks); });
  connect(now_, &QToolButton::clicked, this, &TimeLine::go_to_now);
  connect(&workbench_, &Workbench::snapshot, this, [this](const snapshots::Snapshot& snapshot) {
    shown_s_ = snapshot.facts.time_s;
    if (!is_in_the_past_) {
      until_s_ = shown_s_;
    }
    show_now();
  });
  connect(&workbench_, &Workbench::run_changed, this, [this] {
    slider_->setEnabled(workbench_.run_state() != Workbench::Run::none);
    if (workbench_.run_state() == Workbench::Run::ready) {
      is_in_the_past_ = false;
    }
    show_now();
  });
  connect(&workbench_, &Workbench::went_on, this, [this] {
    stop_playing();
    is_in_the_past_ = false;
    show_now();
  });
  // An edit changes the present, which the engine then shows.
  connect(&workbench_, &Workbench::described, this, [this] {
    if (is_in_the_past_) go_to_now();
  });
  play_timer_.setInterval(kBetweenPictures_ms);
  connect(&play_timer_, &QTimer::timeout, this, &TimeLine::play_on);
}

void TimeLine::show_now() {
  const double part = span_s() > 0.0 ? shown_s_ / span_s() : 1.0;
  if (!slider_->isSliderDown() && !is_pressed_) {  // not against the hand of the user
    const QSignalBlocker blocker(slider_);
    slider_->setValue(static_cast<int>(std::lround(kTicks * std::min(1.0, part))));
  }
  label_->setText(is_in_the_past_ || ahead_until_s_ > 0.0
                      ? tr("%1 of %2 s").arg(shown_s_, 0, 'f', 2).arg(span_s(), 0, 'f', 2)
                      : tr("%1 s").arg(shown_s_, 0, 'f', 2));
  now_->setEnabled(is_in_the_past_);
  update();
  if (!is_in_the_past_ && instant_) {
    instant_.reset();
    Q_EMIT instant_changed();
  }
  if (std::exchange(was_in_the_past_, is_in_the_past_) != is_in_the_past_) {
    Q_EMIT past_changed();
  }
}

void TimeLine::play() {
  if (is_in_the_past_ && !is_playing()) {
    since_played_.start();
    play_timer_.start();
    Q_EMIT past_changed();
  }
}

void TimeLine::stop_playing() {
  if (is_playing()) {
    play_timer_.stop();
    Q_EMIT past_changed();
  }
}

void TimeLine::play_on() {
  constexpr double kMs = 1e-3;  // s
  const double speed = workbench_.speed();
  const double next_s = asked_s_ + speed * kMs * static_cast<double>(since_played_.restart());
  if (speed > 0.0 && next_s < until_s_) {
    show_past(next_s);
  } else {
    go_to_now();
    Q_EMIT has_caught_up();
  }
}

void TimeLine::go_to(double time_s) {
  stop_playing();
  show_past(time_s);
}

void TimeLine::show_past(double time_s) {
  const double wanted = std::clamp(time_s, 0.0, span_s());
  asked_s_ = wanted;
  if (wanted > until_s_ + kAtOnce_s) {
    workbench_.run_until(wanted);
    return;
  }
  if (workbench_.run_state() == Workbench::Run::running) {
    workbench_.pause();
  }
  is_in_the_past_ = true;
  ask_for(wanted);
}

void TimeLine::ask_for(double time_s) {
  workbench_.ask({{"do", "at"}, {"time_s", time_s}, {"robots", list_of(robots_)}},
                 [this](const Json& answer) { take(answer); });
}

void TimeLine::take(const Json& answer) {
  if (answer.contains("refused")) {
    stop_playing();  // there is no past to play
    is_in_the_past_ = false;
  } else if (is_in_the_past_) {
    until_s_ = answer.value("to_s", until_s_);  // the run continued until it received the pause
    const double time_s = answer.value("time_s", until_s_);
    if (time_s >= until_s_ && !is_playing()) {
      go_to_now();
      return;
    }
    instant_ = {time_s, member(answer, "numbers"), member(answer, "look")};
    Q_EMIT instant_changed();
  }
  show_now();
}

void TimeLine::set_robots(const QStringList& robots) {
  if (robots != std::exchange(robots_, robots) && is_in_the_past_) {
    ask_for(asked_s_);
  }
}

void TimeLine::go_to_now() {
  stop_playing();
  is_in_the_past_ = false;
  workbench_.ask({{"do", "at"}}, {});
  show_now();
}

// From where the user is going, because keys come faster than pictures of the past.
void TimeLine::move_by(double by_s) { go_to((is_in_the_past_ ? asked_s_ : until_s_) + by_s); }

void TimeLine::go_to_event(bool next) {
  const double from_s = is_in_the_past_ ? asked_s_ : until_s_;
  double found = next ? span_s() : 0.0;
  for (const auto& [time, what] : events()) {
    if (next ? time > from_s + kAtOnce_s && time < found
             : time < from_s - kAtOnce_s && time > found) {
      found = time;
    }
  }
  go_to(found);
}

QString TimeLine::tip_at(double time_s) const {
  const double near_s = std::max(kAtOnce_s, 4.0 * span_s() / std::max(1, slider_->width()));
  QStringList lines;
  for (const auto& [time, what] : events()) {
    if (std::abs(time - time_s) <= near_s) {
      lines << tr("%1 s: %2").arg(time, 0, 'f', 2).arg(what);
    }
  }
  return lines.join('\n');
}

double TimeLine::time_at(double x) const {
  const QRect groove = slider_->geometry();
  return span_s() * (x - groove.left() - kHandle_px) / (groove.width() - 2.0 * kHandle_px);
}

bool TimeLine::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride &&
      kTimeKeys.contains(static_cast<QKeyEvent*>(event)->key())) {
    event->accept();  // the window uses some of these keys otherwise
    return true;
  }
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), tip_at(time_at(help->pos().x())), this);
    return true;
  }
  return QWidget::event(event);
}

// The slider's keys and tool tips are those of the time line.
bool TimeLine::eventFilter(QObject* watched, QEvent* event) {
  if (watched == slider_ && event->type() == QEvent::MouseButtonRelease) {
    is_pressed_ = false;
  }
  if (watched == slider_ && event->type() == QEvent::MouseButtonPress) {
    is_pressed_ = true;
    const auto* press = static_cast<QMouseEvent*>(event);
    const double part =
        (press->position().x() - kHandle_px) / std::max(1.0, slider_->width() - 2.0 * kHandle_px);
    const int ticks = static_cast<int>(std::lround(kTicks * std::clamp(part, 0.0, 1.0)));
    const double away_px = std::abs(ticks - slider_->value()) * slider_->width() / double(kTicks);
    if (press->button() == Qt::LeftButton && away_px > 2.0 * kHandle_px) {
      slider_->setValue(ticks);  // puts the handle under the pointer, and the slider takes it
    }
  }
  const bool is_ours = event->type() == QEvent::KeyPress || event->type() == QEvent::ToolTip ||
                       event->type() == QEvent::ShortcutOverride;
  return watched == slider_ && is_ours ? this->event(event) : QWidget::eventFilter(watched, event);
}

void TimeLine::keyPressEvent(QKeyEvent* event) {
  const double step_s = event->modifiers() & Qt::ShiftModifier ? 1.0 : 0.1;
  switch (event->key()) {
    case Qt::Key_Left:
      move_by(-step_s);
      break;
    case Qt::Key_Right:
      move_by(step_s);
      break;
    case Qt::Key_Comma:
      go_to_event(false);
      break;
    case Qt::Key_Period:
      go_to_event(true);
      break;
    case Qt::Key_Home:
      go_to(0.0);
      break;
    case Qt::Key_End:
      go_to_now();
      break;
    default:
      QWidget::keyPressEvent(event);
  }
}

void TimeLine::mark(double time_s, const QString& what) {
  constexpr std::size_t kMost = 2000;
  if (marks_.size() < kMost) {
    marks_.emplace_back(time_s, what);
    update();
  }
}

void TimeLine::expect(Marks events, double until_s) {
  ahead_ = std::move(events);
  ahead_until_s_ = until_s;
  show_now();
}

TimeLine::Marks TimeLine::events() const {
  Marks all = marks_;
  for (const auto& [time, what] : ahead_) {
    if (time > until_s_) {
      all.emplace_back(time, tr("%1, in the recording").arg(what));
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  return all;
}

void TimeLine::clear() {
  stop_playing();
  marks_.clear();
  until_s_ = shown_s_ = 0.0;
  is_in_the_past_ = false;
  show_now();
}

void TimeLine::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
  if (span_s() <= 0.0) {
    return;
  }
  const QRect groove = slider_->geometry();
  for (const auto& [time, what] : events()) {
    const double x =
        groove.left() + kHandle_px + (groove.width() - 2.0 * kHandle_px) * time / span_s();
    painter.drawLine(QPointF(x, groove.bottom() - 2.0), QPointF(x, height() - 1.0));
  }
}

}  // namespace elsie::desktop
