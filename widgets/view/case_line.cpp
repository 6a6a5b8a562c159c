#include "widgets/view/case_line.h"

#include "widgets/repolish.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVariant>

namespace halfspace {
namespace {

/// Cases have up to about so many letters: the line has room for them from the start.
constexpr int usualLetters = 92;

QLabel *wrappedLabel(const char *name) {
  auto *label = new QLabel;
  label->setObjectName(name);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  return label;
}

} // namespace

CaseLine::CaseLine(std::chrono::milliseconds readingTime, QWidget *parent)
    : QWidget(parent), m_usual(wrappedLabel("case")), m_case(wrappedLabel("case")),
      m_message(wrappedLabel("message")), m_complaint(wrappedLabel("complaint")) {
  auto *layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_case, 3);
  layout->addWidget(m_message, 3);
  layout->addWidget(m_complaint, 2);
  m_usual->setParent(this);
  m_usual->setText(QStringLiteral("letters ").repeated(usualLetters / 8));
  for (QWidget *hidden : {m_usual, m_message, m_complaint})
    hidden->hide();
  m_messageTimer.setSingleShot(true);
  m_messageTimer.setInterval(readingTime);
  connect(&m_messageTimer, &QTimer::timeout, this, &CaseLine::endMessage);
}

void CaseLine::setCase(const QString &words, bool degenerate) {
  m_case->setText(words);
  if (m_case->property("degenerate") == degenerate)
    return;
  m_case->setProperty("degenerate", degenerate);
  repolish(*m_case);
}

void CaseLine::setHeld(bool held) {
  if (held)
    endMessage();
  m_held = held;
  setMinimumHeight(held ? height() : 0);
}

void CaseLine::resizeEvent(QResizeEvent *event) {
  QWidget::resizeEvent(event);
  m_case->setMinimumHeight(m_usual->heightForWidth(width()));
  if (m_held)
    setMinimumHeight(height());
}

void CaseLine::say(const QString &sentence) {
  m_message->setText(sentence);
  m_case->hide();
  m_message->show();
  m_messageTimer.start();
}

void CaseLine::endMessage() {
  m_messageTimer.stop();
  m_message->hide();
  m_case->show();
}

void CaseLine::complain(const QString &sentence, const QString &details) {
  m_complaint->setText(sentence);
  m_complaint->setToolTip(details.toHtmlEscaped());
  m_complaint->setVisible(!sentence.isEmpty());
}

} // namespace halfspace
