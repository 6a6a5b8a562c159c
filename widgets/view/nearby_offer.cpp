#include "widgets/view/nearby_offer.h"

#include "widgets/text/indices.h"
#include "widgets/view/fitted_label.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>

#include <algorithm>

namespace halfspace {
namespace {

/// Beside the ways there, words of fewer letters in a row are no help.
constexpr int leastLetters = 24;

QPushButton *flatButton(const char *name, const QString &words) {
  auto *button = new QPushButton(words);
  button->setObjectName(name);
  button->setFlat(true);
  button->setCursor(Qt::PointingHandCursor);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

} // namespace

NearbyOffer::NearbyOffer(QWidget *parent)
    : QWidget(parent), m_words(new FittedLabel("nearby")), m_there(flatButton("there", tr("Take me there"))),
      m_others(flatButton("others", tr("More") + QStringLiteral(" ▾"))), m_all(new QMenu(m_others)),
      m_afresh(flatButton("afresh", tr("Start this step afresh"))) {
  // The button has no menu of its own: the style would draw a mark for it beside the words.
  connect(m_others, &QPushButton::clicked, this, [this] {
    fillMenu();
    m_all->popup(m_others->mapToGlobal(m_others->rect().bottomLeft()));
  });
  m_others->setAccessibleName(tr("More"));
  m_others->setAccessibleDescription(tr("All special cases near this one"));
  m_words->setAlignment(Qt::AlignLeft | Qt::AlignBottom);
  m_afresh->setToolTip(tr("Back to the numbers that the lesson begins with; its question is asked again. "
                          "Undo brings the numbers back."));
  connect(m_there, &QPushButton::clicked, this, [this] { emit chosen(0); });
  connect(m_afresh, &QPushButton::clicked, this, &NearbyOffer::afreshChosen);
  auto *layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_words, 1);
  layout->addStretch();
  for (QPushButton *button : {m_there, m_others, m_afresh}) {
    layout->addWidget(button, 0, Qt::AlignBottom); // however many rows the words have
    button->hide();
  }
}

void NearbyOffer::setCases(const QString &words, const std::vector<NearbyCase> &cases) {
  if (words != m_words->words()) {
    m_words->setWords(words);
    m_there->setToolTip(richTextOf(words));
  }
  if (cases == m_cases)
    return;
  m_cases = cases;
  offer();
}

void NearbyOffer::offer() {
  const bool isNearestOffered = !m_cases.empty() && m_cases.front().canBeReached;
  const auto reached =
      std::count_if(m_cases.begin(), m_cases.end(), [](const NearbyCase &each) { return each.canBeReached; });
  const bool areOthersOffered = reached > (isNearestOffered ? 1 : 0);
  if (m_all->isVisible())
    fillMenu();
  if (m_there->isHidden() != isNearestOffered && m_others->isHidden() != areOthersOffered)
    return;
  m_there->setVisible(isNearestOffered);
  m_others->setVisible(areOthersOffered);
  emit changed();
}

void NearbyOffer::fillMenu() {
  m_all->clear();
  for (std::size_t i = 0; i < m_cases.size(); ++i)
    if (m_cases[i].canBeReached)
      connect(m_all->addAction(m_cases[i].words), &QAction::triggered, this,
              [this, which = static_cast<int>(i)] { emit chosen(which); });
}

void NearbyOffer::offerAfresh(bool offered) {
  if (offersAfresh() == offered)
    return;
  m_afresh->setVisible(offered);
  emit changed();
}

bool NearbyOffer::offersAfresh() const { return !m_afresh->isHidden(); }

int NearbyOffer::heightOfButtons() const { return m_there->sizeHint().height(); }

void NearbyOffer::fitInto(int width) {
  int room = width;
  for (const QPushButton *button : {m_there, m_others, m_afresh})
    room -= button->isHidden() ? 0 : button->sizeHint().width();
  m_words->setVisible(room >= leastLetters * m_words->fontMetrics().averageCharWidth());
}

} // namespace halfspace
