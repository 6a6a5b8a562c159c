#include "widgets/rich_label.h"

#include <QAbstractTextDocumentLayout>
#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace halfspace {

namespace {

/// The width that a text gets where nothing tells, in letters.
constexpr int usualLetters = 46;
constexpr int fewestLetters = 16;

} // namespace

RichLabel::RichLabel(const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_typesetter(typesetter), m_ink(palette().color(QPalette::WindowText)) {
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  build();
}

RichLabel::~RichLabel() = default;

void RichLabel::setMarkdown(const QString &markdown) {
  if (markdown == m_markdown)
    return;
  m_markdown = markdown;
  build();
}

void RichLabel::setInk(const QColor &ink) {
  if (ink == m_ink)
    return;
  m_ink = ink;
  build();
}

void RichLabel::build() {
  const int before = heightForWidth(width());
  RichText text = makeRichText(m_markdown, m_typesetter, {font(), m_ink});
  m_document = std::move(text.document);
  setAccessibleName(text.plain);
  if (heightForWidth(width()) != before)
    updateGeometry();
  update();
}

int RichLabel::heightForWidth(int width) const {
  if (!m_document)
    return 0;
  m_document->setTextWidth(width);
  const double belowLastLine = (richLineSpacing - 1) * fontMetrics().height();
  return static_cast<int>(std::ceil(std::max(0.0, m_document->size().height() - belowLastLine)));
}

QSize RichLabel::sizeHint() const {
  m_document->setTextWidth(-1);
  const int usual = fontMetrics().averageCharWidth() * usualLetters;
  const int width = std::min(usual, static_cast<int>(std::ceil(m_document->idealWidth())) + 1);
  return {width, heightForWidth(width)};
}

QSize RichLabel::minimumSizeHint() const {
  return {std::min(sizeHint().width(), fontMetrics().averageCharWidth() * fewestLetters), 0};
}

void RichLabel::paintEvent(QPaintEvent *) {
  QPainter painter(this);
  m_document->setTextWidth(width());
  m_document->drawContents(&painter);
}

void RichLabel::changeEvent(QEvent *event) {
  if (event->type() == QEvent::FontChange)
    build();
  QWidget::changeEvent(event);
}

} // namespace halfspace
