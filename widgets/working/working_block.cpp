#include "widgets/working/working_block.h"

#include "widgets/numbers/number_words.h"
#include "widgets/speak_by.h"
#include "widgets/working/copy_lines.h"
#include "widgets/working/typeset_lines.h"

#include <QAccessibleWidget>
#include <QApplication>
#include <QKeyEvent>
#include <QPainter>

#include <cmath>
#include <utility>

namespace halfspace {
namespace {

/// Tells a screen reader of the lines.
class SpokenBlock : public QAccessibleWidget {
public:
  explicit SpokenBlock(WorkingBlock &block) : QAccessibleWidget(&block), m_block(block) {}

  [[nodiscard]] QString text(QAccessible::Text text) const override {
    return text == QAccessible::Description ? m_block.spoken() : QAccessibleWidget::text(text);
  }

private:
  const WorkingBlock &m_block;
};

constexpr int usualWidth = 400;

} // namespace

WorkingBlock::WorkingBlock(const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_typesetter(typesetter) {
  speakBy<WorkingBlock, SpokenBlock>();
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Worked lines"));
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  setContextMenuPolicy(Qt::CustomContextMenu);
  connect(this, &QWidget::customContextMenuRequested, this, [this](QPoint place) {
    if (!m_lines.lines().empty())
      showCopyMenu(*this, mapToGlobal(place), m_lines, m_layout.lineAt(place));
  });
  connectParts();
}

void WorkingBlock::connectParts() {
  connect(&m_cursor, &LineCursor::changed, this, qOverload<>(&QWidget::update));
  connect(&m_cursor, &LineCursor::choiceChanged, this,
          [this] { tellSpoken(*this, QAccessible::DescriptionChanged); });
  connect(&m_cursor, &LineCursor::reached, this, &WorkingBlock::reached);
  connect(&m_cursor, &LineCursor::chosenUsed, this, [this](const NumberPlace &number) {
    if (number.coordinate())
      m_coordinates.openField(number);
    else
      emit traceRequested(number);
  });
  connect(&m_blanks, &BlankFields::entered, &m_cursor, &LineCursor::goTo);
  connect(&m_blanks, &BlankFields::reached, this, &WorkingBlock::reached);
  connect(&m_coordinates, &CoordinateInput::refusalChanged, this,
          &WorkingBlock::placeLines); // the sentence takes its room
  connect(&m_pointer, &BlockPointer::markHovered, this, &WorkingBlock::markHovered);
  connect(&m_pointer, &BlockPointer::traceRequested, this, &WorkingBlock::traceRequested);
  connect(&m_pointer, &BlockPointer::traceDropped, this, &WorkingBlock::traceDropped);
}

void WorkingBlock::setWorking(const Working &working, Fade fade, LineRemarks remarks, LineRange shown) {
  m_lines = ShownLines(working, shown, std::move(fade));
  const bool saysMore = remarks != m_remarks;
  m_remarks = std::move(remarks);
  if (!m_typeset.renew())
    return m_layout.clear(); // what stood there is not shown any more
  if (saysMore)
    m_blanks.followFocus(QApplication::focusWidget()); // what is said about a line makes it taller
}

void WorkingBlock::showLines() {
  const bool lostFocus = m_blanks.match(m_lines, m_remarks);
  m_layout.setLines(typesetLines(
      m_typesetter, m_lines, [this](const std::string &line) { return m_blanks.roomFor(line); },
      m_layout.lines()));
  m_cursor.followLines();
  placeLines();
  tellSpoken(*this, QAccessible::DescriptionChanged);
  if (lostFocus && !m_blanks.focusFirst())
    setFocus();
}

void WorkingBlock::placeLines() {
  LineRemarks remarks = m_remarks;
  if (const auto &refusal = m_coordinates.refusal())
    remarks[refusal->line] = LineRemark{refusal->sentence};
  m_layout.setRemarks(std::move(remarks));
  const double before = m_layout.placed().size.height();
  m_layout.place(font(), width());
  if (m_layout.placed().size.height() != before)
    updateGeometry();
  m_blanks.place();
  m_coordinates.followLines();
  update();
}

void WorkingBlock::setHeld(bool held) {
  if (held == m_layout.isHeld())
    return;
  m_layout.setHeld(held);
  if (!held)
    placeLines();
}

void WorkingBlock::setLook(const WorkingLook &look) {
  m_look = look;
  update();
}

void WorkingBlock::setTrace(ShownTrace trace) {
  m_trace = std::move(trace);
  update();
}

QString WorkingBlock::spoken() const {
  const Term *chosen = m_cursor.chosenNumber();
  return chosen ? spokenWithOrigin(*chosen) : m_lines.spoken();
}

int WorkingBlock::heightForWidth(int width) const {
  return static_cast<int>(
      std::ceil(width == this->width() ? m_layout.placed().size.height() : m_layout.heightIn(font(), width)));
}

QSize WorkingBlock::sizeHint() const { return {usualWidth, heightForWidth(usualWidth)}; }

QSize WorkingBlock::minimumSizeHint() const {
  return {static_cast<int>(std::ceil(narrowestWidth(m_layout.lines(), font()))), 0};
}

void WorkingBlock::paintEvent(QPaintEvent *event) {
  QPainter painter(this);
  paintBlock(painter, event->rect(), height(), m_look.theme);
  paintLines(painter, event->rect(), m_layout, m_look, m_trace,
             {m_pointer.hovered(), m_cursor.chosen(), m_cursor.line(), hasFocus()});
}

void WorkingBlock::resizeEvent(QResizeEvent *) {
  m_layout.forgetHeights();
  placeLines();
}

bool WorkingBlock::event(QEvent *event) {
  // A field has another size, or may have got one while nobody saw it, of which nothing is told.
  const bool mayChangeFields = event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show;
  if (event->type() == QEvent::FontChange || (mayChangeFields && !m_blanks.isEmpty()))
    showLines();
  return QWidget::event(event);
}

void WorkingBlock::keyPressEvent(QKeyEvent *event) {
  if (event->matches(QKeySequence::Copy))
    return copyLines(m_lines.told(), m_cursor.line(), DocumentFormat::Latex);
  if (m_coordinates.useKey(event->key()) || m_cursor.useKey(event->key()))
    return;
  const bool letsGo = event->key() == Qt::Key_Escape;
  const bool holdsNumber = m_trace.number || m_cursor.chosen();
  if (letsGo)
    emit traceDropped();
  if (!letsGo || !holdsNumber)
    QWidget::keyPressEvent(event);
}

} // namespace halfspace
