#include "app/work/animation_dialog.h"

#include "widgets/animation/film.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace halfspace {
namespace {

/// Nobody reads smaller pictures, and no slide shows larger ones.
constexpr int shortestSide = 64;
constexpr int longestSide = 4096;
/// Videos have even sides.
constexpr int sideStep = 2;

/// GIF can tell them exactly, and so can all others.
constexpr int rates[] = {10, 20, 25, 50};

QSpinBox *sideBox(const QString &name, int side) {
  auto *box = new QSpinBox;
  box->setRange(shortestSide, longestSide);
  box->setSingleStep(sideStep);
  box->setValue(side);
  box->setAccessibleName(name);
  return box;
}

} // namespace

AnimationDialog::AnimationDialog(QWidget *parent)
    : QDialog(parent), m_motion(new QComboBox), m_format(new QComboBox),
      m_width(sideBox(tr("Width in pixels"), AnimationChoices().size.width)),
      m_height(sideBox(tr("Height in pixels"), AnimationChoices().size.height)),
      m_seconds(new QDoubleSpinBox), m_framesPerSecond(new QComboBox),
      m_transparent(new QCheckBox(tr("&No background"))) {
  setObjectName("animation");
  setWindowTitle(tr("Save animation"));
  m_motion->setObjectName("motion");
  m_format->setObjectName("format");
  m_seconds->setObjectName("seconds");
  m_seconds->setRange(shortestFilm, longestFilm);
  m_seconds->setDecimals(2);
  m_seconds->setSuffix(tr(" s", "seconds"));
  for (const AnimationFormat &format : animationFormats())
    m_format->addItem(QString::fromStdString(format.name));
  for (const int rate : rates) {
    m_framesPerSecond->addItem(tr("%1 a second").arg(rate), rate);
    if (rate == AnimationChoices().framesPerSecond)
      m_framesPerSecond->setCurrentIndex(m_framesPerSecond->count() - 1);
  }
  auto *sides = new QHBoxLayout;
  sides->addWidget(m_width);
  sides->addWidget(new QLabel(QString(QChar(0x00D7)))); // ×
  sides->addWidget(m_height);
  auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  buttons->addButton(tr("&Save…"), QDialogButtonBox::AcceptRole);
  auto *form = new QFormLayout(this);
  form->addRow(tr("&What moves:"), m_motion);
  form->addRow(tr("&Format:"), m_format);
  auto *size = new QLabel(tr("Si&ze in pixels:"));
  size->setBuddy(m_width);
  form->addRow(size, sides);
  form->addRow(tr("&Length:"), m_seconds);
  form->addRow(tr("&Pictures:"), m_framesPerSecond);
  form->addRow(QString(), m_transparent);
  form->addRow(buttons);
  connect(m_motion, qOverload<int>(&QComboBox::currentIndexChanged), this, &AnimationDialog::takeMotion);
  connect(m_format, qOverload<int>(&QComboBox::currentIndexChanged), this, &AnimationDialog::takeFormat);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  takeFormat();
}

void AnimationDialog::setScene(const AnimatedScene &scene) {
  const QString chosen = m_motion->currentText();
  const QSignalBlocker untold(m_motion); // what is chosen there may stay so, with its time
  m_offers.clear();
  m_motion->clear();
  for (const MotionKind &kind : motionKinds())
    if (const auto motion = kind.make(scene, {})) {
      m_offers.push_back({&kind, (*motion)->seconds()});
      m_motion->addItem(QString::fromStdString(kind.title));
    }
  const int row = m_motion->findText(chosen);
  m_motion->setCurrentIndex(std::max(0, row));
  if (row < 0)
    takeMotion();
}

AnimationChoices AnimationDialog::choices() const {
  AnimationChoices choices;
  choices.motion = m_offers.at(static_cast<std::size_t>(m_motion->currentIndex())).motion;
  choices.format = &format();
  choices.size = {m_width->value(), m_height->value()};
  choices.seconds = m_seconds->value();
  choices.framesPerSecond = m_framesPerSecond->currentData().toInt();
  choices.isTransparent = m_transparent->isEnabled() && m_transparent->isChecked();
  return choices;
}

/// Each takes its own time until another is wanted.
void AnimationDialog::takeMotion() {
  if (const int row = m_motion->currentIndex(); row >= 0)
    m_seconds->setValue(m_offers.at(static_cast<std::size_t>(row)).seconds);
}

void AnimationDialog::takeFormat() { m_transparent->setEnabled(format().mayBeTransparent); }

const AnimationFormat &AnimationDialog::format() const {
  return animationFormats().at(static_cast<std::size_t>(std::max(0, m_format->currentIndex())));
}

} // namespace halfspace
