#include "training/training_page.h"

#include <QCheckBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <algorithm>
#include <cmath>

#include "engine/workbench.h"
#include "paint/axes.h"
#include "paint/boxes.h"
#include "training/learning_curve.h"

namespace elsie::desktop {
namespace {

constexpr int kMostLayers = 9;
constexpr int kMostNeurons = 999;
const QStringList kOwnLayers{"2", "2"};  // of a network without chosen layers

}  // namespace

bool TrainingPage::learns(const Kind& kind) {
  const QStringList common{"hidden", "training", "weights", "presentations"};
  return std::count_if(kind.fields.begin(), kind.fields.end(), [&](const Field& field) {
           return common.contains(field.name);
         }) == common.size();
}

TrainingPage::TrainingPage(Workbench& workbench, const Kind& kind, QString coordinator,
                           QWidget* parent)
    : QWidget(parent),
      workbench_(workbench),
      coordinator_(std::move(coordinator)),
      trainer_(workbench.engine().program(), workbench.engine().options()) {
  auto* column = new QFormLayout(this);
  sizes_ = new QLabel;
  sizes_->setObjectName("network_sizes");
  sizes_->setWordWrap(true);
  column->addRow(sizes_);
  count_ = new CountBox;
  count_->setObjectName("hidden_count");
  count_->setRange(0, kMostLayers);
  count_->setKeyboardTracking(false);
  column->addRow(tr("Hidden &layers"), count_);
  layers_ = new QHBoxLayout;
  column->addRow(tr("Their sizes"), layers_);
  wished_ = new QCheckBox(tr("&Train with OK, and use the weights"));
  wished_->setObjectName("train");
  column->addRow(wished_);
  where_ = new QLabel(
      tr("The weights are written next to the world, which has no file of its own yet: save it "
         "first."));
  where_->setObjectName("where_weights_go");
  where_->setWordWrap(true);
  column->addRow(where_);
  progress_ = new QLabel;
  progress_->setObjectName("training_progress");
  progress_->setWordWrap(true);
  column->addRow(progress_);
  curve_ = new LearningCurve;
  curve_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  column->addRow(curve_);

  show_sizes(kind);
  show_place(has_place());
  connect(&workbench_, &Workbench::history_changed, this, [this] {
    if (where_->isHidden() != has_place()) show_place(has_place());
  });
  connect(count_, &QSpinBox::valueChanged, this, [this](int count) {
    QStringList sizes = layers();
    while (sizes.size() < count) {
      sizes << (sizes.isEmpty() ? kOwnLayers.front() : sizes.back());
    }
    show_layers(sizes.first(count));
    Q_EMIT hidden_wished(count == 0 ? QString("0") : layers().join(' '));
  });
  connect(&trainer_, &Trainer::progressed, this, [this](double at, double most, double error) {
    curve_->add(at, most, error);
    progress_->setText(tr("%1 of %2 samples, mean error %3")
                           .arg(number_text(at), number_text(most), number_text(error)));
  });
  connect(&trainer_, &Trainer::failed, this, [this](const QString& sentence) {
    trained_.reset();
    set_busy(false);
    progress_->clear();
    Q_EMIT failed(sentence);
  });
  connect(&trainer_, &Trainer::trained, this, [this](const Json& report) {
    show_report(report);
    set_busy(false);
    Q_EMIT trained(text_of(report, "warning"), member(report, "below_threshold") == true);
  });
}

TrainingPage::~TrainingPage() {
  trainer_.cancel();
  remove_weights();
}

void TrainingPage::show_report(const Json& report) {
  QPolygonF points;
  for (const Json& point : member(report, "curve")) {
    if (point.is_array() && point.size() == 2 && point[0].is_number() && point[1].is_number()) {
      points << QPointF(point[0].get<double>(), point[1].get<double>());
    }
  }
  const double presentations = number_of(report, "presentations");
  curve_->show_all(points, presentations > 1.0 ? presentations : 1.0);
  progress_->setText(tr("Mean error %1 after %2 samples.")
                         .arg(number_text(number_of(report, "error")),
                              std::isfinite(presentations)
                                  ? QLocale::c().toString(presentations, 'f', 0)
                                  : number_text(presentations)));
}

void TrainingPage::say_more(const QString& sentence) {
  progress_->setText(progress_->text() + ' ' + sentence);
}

void TrainingPage::keep_weights() {
  weights_file_.clear();
  set_busy(true);  // there is nothing left to choose
  progress_->setText(tr("The network is loaded. %1").arg(progress_->text()));
}

void TrainingPage::remove_weights() {
  if (!weights_file_.isEmpty()) {
    QFile::remove(weights_file_);
    weights_file_.clear();
  }
}

// They follow from the robot; nobody enters them.
void TrainingPage::show_sizes(const Kind& kind) {
  QStringList inputs, outputs;
  const Json& world = workbench_.tree();
  for (const ElementPlace& each : members_of(world, holder_of(coordinator_), "behaviors")) {
    outputs << title_of(*each.element);
  }
  for (const ElementPlace& each : members_of(world, robot_path(coordinator_), "sensors")) {
    const auto sensor = workbench_.catalog().kind_of(each);
    if (sensor && std::any_of(kind.needs.begin(), kind.needs.end(), [&](const QString& need) {
          return sensor->produces.contains(need);
        })) {
      inputs << title_of(*each.element);
    }
  }
  const auto listed = [](const QStringList& names) {
    return names.isEmpty() ? tr("none") : names.join(", ");
  };
  sizes_->setText(tr("Inputs: %1 (%2)\nOutputs: %3 (%4)")
                      .arg(inputs.size())
                      .arg(listed(inputs))
                      .arg(outputs.size())
                      .arg(listed(outputs)));
}

void TrainingPage::show_hidden(const QString& hidden) {
  QStringList sizes = hidden.split(' ', Qt::SkipEmptyParts);
  if (hidden == "0") {
    sizes.clear();
  } else if (sizes.isEmpty() || sizes.front() == "auto") {
    sizes = kOwnLayers;
  }
  if (sizes != layers()) {
    show_layers(sizes.first(std::min<qsizetype>(sizes.size(), kMostLayers)));
  }
}

QStringList TrainingPage::layers() const {
  QStringList sizes;
  for (int i = 0; i < layers_->count(); ++i) {
    sizes << qobject_cast<QSpinBox*>(layers_->itemAt(i)->widget())->cleanText();
  }
  return sizes;
}

void TrainingPage::show_layers(const QStringList& sizes) {
  while (layers_->count() > static_cast<int>(sizes.size())) {
    QLayoutItem* item = layers_->takeAt(layers_->count() - 1);
    item->widget()->deleteLater();
    delete item;
  }
  for (int i = 0; i < sizes.size(); ++i) {
    if (i == layers_->count()) {
      auto* box = new CountBox;
      box->setObjectName("hidden_size_" + QString::number(i + 1));
      box->setAccessibleName(tr("Neurons in hidden layer %1").arg(i + 1));
      box->setRange(1, kMostNeurons);
      box->setKeyboardTracking(false);
      box->setValue(sizes[i].toInt());
      connect(box, &QSpinBox::valueChanged, this,
              [this] { Q_EMIT hidden_wished(layers().join(' ')); });
      layers_->addWidget(box);
    } else {
      auto* box = qobject_cast<QSpinBox*>(layers_->itemAt(i)->widget());
      const QSignalBlocker blocker(box);
      box->setValue(sizes[i].toInt());
    }
  }
  const QSignalBlocker blocker(count_);
  count_->setValue(static_cast<int>(sizes.size()));
}

bool TrainingPage::is_wished() const { return wished_->isChecked(); }

void TrainingPage::wish(bool training) {
  wish_ = training;
  wished_->setChecked(training && has_place());
}

bool TrainingPage::has_place() const {
  return !workbench_.file().isEmpty() && !workbench_.is_borrowed();
}

void TrainingPage::show_place(bool has_place) {
  where_->setHidden(has_place);
  wished_->setEnabled(has_place);
  wished_->setChecked(has_place && wish_);
  wished_->setToolTip(
      has_place
          ? tr("Trains the network that a run with this seed would train, and writes its weights "
               "to a file next to the world. Otherwise each run trains its own network.")
          : where_->text());
}

Lesson TrainingPage::lesson(const QStringList& edits, bool has_seed) const {
  const QString file = workbench_.file().isEmpty() ? QString("world.xml") : workbench_.file();
  return {workbench_.text(), file, edits, coordinator_,
          has_seed ? std::nullopt : std::optional(workbench_.seed())};
}

bool TrainingPage::has_trained(const QStringList& edits, bool has_seed) const {
  return !trainer_.is_busy() && trained_ == lesson(edits, has_seed);
}

void TrainingPage::train(const QStringList& edits, bool has_seed) {
  remove_weights();  // of a training whose result was not used
  // No existing file is changed, because undo may lead back to it.
  const QDir folder = QFileInfo(workbench_.file()).absoluteDir();
  const QString robot = robot_id(coordinator_);
  weights_ = robot + ".weights";
  for (int i = 2; folder.exists(weights_); ++i) {
    weights_ = QString("%1-%2.weights").arg(robot).arg(i);
  }
  weights_file_ = folder.filePath(weights_);
  curve_->clear();
  progress_->setText(tr("Training..."));
  set_busy(true);
  trained_ = lesson(edits, has_seed);
  trainer_.train(*trained_, weights_file_);
}

void TrainingPage::set_busy(bool is_busy) {
  wished_->setEnabled(!is_busy && has_place());
  for (QSpinBox* box : findChildren<QSpinBox*>()) {
    box->setEnabled(!is_busy);
  }
}

bool TrainingPage::cancel() {
  const bool was_busy = trainer_.is_busy();
  trainer_.cancel();
  if (was_busy) {
    trained_.reset();
    set_busy(false);
    progress_->setText(tr("Stopped: nothing was written."));
  }
  return was_busy;
}

}  // namespace elsie::desktop
