#include "widgets/view/case_line.h"

#include "widgets/repolish.h"
#include "widgets/text/indices.h"
#include "widgets/view/fitted_label.h"
#include "widgets/view/letter_room.h"
#include "widgets/view/wrapped_label.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QStackedLayout>
#include <QVariant>

#include <algorithm>

namespace halfspace {
namespace {

/// Words that are never cut short, in all the width that there is.
WrappedLabel *wholeLabel(const char *name) {
  auto *label = new WrappedLabel(name);
  QSizePolicy policy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  label->setSizePolicy(policy);
  return label;
}

// Nearly all cases of all lessons, and what is said of what is near, have fewer; in a window of usual size
// each has a row, in a high one two.
constexpr int lettersOfCase = 112;
constexpr int lettersOfNearby = 88;
constexpr int rowsInHighWindow = 2;
/// From here on, a window is a high one, in pixels.
constexpr int highWindow = 900;
constexpr int usualWindow = 800;
/// The line takes at most one such part of the window's height.
constexpr int linesInWindow = 4;

} // namespace

CaseLine::CaseLine(std::chrono::milliseconds readingTime, QWidget *parent)
    : QWidget(parent), m_case(new FittedLabel("case")), m_message(wholeLabel("message")),
      m_nearby(new NearbyOffer), m_roomOfCase(new LetterRoom("usualCase", this)),
      m_roomOfNearby(new LetterRoom("usualNearby", this)), m_complaint(new WrappedLabel("complaint")) {
  m_case->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  m_column = createColumn();
  auto *layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_column, 3);
  layout->addWidget(m_complaint, 2);
  m_complaint->hide();
  setWindowHeight(usualWindow);
  connect(m_nearby, &NearbyOffer::chosen, this, &CaseLine::nearbyChosen);
  connect(m_nearby, &NearbyOffer::afreshChosen, this, &CaseLine::afreshChosen);
  connect(m_nearby, &NearbyOffer::changed, this, &CaseLine::share);
  m_messageTimer.setSingleShot(true);
  m_messageTimer.setInterval(readingTime);
  connect(&m_messageTimer, &QTimer::timeout, this, &CaseLine::endMessage);
}

QWidget *CaseLine::createColumn() {
  m_second = new QWidget;
  m_pages = new QStackedLayout;
  m_pages->addWidget(m_nearby);
  m_pages->addWidget(m_message);
  m_second->setLayout(m_pages);
  auto *column = new QWidget;
  auto *layout = new QVBoxLayout(column);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_case, 1);
  layout->addWidget(m_second);
  return column;
}

void CaseLine::setWindowHeight(int height) {
  const int rows = height >= highWindow ? rowsInHighWindow : 1;
  m_roomOfCase->setLetters(lettersOfCase, rows);
  m_roomOfNearby->setLetters(lettersOfNearby, rows);
  m_most = height / linesInWindow;
  share();
}

bool CaseLine::event(QEvent *event) {
  const bool done = QWidget::event(event);
  if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest)
    share();
  // Where a button has gone Qt leaves pieces of the words that it had cut.
  if (event->type() == QEvent::LayoutRequest)
    update();
  return done;
}

void CaseLine::share() {
  const int width = m_column->width();
  const int ofButtons = m_nearby->heightOfButtons();
  const int ofNearby = std::max(m_roomOfNearby->heightIn(width), ofButtons);
  const int whole = std::min(m_roomOfCase->heightIn(width) + ofNearby, m_most);
  const bool isTelling = m_pages->currentWidget() == m_message;
  const int ofSecond = isTelling ? std::max(m_message->heightForWidth(width), ofButtons) : ofButtons;
  const int ofCase = std::min(std::max(m_case->heightIn(width), m_case->fontMetrics().height()), whole);
  const bool hasRoomForBoth = ofCase + ofSecond <= whole;
  m_second->setVisible(hasRoomForBoth || isTelling || m_nearby->offersAfresh());
  m_second->setFixedHeight(hasRoomForBoth ? whole - ofCase : ofSecond);
  m_nearby->fitInto(width);
  m_column->setMinimumHeight(whole + std::max(ofSecond - ofNearby, 0)); // a long message makes it higher
  m_column->layout()->activate(); // words are cut to the room that they have now
}

void CaseLine::setCase(const QString &words, bool degenerate) {
  if (words != m_case->words()) {
    m_case->setWords(words);
    share();
  }
  if (m_case->property("degenerate") == degenerate)
    return;
  m_case->setProperty("degenerate", degenerate);
  repolish(*m_case);
}

void CaseLine::say(const QString &sentence) {
  showWords(*m_message, sentence);
  m_pages->setCurrentWidget(m_message);
  share();
  m_messageTimer.start();
}

void CaseLine::endMessage() {
  m_messageTimer.stop();
  m_pages->setCurrentIndex(0);
  share();
}

void CaseLine::complain(const QString &sentence, const QString &details) {
  m_complaint->setText(sentence);
  m_complaint->setToolTip(details.toHtmlEscaped());
  m_complaint->setVisible(!sentence.isEmpty());
  layout()->activate();
  share();
}

} // namespace halfspace
