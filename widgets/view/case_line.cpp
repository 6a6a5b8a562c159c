#include "widgets/view/case_line.h"

#include "widgets/repolish.h"
#include "widgets/text/indices.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QResizeEvent>
#include <QStackedLayout>
#include <QVariant>

namespace halfspace {
namespace {

/// As long as cases usually are: the line has room for them from the start.
QString usualCase() { return QStringLiteral("letters ").repeated(11); }

QLabel *wrappedLabel(const char *name) {
  auto *label = new QLabel;
  label->setObjectName(name);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  return label;
}

/// Rich text takes time, which counts in a drag: it is for words with indices alone.
void setWords(QLabel &label, const QString &words) {
  const bool hasIndices = runsOf(words).size() > 1;
  label.setTextFormat(hasIndices ? Qt::RichText : Qt::PlainText);
  label.setText(hasIndices ? richTextOf(words) : words);
}

} // namespace

CaseLine::CaseLine(std::chrono::milliseconds readingTime, QWidget *parent)
    : QWidget(parent), m_case(wrappedLabel("case")), m_message(wrappedLabel("message")),
      m_usual(wrappedLabel("usualCase")), m_nearby(wrappedLabel("nearby")),
      m_there(new QPushButton(tr("Take me there"))), m_complaint(wrappedLabel("complaint")),
      m_words(new QStackedLayout) {
  m_usual->setText(usualCase());
  for (QLabel *page : {m_case, m_message, m_usual}) // it is as high as the highest
    m_words->addWidget(page);
  m_there->setObjectName("there");
  m_there->setFlat(true);
  m_there->setCursor(Qt::PointingHandCursor);
  m_there->setFocusPolicy(Qt::TabFocus);
  // Its row stays where there is nothing to say: else the picture would jump.
  QSizePolicy staying = m_there->sizePolicy();
  staying.setRetainSizeWhenHidden(true);
  m_there->setSizePolicy(staying);
  connect(m_there, &QPushButton::clicked, this, &CaseLine::nearbyChosen);
  setNearby({}, false);
  auto *special = new QHBoxLayout;
  special->setSpacing(0);
  special->addWidget(m_nearby, 1);
  special->addWidget(m_there, 0, Qt::AlignTop);
  auto *column = new QVBoxLayout;
  column->setSpacing(0);
  column->addLayout(m_words, 1);
  column->addLayout(special);
  auto *layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(column, 3);
  layout->addWidget(m_complaint, 2);
  m_complaint->hide();
  m_messageTimer.setSingleShot(true);
  m_messageTimer.setInterval(readingTime);
  connect(&m_messageTimer, &QTimer::timeout, this, &CaseLine::endMessage);
}

void CaseLine::setCase(const QString &words, bool degenerate) {
  setWords(*m_case, words);
  if (m_case->property("degenerate") == degenerate)
    return;
  m_case->setProperty("degenerate", degenerate);
  repolish(*m_case);
}

void CaseLine::setNearby(const QString &words, bool canBeReached) {
  setWords(*m_nearby, words);
  m_there->setVisible(canBeReached);
}

void CaseLine::resizeEvent(QResizeEvent *event) {
  QWidget::resizeEvent(event);
  setMinimumHeight(event->oldSize().width() == width() ? height() : 0);
}

void CaseLine::changeEvent(QEvent *event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
    setMinimumHeight(0);
}

void CaseLine::say(const QString &sentence) {
  m_message->setText(sentence);
  m_words->setCurrentWidget(m_message);
  m_messageTimer.start();
}

void CaseLine::endMessage() {
  m_messageTimer.stop();
  m_words->setCurrentWidget(m_case);
}

void CaseLine::complain(const QString &sentence, const QString &details) {
  m_complaint->setText(sentence);
  m_complaint->setToolTip(details.toHtmlEscaped());
  m_complaint->setVisible(!sentence.isEmpty());
}

} // namespace halfspace
