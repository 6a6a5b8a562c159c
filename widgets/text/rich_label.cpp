#include "widgets/text/rich_label.h"

#include <QAbstractTextDocumentLayout>
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace halfspace {

namespace {

/// The width that a text gets where nothing tells, in letters.
constexpr int usualLetters = 46;
constexpr int fewestLetters = 16;

} // namespace

RichLabel::RichLabel(const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_typesetter(typesetter), m_ink(palette().color(QPalette::WindowText)),
      m_text({}, typesetter, {font(), m_ink}) {
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

RichLabel::~RichLabel() = default;

void RichLabel::setMarkdown(const QString &markdown) {
  if (markdown == m_markdown)
    return;
  const int before = heightForWidth(width());
  m_markdown = markdown;
  m_text.setMarkdown(markdown);
  setAccessibleName(m_text.plain());
  if (heightForWidth(width()) != before)
    updateGeometry();
  update();
}

void RichLabel::setInk(const QColor &ink, const QColor &warning) {
  if (ink == m_ink && warning == m_warning)
    return;
  m_ink = ink;
  m_warning = warning;
  build();
}

void RichLabel::build() {
  m_text = RichText(m_markdown, m_typesetter, {font(), m_ink, m_warning});
  updateGeometry();
  update();
}

QTextDocument &RichLabel::layOut(double width) const {
  QTextDocument &document = m_text.document();
  if (document.textWidth() != width) // else everything would be laid out again
    document.setTextWidth(width);
  return document;
}

int RichLabel::heightForWidth(int width) const {
  const double belowLastLine = (richLineSpacing - 1) * fontMetrics().height();
  return static_cast<int>(std::ceil(std::max(0.0, layOut(width).size().height() - belowLastLine)));
}

QSize RichLabel::sizeHint() const {
  const int usual = fontMetrics().averageCharWidth() * usualLetters;
  const int width = std::min(usual, static_cast<int>(std::ceil(layOut(-1).idealWidth())) + 1);
  return {width, heightForWidth(width)};
}

QSize RichLabel::minimumSizeHint() const {
  return {std::min(sizeHint().width(), fontMetrics().averageCharWidth() * fewestLetters), 0};
}

QString RichLabel::problemAt(QPoint place) const {
  (void)layOut(width());
  return m_text.problemAt(place);
}

bool RichLabel::event(QEvent *event) {
  if (event->type() != QEvent::ToolTip)
    return QWidget::event(event);
  const auto *help = static_cast<QHelpEvent *>(event);
  const QString problem = problemAt(help->pos());
  if (problem.isEmpty())
    QToolTip::hideText();
  else
    QToolTip::showText(help->globalPos(), Qt::convertFromPlainText(problem, Qt::WhiteSpaceNormal), this);
  return true;
}

void RichLabel::paintEvent(QPaintEvent *) {
  QPainter painter(this);
  layOut(width()).drawContents(&painter);
}

void RichLabel::changeEvent(QEvent *event) {
  if (event->type() == QEvent::FontChange)
    build();
  QWidget::changeEvent(event);
}

} // namespace halfspace
