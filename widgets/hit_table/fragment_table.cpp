#include "widgets/hit_table/fragment_table.h"

#include "widgets/hit_table/fragment_words.h"
#include "widgets/speak_by.h"

#include <QAccessibleWidget>
#include <QKeyEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

// In heights of a line.
constexpr double smallestWidthInLines = 10;
constexpr double usualWidthInLines = 24;

/// What a screen reader is told, made when it asks.
class SpokenTable : public QAccessibleWidget {
public:
  explicit SpokenTable(FragmentTable &table) : QAccessibleWidget(&table, QAccessible::List), m_table(table) {}

  [[nodiscard]] QString text(QAccessible::Text text) const override {
    if (text != QAccessible::Description)
      return QAccessibleWidget::text(text);
    QStringList rows;
    for (std::size_t row = 0; row < m_table.rows().size(); ++row)
      rows << m_table.spoken(row);
    if (const QString more = m_table.leftOutWords(); !more.isEmpty())
      rows << more;
    return rows.join("; ");
  }

private:
  const FragmentTable &m_table;
};

} // namespace

FragmentTable::FragmentTable(const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_numbers(typesetter), m_start(typesetter.picture(math::row(math::letter('Q')))),
      m_theme(themes().front()) {
  speakBy<FragmentTable, SpokenTable>();
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Fragments"));
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  measure();
}

void FragmentTable::setCrossings(const Crossings &crossings, LiveValues values) {
  m_values = values;
  m_shown = rowsOf(crossings, values, mostRows);
  if (std::exchange(m_chosen, crossings.chosen) != m_chosen && hasFocus())
    sayChosen();
  m_names.clear();
  for (const Crossing &crossing : crossings.all)
    m_names << QString::fromStdString(crossing.name);
  m_numbers.write(m_shown, values);
  measure();
  settleHeight();
  update();
}

void FragmentTable::sayChosen() {
  const std::optional<std::size_t> row = rowOf(m_shown, m_chosen);
  setAccessibleName(row ? tr("Fragments: %1", "a row").arg(spoken(*row)) : tr("Fragments"));
}

void FragmentTable::setHovered(std::size_t number) {
  if (std::exchange(m_hovered, number) != number)
    update();
}

void FragmentTable::setHeld(bool held) {
  m_held = held;
  settleHeight();
}

void FragmentTable::setTheme(const Theme &theme) {
  m_theme = theme;
  update();
}

void FragmentTable::measure() {
  FragmentNeeds needs = needsOf(m_names, font(), m_numbers.greatestWidth());
  if (m_held)
    needs.name = std::max(needs.name, m_needs.name);
  if (std::exchange(m_needs, needs) != needs)
    updateGeometry();
}

void FragmentTable::settleHeight() {
  const double lines = static_cast<double>(m_shown.rows.size()) + (m_shown.leftOut > 0 ? 1 : 0);
  const double settled = m_held ? std::max(m_lineCount, lines) : lines;
  if (std::exchange(m_lineCount, settled) != settled)
    updateGeometry();
}

QString FragmentTable::leftOutWords() const { return halfspace::leftOutWords(m_shown); }

QString FragmentTable::spoken(std::size_t row) const { return spokenRow(m_shown.rows.at(row), m_values); }

QRect FragmentTable::rowRect(std::size_t row) const {
  const FragmentColumns placed = columnsIn(width(), m_needs);
  const double top = placed.rowHeight * static_cast<double>(row + 1); // below the head
  return QRectF(0, top, placed.width, placed.rowHeight).toAlignedRect();
}

int FragmentTable::heightForWidth(int width) const {
  const FragmentColumns placed = columnsIn(width, m_needs);
  return static_cast<int>(std::ceil(placed.rowHeight * (m_lineCount + 1)));
}

QSize FragmentTable::sizeHint() const {
  const int usual = static_cast<int>(usualWidthInLines * m_needs.line);
  return {usual, heightForWidth(usual)};
}

QSize FragmentTable::minimumSizeHint() const {
  const int least = static_cast<int>(smallestWidthInLines * m_needs.line);
  return {least, 0};
}

std::size_t FragmentTable::numberAt(QPoint place) const {
  for (std::size_t i = 0; i < m_shown.rows.size(); ++i)
    if (rowRect(i).contains(place))
      return m_shown.rows[i].crossing.number;
  return 0;
}

void FragmentTable::pointAt(std::size_t number) {
  if (number == m_hovered)
    return;
  setHovered(number);
  if (number == 0)
    unsetCursor();
  else
    setCursor(Qt::PointingHandCursor);
  emit hovered(number);
}

void FragmentTable::mouseMoveEvent(QMouseEvent *event) { pointAt(numberAt(event->pos())); }

void FragmentTable::mousePressEvent(QMouseEvent *event) {
  const std::size_t number = event->button() == Qt::LeftButton ? numberAt(event->pos()) : 0;
  if (number == 0)
    return QWidget::mousePressEvent(event);
  emit chosen(number);
}

void FragmentTable::leaveEvent(QEvent *event) {
  pointAt(0);
  QWidget::leaveEvent(event);
}

void FragmentTable::keyPressEvent(QKeyEvent *event) {
  const std::size_t count = m_shown.rows.size();
  const std::optional<std::size_t> row = rowOf(m_shown, m_chosen);
  if (count == 0)
    return QWidget::keyPressEvent(event);
  const auto chooseRow = [this](std::size_t other) { emit chosen(m_shown.rows[other].crossing.number); };
  switch (event->key()) {
  case Qt::Key_Down:
    return chooseRow(row ? std::min(*row + 1, count - 1) : 0);
  case Qt::Key_Up:
    return chooseRow(row ? *row - std::min<std::size_t>(*row, 1) : count - 1);
  case Qt::Key_Return:
  case Qt::Key_Enter:
    return chooseRow(row.value_or(0));
  default:
    QWidget::keyPressEvent(event);
  }
}

void FragmentTable::focusInEvent(QFocusEvent *event) {
  sayChosen();
  QWidget::focusInEvent(event); // it paints the table anew
}

void FragmentTable::changeEvent(QEvent *event) {
  if (event->type() == QEvent::FontChange)
    measure();
  QWidget::changeEvent(event);
}

void FragmentTable::paintEvent(QPaintEvent *) {
  QPainter painter(this);
  paintFragments(painter, {m_shown, m_values, m_numbers, *m_start, m_theme, m_chosen, m_hovered, hasFocus()},
                 columnsIn(width(), m_needs));
}

} // namespace halfspace
