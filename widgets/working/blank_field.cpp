#include "widgets/working/blank_field.h"

#include "widgets/repolish.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QToolButton>

namespace halfspace {
BlankField::BlankField(int letters, QWidget *parent)
    : QWidget(parent), m_letters(letters), m_edit(new QLineEdit), m_show(new QToolButton) {
  auto *layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_edit);
  m_edit->setPlaceholderText(QStringLiteral("?"));
  m_edit->setToolTip(tr("A number, as 10, −10/3, 3.33 or 2√43/3 (also written 2*sqrt(43)/3); coordinates as "
                        "(1, 2, 3); an equation as x + 2y = 3. Enter checks it."));
  connect(m_edit, &QLineEdit::returnPressed, this, &BlankField::answer);
  connect(m_edit, &QLineEdit::textEdited, this, [this] { mark(false); });
  m_show->setText(tr("Show"));
  m_show->setAutoRaise(true);
  m_show->setFocusPolicy(Qt::StrongFocus);
  m_show->setCursor(Qt::ArrowCursor);
  connect(m_show, &QToolButton::clicked, this, &BlankField::showRequested);
  // Inside the field: beside it the word would be read as a part of the formula.
  auto *inside = new QHBoxLayout(m_edit);
  inside->setContentsMargins(0, 0, 0, 0);
  inside->addStretch();
  inside->addWidget(m_show);
  setFocusProxy(m_edit);
  m_edit->installEventFilter(this);
  setWidth();
}

void BlankField::setWidth() {
  const int showWidth = m_show->sizeHint().width();
  m_edit->setTextMargins(0, 0, showWidth, 0);
  m_edit->setFixedWidth(m_letters * fontMetrics().averageCharWidth() + showWidth);
}

void BlankField::changeEvent(QEvent *event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
    setWidth();
}

/// While there is no text to move in, Ctrl+Right and its like are the window's shortcuts, as everywhere else.
bool BlankField::eventFilter(QObject *watched, QEvent *event) {
  if (event->type() != QEvent::ShortcutOverride || !m_edit->text().isEmpty())
    return QWidget::eventFilter(watched, event);
  const auto &key = static_cast<const QKeyEvent &>(*event);
  if (!key.matches(QKeySequence::MoveToNextWord) && !key.matches(QKeySequence::MoveToPreviousWord))
    return QWidget::eventFilter(watched, event);
  event->ignore();
  return true;
}

void BlankField::setQuestion(const QString &question) {
  m_edit->setAccessibleName(tr("Fill in: %1").arg(question));
  m_show->setAccessibleName(tr("Show: %1").arg(question));
}

void BlankField::setRemark(const QString &remark) {
  if (m_edit->accessibleDescription() == remark)
    return;
  m_edit->setAccessibleDescription(remark);
  mark(!remark.isEmpty());
}

void BlankField::answer() {
  if (m_edit->text().trimmed().isEmpty())
    return;
  m_edit->selectAll();
  emit answered(m_edit->text());
}

void BlankField::mark(bool wrong) {
  m_edit->setProperty("wrong", wrong);
  repolish(*m_edit);
}

} // namespace halfspace
