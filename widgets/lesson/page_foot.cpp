#include "widgets/lesson/page_foot.h"

#include "widgets/lesson/step_dots.h"

#include <QPushButton>
#include <QSpacerItem>

#include <algorithm>

namespace halfspace {
namespace {

// In pixels, at the usual size of text.
constexpr QSize smallestButton(64, 24);
constexpr int sideMargin = 20;
constexpr int margins = 10;

} // namespace

PageFoot::PageFoot()
    : m_back(new QPushButton(tr("Back"))), m_dots(new StepDots), m_next(new QPushButton(tr("Next"))) {
  m_next->setObjectName("next");
  // No margins: in a page that becomes narrower these may, too.
  for (QSpacerItem *&side : m_sides)
    side = new QSpacerItem(0, 0, QSizePolicy::Preferred);
  addItem(m_sides.front());
  addWidget(m_back);
  addStretch(1);
  addWidget(m_dots);
  addStretch(1);
  addWidget(m_next);
  addItem(m_sides.back());
  connect(m_back, &QPushButton::clicked, this, [this] { emit stepRequested(m_step - 1); });
  connect(m_next, &QPushButton::clicked, this, &PageFoot::goOn);
  connect(m_dots, &StepDots::clicked, this, &PageFoot::stepRequested);
}

void PageFoot::setSteps(const QStringList &titles) {
  m_stepCount = static_cast<int>(titles.size());
  m_dots->setSteps(titles);
}

void PageFoot::setStep(int step) {
  m_step = step;
  m_dots->setCurrent(step);
  m_back->setEnabled(step > 0);
  showNext();
}

void PageFoot::setNextLesson(const QString &title) {
  m_nextLesson = title;
  showNext();
}

void PageFoot::showNext() {
  const bool isLast = m_step + 1 >= m_stepCount;
  const bool endsLesson = isLast && !m_nextLesson.isEmpty();
  m_next->setText(endsLesson ? tr("Next lesson") : tr("Next"));
  m_next->setToolTip(endsLesson ? m_nextLesson : QString());
  m_next->setEnabled(!isLast || endsLesson);
  for (QWidget *part : std::array<QWidget *, 3>{m_back, m_dots, m_next})
    part->setVisible(m_stepCount > 1 || endsLesson); // else there is nowhere to go
  keepButtonsWhole();
}

void PageFoot::keepButtonsWhole() {
  for (QPushButton *button : {m_back, m_next})
    button->setMinimumSize((smallestButton * m_scale).expandedTo({button->sizeHint().width(), 0}));
}

void PageFoot::goOn() {
  if (m_step + 1 < m_stepCount)
    emit stepRequested(m_step + 1);
  else
    emit nextLessonRequested();
}

bool PageFoot::focusNext() {
  if (!m_next->isEnabled())
    return false;
  m_next->setFocus();
  return true;
}

void PageFoot::setTheme(const Theme &theme) {
  m_scale = theme.textScale;
  m_dots->setTheme(theme);
  keepButtonsWhole();
}

void PageFoot::setRoomBeside(int besideLines) {
  const int side = qRound(sideMargin * m_scale);
  const int around = qRound(margins * m_scale);
  setContentsMargins(side, around, side, around);
  for (QSpacerItem *room : m_sides)
    room->changeSize(std::max(besideLines - side, 0), 0, QSizePolicy::Preferred);
  invalidate();
}

} // namespace halfspace
