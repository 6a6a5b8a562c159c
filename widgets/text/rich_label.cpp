#include "widgets/text/rich_label.h"

#include "lessons/lesson/term_links.h"
#include "widgets/colors.h"
#include "widgets/speak_by.h"

#include <QAbstractTextDocumentLayout>
#include <QAccessibleWidget>
#include <QDesktopServices>
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <QUrl>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halfspace {

namespace {

/// The width that a text gets where nothing tells, in letters.
constexpr int usualLetters = 46;
constexpr int fewestLetters = 16;

/// What is told of a link before it is clicked: where it leads to.
QString tipOf(const QString &address) {
  const std::string text = address.toStdString();
  const auto term = QString::fromStdString(std::string(termAt(text)));
  return term.isEmpty() ? address : RichLabel::tr("Look up “%1” in the glossary.").arg(term);
}

/// Tells a screen reader of the words.
class SpokenLabel : public QAccessibleWidget {
public:
  explicit SpokenLabel(RichLabel &label)
      : QAccessibleWidget(&label, QAccessible::StaticText), m_label(label) {}

  [[nodiscard]] QString text(QAccessible::Text text) const override {
    return text == QAccessible::Name ? m_label.plain() : QAccessibleWidget::text(text);
  }

private:
  const RichLabel &m_label;
};

} // namespace

RichLabel::RichLabel(const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_typesetter(typesetter), m_style{font(), palette().color(QPalette::WindowText)},
      m_text(FilledMarkdown(), typesetter, m_style) {
  speakBy<RichLabel, SpokenLabel>();
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

RichLabel::~RichLabel() = default;

bool RichLabel::setWords(FilledMarkdown words) {
  if (words == m_text.words())
    return false;
  const int before = heightForWidth(width());
  m_text.setWords(std::move(words));
  lookForLinks();
  tellSpoken(*this, QAccessible::NameChanged);
  if (heightForWidth(width()) != before)
    updateGeometry();
  if (m_held)
    setMinimumHeight(std::max(minimumHeight(), heightForWidth(width())));
  update();
  return true;
}

void RichLabel::setHeld(bool held) {
  m_held = held;
  setMinimumHeight(held ? height() : 0);
}

void RichLabel::setInk(Color ink, const Theme &theme) {
  RichTextStyle style = m_style;
  style.ink = toQColor(ink);
  style.warning = toQColor(theme.warning);
  style.link = toQColor(theme.accent);
  if (style.ink == m_style.ink && style.warning == m_style.warning && style.link == m_style.link)
    return;
  m_style = std::move(style);
  build();
}

void RichLabel::setPictures(LessonPictures pictures) {
  if (pictures == m_style.pictures)
    return;
  m_style.pictures = std::move(pictures);
  build();
}

void RichLabel::build() {
  m_style.font = font();
  m_text.setStyle(m_style);
  lookForLinks();
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
  // Whole pixels of it: where lines have parts of pixels the last one may reach into the rest.
  const double belowLastLine = std::floor((richLineSpacing - 1) * fontMetrics().height());
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

QString RichLabel::linkAt(QPoint place) const {
  (void)layOut(width());
  return m_text.linkAt(place);
}

void RichLabel::lookForLinks() {
  m_links = m_text.links();
  m_focused = 0;
  setFocusPolicy(m_links.empty() ? Qt::NoFocus : Qt::TabFocus);
  setMouseTracking(!m_links.empty());
  if (m_links.empty())
    unsetCursor();
}

bool RichLabel::event(QEvent *event) {
  if (event->type() != QEvent::ToolTip)
    return QWidget::event(event);
  showTip(*static_cast<QHelpEvent *>(event));
  return true;
}

void RichLabel::showTip(const QHelpEvent &help) {
  const QString problem = problemAt(help.pos());
  const QString tip = problem.isEmpty() ? tipOf(linkAt(help.pos())) : problem;
  if (tip.isEmpty())
    QToolTip::hideText();
  else
    QToolTip::showText(help.globalPos(), Qt::convertFromPlainText(tip, Qt::WhiteSpaceNormal), this);
}

/// Tab goes from link to link before it leaves.
bool RichLabel::focusNextPrevChild(bool next) {
  const int link = m_focused + (next ? 1 : -1);
  if (link < 0 || link >= static_cast<int>(m_links.size()))
    return QWidget::focusNextPrevChild(next);
  m_focused = link;
  update();
  return true;
}

void RichLabel::focusInEvent(QFocusEvent *event) {
  const bool fromBehind = event->reason() == Qt::BacktabFocusReason;
  m_focused = fromBehind ? static_cast<int>(m_links.size()) - 1 : 0;
  QWidget::focusInEvent(event);
}

void RichLabel::keyPressEvent(QKeyEvent *event) {
  const bool opens =
      event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Space;
  if (!opens || m_links.empty())
    return QWidget::keyPressEvent(event);
  QDesktopServices::openUrl(QUrl(m_links[static_cast<std::size_t>(m_focused)].charFormat().anchorHref()));
}

void RichLabel::mouseMoveEvent(QMouseEvent *event) {
  if (linkAt(event->pos()).isEmpty())
    unsetCursor();
  else
    setCursor(Qt::PointingHandCursor);
  QWidget::mouseMoveEvent(event);
}

void RichLabel::mousePressEvent(QMouseEvent *event) {
  m_pressed = event->button() == Qt::LeftButton ? linkAt(event->pos()) : QString();
  if (m_pressed.isEmpty())
    QWidget::mousePressEvent(event);
}

void RichLabel::mouseReleaseEvent(QMouseEvent *event) {
  const QString pressed = std::exchange(m_pressed, QString());
  if (pressed.isEmpty())
    return QWidget::mouseReleaseEvent(event);
  if (linkAt(event->pos()) == pressed)
    QDesktopServices::openUrl(QUrl(pressed));
}

void RichLabel::paintEvent(QPaintEvent *) {
  QPainter painter(this);
  QAbstractTextDocumentLayout::PaintContext context;
  if (hasFocus() && !m_links.empty()) {
    QTextCharFormat focused;
    focused.setBackground(palette().highlight());
    focused.setForeground(palette().highlightedText());
    context.selections.push_back({m_links[static_cast<std::size_t>(m_focused)], focused});
  }
  layOut(width()).documentLayout()->draw(&painter, context);
}

void RichLabel::changeEvent(QEvent *event) {
  if (event->type() == QEvent::FontChange)
    build();
  QWidget::changeEvent(event);
}

} // namespace halfspace
