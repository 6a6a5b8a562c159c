#include "widgets/working/blank_field.h"

#include "lessons/language.h"
#include "widgets/repolish.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QToolButton>

#include <algorithm>

namespace halfspace {
namespace {

/// In pixels.
constexpr int gapBeforeShow = 6;
/// In less room the field keeps so many letters, and the button all of its word.
constexpr int leastLetters = 7;

/// Ctrl+Right and its like, and the key for a picture, which Qt takes for the end of the line.
bool isOfWindow(const QKeyEvent &key) {
  return key.matches(QKeySequence::MoveToNextWord) || key.matches(QKeySequence::MoveToPreviousWord) ||
         (key.key() == Qt::Key_E && key.modifiers() == Qt::ControlModifier);
}

} // namespace

BlankField::BlankField(int letters, QWidget *parent)
    : QWidget(parent), m_letters(letters), m_edit(new QLineEdit), m_show(new QToolButton) {
  auto *layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(gapBeforeShow);
  layout->addWidget(m_edit);
  m_edit->setPlaceholderText(QStringLiteral("?"));
  m_edit->setToolTip(tr("A number, as 10, −10/3, %1 or 2√43/3 (also written 2*sqrt(43)/3); coordinates as "
                        "(1%2 2%2 3); an equation as x + 2y = 3. Enter checks it.")
                         .arg(QString::fromStdString(withDecimalMark("3.33")), QChar(listSeparator())));
  connect(m_edit, &QLineEdit::returnPressed, this, &BlankField::answer);
  connect(m_edit, &QLineEdit::textEdited, this, [this] { mark(false); });
  m_show->setText(tr("Show"));
  m_show->setObjectName("showLine"); // framed: else the word would be read as a part of the formula
  m_show->setFocusPolicy(Qt::StrongFocus);
  m_show->setCursor(Qt::ArrowCursor);
  connect(m_show, &QToolButton::clicked, this, &BlankField::showRequested);
  layout->addWidget(m_show);
  setFocusProxy(m_edit);
  m_edit->installEventFilter(this);
  setWidths();
}

void BlankField::setWidths() {
  const int letter = fontMetrics().averageCharWidth();
  m_edit->setMinimumWidth(std::min(m_letters, leastLetters) * letter);
  m_edit->setMaximumWidth(m_letters * letter);
}

QSize BlankField::sizeHint() const {
  return {m_edit->maximumWidth() + gapBeforeShow + m_show->sizeHint().width(), QWidget::sizeHint().height()};
}

void BlankField::changeEvent(QEvent *event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
    setWidths();
}

bool BlankField::eventFilter(QObject *watched, QEvent *event) {
  if (event->type() == QEvent::ShortcutOverride && isOfWindow(static_cast<const QKeyEvent &>(*event))) {
    event->ignore(); // a number is one word: the keys are the window's shortcuts
    return true;
  }
  if (event->type() == QEvent::KeyPress && static_cast<const QKeyEvent &>(*event).key() == Qt::Key_Escape) {
    leave();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void BlankField::leave() {
  if (parentWidget())
    parentWidget()->setFocus();
  else
    m_edit->clearFocus();
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
