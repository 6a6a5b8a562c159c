#include "widgets/blank_field.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QLocale>
#include <QStyle>
#include <QToolButton>

namespace halfspace {
namespace {

/// The field's width, in letters: for one number, for several, and where nothing can be typed.
constexpr int numberLetters = 12;
constexpr int listLetters = 20;
constexpr int blankLetters = 5;

int lettersFor(std::size_t numbers) {
  return numbers == 0 ? blankLetters : numbers == 1 ? numberLetters : listLetters;
}

} // namespace

BlankField::BlankField(const QString &question, std::size_t numbers, QWidget *parent) : QWidget(parent) {
  auto *layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  auto *edit = new QLineEdit;
  edit->setPlaceholderText(QStringLiteral("?"));
  edit->setFixedWidth(lettersFor(numbers) * fontMetrics().averageCharWidth());
  edit->setEnabled(numbers > 0);
  layout->addWidget(edit);
  if (numbers > 0)
    ask(*edit, question);
  auto *show = new QToolButton;
  show->setText(tr("Show"));
  show->setAutoRaise(true);
  show->setFocusPolicy(Qt::StrongFocus);
  show->setAccessibleName(tr("Show: %1").arg(question));
  connect(show, &QToolButton::clicked, this, &BlankField::showRequested);
  layout->addWidget(show);
  setFocusProxy(m_edit ? static_cast<QWidget *>(m_edit) : show);
}

void BlankField::ask(QLineEdit &edit, const QString &question) {
  m_edit = &edit;
  edit.setAccessibleName(tr("Fill in: %1").arg(question));
  edit.setToolTip(
      tr("A number, as 10, −10/3, 3.33 or 2√43/3 (also written 2*sqrt(43)/3); coordinates as (1, 2, 3). "
         "Enter checks it."));
  connect(&edit, &QLineEdit::returnPressed, this, &BlankField::answer);
  connect(&edit, &QLineEdit::textEdited, this, [this] { mark(false); });
}

void BlankField::setRemark(const QString &remark) {
  if (!m_edit || m_edit->accessibleDescription() == remark)
    return;
  m_edit->setAccessibleDescription(remark);
  mark(!remark.isEmpty());
}

void BlankField::answer() {
  if (m_edit->text().trimmed().isEmpty())
    return;
  QString text = m_edit->text();
  if (locale().decimalPoint() == ',')
    text.replace(',', '.');
  m_edit->selectAll();
  emit answered(text);
}

void BlankField::mark(bool wrong) {
  m_edit->setProperty("wrong", wrong);
  m_edit->style()->unpolish(m_edit);
  m_edit->style()->polish(m_edit);
}

} // namespace halfspace
