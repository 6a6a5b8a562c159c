#include "widgets/cost_plot/cost_plot.h"

#include "widgets/colors.h"
#include "widgets/flow_layout.h"
#include "widgets/text/figures.h"

#include <QButtonGroup>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <new>
#include <utility>

namespace halfspace {
namespace {

constexpr int usualGap = 6;
constexpr int significantDigits = 2;

QString milliseconds(double microseconds) { return roundedText(microseconds / 1000, significantDigits); }

QString boxes(std::size_t count) {
  return count == 1 ? CostPlot::tr("1 box") : CostPlot::tr("%1 boxes").arg(counted(count));
}

/// 25 triangles: what both did to find the hit.
QString costWords(const CostPoint &point) {
  return CostPlot::tr("%1: the loop asked all %2 in %3 ms; the tree looked at %4 and %5 in %6 ms.")
      .arg(trianglesInWords(point.triangles), counted(point.plain.triangles),
           milliseconds(point.plainMicroseconds), boxes(point.tree.boxes),
           trianglesInWords(point.tree.triangles), milliseconds(point.treeMicroseconds));
}

/// Whether there was memory for it.
bool measureAll(const CostPlot::Measure &measure, const Aim &aim, const std::atomic<bool> &cancelled,
                const TellCost &tell, std::size_t most) {
  try {
    measure(aim, cancelled, tell, most);
    return true;
  } catch (const std::bad_alloc &) {
    return false;
  }
}

} // namespace

CostPlot::CostPlot(LatestJob &job, Measure measure, QWidget *parent)
    : QWidget(parent), m_job(job), m_measuring(std::move(measure)), m_measure(new QPushButton),
      m_curves(new CostCurves), m_sentence(new QLabel) {
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(usualGap);
  auto *controls = new FlowLayout;
  layout->addLayout(controls);
  m_measure->setObjectName("measure");
  controls->addWidget(m_measure);
  auto *quantities = new QButtonGroup(this);
  for (QToolButton *button :
       {quantityButton(CostQuantity::LookedAt, tr("Looked at"),
                       tr("How many boxes and triangles were looked at")),
        quantityButton(CostQuantity::Time, tr("Time"), tr("How long one search took"))}) {
    controls->addWidget(button);
    quantities->addButton(button);
  }
  quantities->buttons().front()->setChecked(true);
  quantities->buttons().back()->setObjectName("time");
  layout->addWidget(m_curves);
  m_sentence->setTextFormat(Qt::PlainText);
  m_sentence->setWordWrap(true);
  layout->addWidget(m_sentence);
  m_curves->setAccessibleName(tr("Cost of a search"));
  connect(m_measure, &QPushButton::clicked, this, [this] { isMeasuring() ? stop() : start(); });
  setTheme(themes().front());
  showState();
}

CostPlot::~CostPlot() {
  if (m_isMeasuring)
    m_job.cancel();
}

QToolButton *CostPlot::quantityButton(CostQuantity quantity, const QString &words,
                                      const QString &explanation) {
  auto *button = new QToolButton;
  button->setText(words);
  button->setToolTip(explanation);
  button->setCheckable(true);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::StrongFocus);
  connect(button, &QToolButton::toggled, this, [this, quantity](bool on) {
    if (on)
      m_curves->setQuantity(quantity);
  });
  return button;
}

void CostPlot::setAim(std::optional<Aim> aim) {
  if (std::exchange(m_aim, std::move(aim)) != m_aim)
    showState();
}

void CostPlot::setMost(std::size_t triangles) {
  m_most = triangles;
  showState();
}

void CostPlot::setTheme(const Theme &theme) {
  m_curves->setTheme(theme);
  QPalette palette = m_sentence->palette();
  palette.setColor(QPalette::WindowText, toQColor(theme.ink));
  m_sentence->setPalette(palette);
}

void CostPlot::start() {
  if (!m_aim)
    return;
  emit started();
  m_isMeasuring = true;
  m_points.clear();
  m_inScene.reset();
  m_measuredAim = m_aim;
  m_lacksMemory = false;
  m_job.start([this, measure = m_measuring, aim = *m_aim, most = m_most](
                  const std::atomic<bool> &cancelled, const LatestJob::Post &post) -> LatestJob::Message {
    const auto tell = [&](const CostPoint &point) { post([this, point] { add(point); }); };
    const bool lacksMemory = !measureAll(measure, aim, cancelled, tell, most);
    return [this, lacksMemory] { end(lacksMemory); };
  });
  showPoints();
}

void CostPlot::stop() {
  if (!std::exchange(m_isMeasuring, false))
    return;
  m_job.cancel();
  showState();
  emit ended();
}

void CostPlot::add(const CostPoint &point) {
  if (point.inScene)
    m_inScene = point;
  else
    m_points.push_back(point);
  showPoints();
  emit measured();
}

void CostPlot::end(bool lacksMemory) {
  m_isMeasuring = false;
  m_lacksMemory = lacksMemory;
  showState();
  emit ended();
}

QString CostPlot::sentence() const {
  QStringList sentences;
  if (m_inScene)
    sentences << tr("The scene, %1").arg(costWords(*m_inScene));
  if (!m_points.empty())
    sentences << tr("A field, %1").arg(costWords(m_points.back()));
  if (m_lacksMemory)
    sentences << tr("There is not enough memory for more triangles.");
  if (!sentences.isEmpty() && m_aim != m_measuredAim)
    sentences << tr("Something has moved since this was measured.");
  if (!sentences.isEmpty())
    return sentences.join("\n");
  return isMeasuring()
             ? tr("Measuring …")
             : tr("Press Measure: the shot is fired at the scene, and at bumpy fields of %1 to %2 triangles.")
                   .arg(counted(fewestMeasured), counted(m_most));
}

void CostPlot::showPoints() {
  m_curves->setPoints(m_points, m_inScene);
  showState();
}

/// In each frame of a drag: what has not changed is left alone.
void CostPlot::showState() {
  m_measure->setText(isMeasuring() ? tr("Stop") : tr("Measure"));
  m_measure->setEnabled(isMeasuring() || m_aim);
  const QString told = sentence();
  if (told == m_sentence->text())
    return;
  m_sentence->setText(told);
  m_curves->setAccessibleDescription(told);
}

} // namespace halfspace
