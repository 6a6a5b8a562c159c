#include "widgets/lesson/page_head.h"

#include "widgets/colors.h"
#include "widgets/flow_layout.h"

#include <QLabel>

namespace halfspace {
namespace {

// In pixels, at the usual size of text.
constexpr int gap = 4;
constexpr int toolGap = 6;
/// The title's size, in sizes of the words.
constexpr double titleSize = 1.4;

void setInk(QWidget &widget, Color color) {
  QPalette palette = widget.palette();
  palette.setColor(QPalette::WindowText, toQColor(color));
  widget.setPalette(palette);
}

QLabel *plainLabel() {
  auto *label = new QLabel;
  label->setTextFormat(Qt::PlainText); // lesson files come from strangers
  return label;
}

} // namespace

PageHead::PageHead(QWidget &tools) : m_above(new FlowLayout), m_number(plainLabel()), m_title(plainLabel()) {
  m_title->setWordWrap(true);
  m_above->addWidget(m_number);
  m_above->addWidget(&tools);
  addLayout(m_above);
  addWidget(m_title);
}

void PageHead::setStep(int step, int stepCount, const QString &title) {
  m_number->setText(stepCount > 1 ? tr("Step %1/%2").arg(step + 1).arg(stepCount) : QString());
  m_title->setText(title);
  m_title->setVisible(!title.isEmpty());
}

void PageHead::setLook(const Theme &theme, const QFont &words) {
  m_above->setSpacing(qRound(toolGap * theme.textScale));
  setSpacing(qRound(gap * theme.textScale));
  setInk(*m_number, theme.mutedInk);
  setInk(*m_title, theme.ink);
  QFont titleFont = words;
  titleFont.setPointSizeF(titleFont.pointSizeF() * titleSize);
  titleFont.setBold(true);
  m_title->setFont(titleFont);
}

} // namespace halfspace
