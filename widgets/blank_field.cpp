#include "widgets/blank_field.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QLocale>
#include <QStyle>
#include <QToolButton>

namespace halfspace {
namespace {

/// The field's width, in letters.
constexpr int fieldLetters = 12;

} // namespace

BlankField::BlankField(const QString &question, bool asksForNumber, QWidget *parent) : QWidget(parent) {
  auto *layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  if (asksForNumber) {
    m_edit = new QLineEdit;
    m_edit->setPlaceholderText(QStringLiteral("?"));
    m_edit->setFixedWidth(fieldLetters * fontMetrics().averageCharWidth());
    m_edit->setAccessibleName(tr("Fill in: %1").arg(question));
    m_edit->setToolTip(
        tr("A number, as 10, −10/3, 3.33 or 2√43/3 (also written 2*sqrt(43)/3). Enter checks it."));
    connect(m_edit, &QLineEdit::returnPressed, this, &BlankField::answer);
    connect(m_edit, &QLineEdit::textEdited, this, [this] { mark(false); });
    layout->addWidget(m_edit);
    setFocusProxy(m_edit);
  }
  auto *show = new QToolButton;
  show->setText(tr("Show"));
  show->setAutoRaise(true);
  show->setFocusPolicy(Qt::StrongFocus);
  show->setAccessibleName(tr("Show: %1").arg(question));
  connect(show, &QToolButton::clicked, this, &BlankField::showRequested);
  layout->addWidget(show);
  if (!m_edit)
    setFocusProxy(show);
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
