#include "widgets/view/case_line.h"

#include "widgets/repolish.h"
#include "widgets/text/indices.h"
#include "widgets/view/fitted_label.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>
#include <QStackedLayout>
#include <QVariant>

#include <algorithm>

namespace halfspace {
namespace {

QLabel *wrappedLabel(const char *name) {
  auto *label = new QLabel;
  label->setObjectName(name);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setIndent(0); // it begins where the others do
  return label;
}

/// So many rows of letters, with indices, which make them higher.
QString lettersFor(int rows, int letters) {
  const QString word = QStringLiteral("letter_s ");
  const QString row = richTextOf(word.repeated(letters / rows / static_cast<int>(word.size())).trimmed());
  return row + (QStringLiteral("<br>") + row).repeated(rows - 1);
}

/// A label with words that there is to be room for; it is never shown.
QLabel *roomFor(const char *name) {
  QLabel *label = wrappedLabel(name);
  label->setTextFormat(Qt::RichText);
  return label;
}

/// Words that are never cut short, in all the width that there is.
QLabel *wholeLabel(const char *name) {
  QLabel *label = wrappedLabel(name);
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
/// Beside the ways there, words of fewer letters in a row are no help.
constexpr int leastLettersOfNearby = 24;

QPushButton *flatButton(const char *name, const QString &words) {
  auto *button = new QPushButton(words);
  button->setObjectName(name);
  button->setFlat(true);
  button->setCursor(Qt::PointingHandCursor);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

} // namespace

CaseLine::CaseLine(std::chrono::milliseconds readingTime, QWidget *parent)
    : QWidget(parent), m_case(new FittedLabel("case")), m_message(wholeLabel("message")),
      m_nearby(new FittedLabel("nearby")), m_roomOfCase(roomFor("usualCase")),
      m_roomOfNearby(roomFor("usualNearby")), m_there(flatButton("there", tr("Take me there"))),
      m_others(flatButton("others", tr("More") + QStringLiteral(" ▾"))), m_all(new QMenu(m_others)),
      m_afresh(flatButton("afresh", tr("Start this step afresh"))), m_complaint(wrappedLabel("complaint")) {
  // The button has no menu of its own: the style would draw a mark for it beside the words.
  connect(m_others, &QPushButton::clicked, this,
          [this] { m_all->popup(m_others->mapToGlobal(m_others->rect().bottomLeft())); });
  m_others->setAccessibleName(tr("More"));
  m_others->setAccessibleDescription(tr("All special cases near this one"));
  m_case->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  m_nearby->setAlignment(Qt::AlignLeft | Qt::AlignBottom);
  m_column = createColumn();
  m_afresh->setToolTip(tr("Back to the numbers that the lesson begins with; its question is asked again. "
                          "Undo brings the numbers back."));
  connect(m_there, &QPushButton::clicked, this, [this] { emit nearbyChosen(0); });
  connect(m_afresh, &QPushButton::clicked, this, &CaseLine::afreshChosen);
  offer({});
  auto *layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_column, 3);
  layout->addWidget(m_complaint, 2);
  m_complaint->hide();
  for (QLabel *room : {m_roomOfCase, m_roomOfNearby}) {
    room->setParent(this);
    room->hide();
    room->ensurePolished(); // what is never shown has no style else
  }
  setWindowHeight(usualWindow);
  offerAfresh(false);
  m_messageTimer.setSingleShot(true);
  m_messageTimer.setInterval(readingTime);
  connect(&m_messageTimer, &QTimer::timeout, this, &CaseLine::endMessage);
}

QWidget *CaseLine::createNearbyRow() {
  auto *row = new QWidget;
  auto *layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_nearby, 1);
  layout->addStretch();
  for (QPushButton *button : {m_there, m_others, m_afresh})
    layout->addWidget(button, 0, Qt::AlignBottom); // however many rows the words have
  return row;
}

QWidget *CaseLine::createColumn() {
  m_second = new QWidget;
  m_pages = new QStackedLayout;
  m_pages->addWidget(createNearbyRow());
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
  m_roomOfCase->setText(lettersFor(rows, lettersOfCase));
  m_roomOfNearby->setText(lettersFor(rows, lettersOfNearby));
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

bool CaseLine::hasRoomForNearbyWords() const {
  int room = m_column->width();
  for (const QPushButton *button : {m_there, m_others, m_afresh})
    room -= button->isHidden() ? 0 : button->sizeHint().width();
  return room >= leastLettersOfNearby * m_nearby->fontMetrics().averageCharWidth();
}

void CaseLine::share() {
  const int width = m_column->width();
  const int ofButtons = m_there->sizeHint().height();
  const int ofNearby = std::max(m_roomOfNearby->heightForWidth(width), ofButtons);
  const int whole = std::min(m_roomOfCase->heightForWidth(width) + ofNearby, m_most);
  const bool isTelling = m_pages->currentWidget() == m_message;
  const int ofSecond = isTelling ? std::max(m_message->heightForWidth(width), ofButtons) : ofButtons;
  const int ofCase = std::min(std::max(m_case->heightOfAll(width), m_case->fontMetrics().height()), whole);
  const bool hasRoomForBoth = ofCase + ofSecond <= whole;
  m_second->setVisible(hasRoomForBoth || isTelling || !m_afresh->isHidden());
  m_second->setFixedHeight(hasRoomForBoth ? whole - ofCase : ofSecond);
  m_nearby->setVisible(hasRoomForNearbyWords());
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

void CaseLine::setNearby(const QString &words, const std::vector<NearbyCase> &cases) {
  if (words != m_nearby->words()) {
    m_nearby->setWords(words);
    m_there->setToolTip(richTextOf(words));
  }
  if (cases != m_cases)
    offer(cases);
}

void CaseLine::offer(const std::vector<NearbyCase> &cases) {
  m_cases = cases;
  m_there->setVisible(!cases.empty() && cases.front().canBeReached);
  m_all->clear();
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (cases[i].canBeReached)
      connect(m_all->addAction(cases[i].words), &QAction::triggered, this,
              [this, which = static_cast<int>(i)] { emit nearbyChosen(which); });
  m_others->setVisible(m_all->actions().size() > (m_there->isHidden() ? 0 : 1));
  share();
}

void CaseLine::offerAfresh(bool offered) {
  const bool isOther = offered == m_afresh->isHidden();
  m_afresh->setVisible(offered);
  if (isOther)
    share();
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
