#include "widgets/working_panel.h"

#include "widgets/colors.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>

#include <algorithm>
#include <cmath>

namespace halfspace {

namespace {

/// How near the pointer must come to a term, and how far its highlight reaches around it, in pixels.
constexpr double termMargin = 3;
constexpr double highlightRadius = 4;
constexpr double highlightOpacity = 0.20;
constexpr double currentBarWidth = 3;
constexpr QSize usualSize(400, 480);

QStringList formulasOf(const Working &working) {
  QStringList formulas;
  for (const WorkingLine &line : working.lines)
    for (const std::string *piece : {&line.symbols, &line.numbers, &line.result})
      if (!piece->empty())
        formulas << QString::fromStdString(*piece);
  return formulas;
}

QString plainTextOf(const WorkingLine &line, bool blanked) {
  std::string formula = line.symbols;
  if (!blanked)
    formula += " " + line.numbers + " " + line.result;
  QString text = QString::fromStdString(plainText(formula)).trimmed();
  if (!blanked && !line.sentence.empty())
    text += QStringLiteral(". ") + QString::fromStdString(line.sentence);
  return text;
}

} // namespace

WorkingPanel::WorkingPanel(Typesetter &typesetter, QWidget *parent)
    : QAbstractScrollArea(parent), m_typesetter(typesetter), m_request(typesetter),
      m_theme(themes().front()) {
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Working"));
  viewport()->setMouseTracking(true);
  viewport()->setAutoFillBackground(false);
  connect(&typesetter, &Typesetter::ready, this, &WorkingPanel::showRequested);
}

WorkingPanel::~WorkingPanel() = default;

void WorkingPanel::setWorking(const Working &working) {
  // A working that is half typeset is finished first: else nothing would ever be shown during a long drag.
  if (m_requested)
    m_waiting = working;
  else
    request(working);
}

void WorkingPanel::request(const Working &working) {
  m_requested = working;
  m_request.setWanted(formulasOf(working));
  showRequested();
}

void WorkingPanel::showRequested() {
  if (!m_requested || !m_request.isComplete())
    return;
  const auto pictureOf = [this](const std::string &latex) {
    return latex.empty() ? nullptr : m_typesetter.known(QString::fromStdString(latex));
  };
  m_lines.clear();
  for (const WorkingLine &line : m_requested->lines)
    m_lines.push_back({line, {pictureOf(line.symbols), pictureOf(line.numbers), pictureOf(line.result)}});
  m_requested.reset();
  if (m_current && *m_current >= m_lines.size())
    m_current.reset();
  placeLines();
  updateAccessibleText();
  if (m_waiting)
    request(*std::exchange(m_waiting, std::nullopt));
}

void WorkingPanel::setTheme(const Theme &theme) {
  m_theme = theme;
  viewport()->update();
}

void WorkingPanel::setInkOf(std::function<QColor(const QString &)> inkOf) {
  m_inkOf = std::move(inkOf);
  viewport()->update();
}

void WorkingPanel::setHighlighted(std::set<std::string> markIds) {
  if (markIds == m_highlighted)
    return;
  m_highlighted = std::move(markIds);
  viewport()->update();
}

void WorkingPanel::setBlanked(std::set<std::string> lineIds) {
  if (lineIds == m_blanked)
    return;
  m_blanked = std::move(lineIds);
  placeLines();
  updateAccessibleText();
}

void WorkingPanel::placeLines() {
  const QSize room = viewport()->size();
  m_placed = placeWorking(m_lines, m_blanked, font(), room.width());
  const QSize content(static_cast<int>(std::ceil(m_placed.size.width())),
                      static_cast<int>(std::ceil(m_placed.size.height())));
  verticalScrollBar()->setRange(0, std::max(0, content.height() - room.height()));
  verticalScrollBar()->setPageStep(room.height());
  verticalScrollBar()->setSingleStep(fontMetrics().height() * 2);
  horizontalScrollBar()->setRange(0, std::max(0, content.width() - room.width()));
  horizontalScrollBar()->setPageStep(room.width());
  viewport()->update();
}

void WorkingPanel::updateAccessibleText() {
  QStringList texts;
  for (const TypesetLine &line : m_lines)
    texts << plainTextOf(line.source, m_blanked.count(line.source.id) > 0);
  setAccessibleDescription(texts.join(u'\n'));
}

PlacedWorking WorkingPanel::placed() const {
  PlacedWorking placed = m_placed;
  for (PlacedLine &line : placed.lines) {
    line.box.translate(-scrolled());
    for (PlacedText &text : line.sentence)
      text.baseline -= scrolled();
    if (!line.blank.isNull())
      line.blank.translate(-scrolled());
    for (PlacedFormula &formula : line.formulas)
      formula.baseline -= scrolled();
  }
  return placed;
}

QString WorkingPanel::latexOf(const WorkingLine &line) const {
  std::string latex = line.symbols;
  if (!m_blanked.count(line.id))
    for (const std::string *piece : {&line.numbers, &line.result})
      latex += (piece->empty() ? "" : " ") + *piece;
  return QString::fromStdString(withoutMarks(latex));
}

QString WorkingPanel::latexOfAll() const {
  QStringList lines;
  for (const TypesetLine &line : m_lines)
    lines << latexOf(line.source);
  return lines.join(QLatin1String(" \\\\\n"));
}

QSize WorkingPanel::sizeHint() const { return usualSize; }

QPointF WorkingPanel::scrolled() const {
  return QPointF(horizontalScrollBar()->value(), verticalScrollBar()->value());
}

std::optional<std::size_t> WorkingPanel::lineAt(QPointF position) const {
  for (std::size_t i = 0; i < m_placed.lines.size(); ++i)
    if (const QRectF &box = m_placed.lines[i].box; position.y() >= box.top() && position.y() < box.bottom())
      return i;
  return std::nullopt;
}

QString WorkingPanel::markAt(QPointF position) const {
  const auto line = lineAt(position);
  if (!line)
    return {};
  QString found;
  for (const PlacedFormula &formula : m_placed.lines[*line].formulas)
    for (const auto &[mark, box] : formula.picture->markBoxes()) // the innermost comes last
      if (formula.toWorking(box)
              .adjusted(-termMargin, -termMargin, termMargin, termMargin)
              .contains(position))
        found = mark;
  return found;
}

QColor WorkingPanel::inkOf(const QString &markId) const {
  return markId.isEmpty() || !m_inkOf ? toQColor(m_theme.ink) : m_inkOf(markId);
}

// --- painting
// ------------------------------------------------------------------------------------------------------

void WorkingPanel::paintEvent(QPaintEvent *event) {
  QPainter painter(viewport());
  painter.fillRect(event->rect(), toQColor(m_theme.panel));
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(-scrolled());
  const QRectF visible = QRectF(event->rect()).translated(scrolled());
  for (std::size_t i = 0; i < m_placed.lines.size(); ++i)
    if (m_placed.lines[i].box.intersects(visible))
      paintLine(painter, i);
}

void WorkingPanel::paintLine(QPainter &painter, std::size_t index) const {
  const PlacedLine &line = m_placed.lines[index];
  if (index > 0) {
    const double margin = fontMetrics().height();
    painter.setPen(QPen(toQColor(m_theme.border), 1));
    const double y = std::floor(line.box.top()) + 0.5; // on whole pixels
    painter.drawLine(QPointF(margin, y), QPointF(line.box.right() - margin, y));
  }
  if (m_current == index && hasFocus()) {
    const QRectF bar(0, line.box.top() + termMargin, currentBarWidth, line.box.height() - 2 * termMargin);
    painter.fillRect(bar, toQColor(m_theme.accent));
  }
  for (const PlacedFormula &formula : line.formulas) {
    paintHighlights(painter, formula);
    const bool failed = !formula.picture->error().isEmpty();
    formula.picture->paint(painter, formula.baseline, formula.exPixels, [&](const QString &mark) {
      return failed ? toQColor(m_theme.warning) : inkOf(mark);
    });
  }
  if (!line.blank.isNull())
    paintBlank(painter, line.blank);
  painter.setPen(toQColor(m_theme.mutedInk));
  for (const PlacedText &text : line.sentence)
    painter.drawText(text.baseline, text.text);
}

void WorkingPanel::paintHighlights(QPainter &painter, const PlacedFormula &formula) const {
  painter.setPen(Qt::NoPen);
  for (const auto &[mark, box] : formula.picture->markBoxes()) {
    if (!m_highlighted.count(mark.toStdString()))
      continue;
    QColor background = inkOf(mark);
    background.setAlphaF(highlightOpacity);
    painter.setBrush(background);
    const QRectF term = formula.toWorking(box).adjusted(-termMargin, -termMargin, termMargin, termMargin);
    painter.drawRoundedRect(term, highlightRadius, highlightRadius);
  }
}

void WorkingPanel::paintBlank(QPainter &painter, const QRectF &blank) const {
  painter.setPen(QPen(toQColor(m_theme.mutedInk), 1.2, Qt::DotLine, Qt::RoundCap));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(blank, highlightRadius, highlightRadius);
  painter.drawText(blank, Qt::AlignCenter, QStringLiteral("?"));
}

// --- pointer and keys
// ----------------------------------------------------------------------------------------------

void WorkingPanel::resizeEvent(QResizeEvent *) { placeLines(); }

void WorkingPanel::changeEvent(QEvent *event) {
  if (event->type() == QEvent::FontChange)
    placeLines();
  QAbstractScrollArea::changeEvent(event);
}

void WorkingPanel::mouseMoveEvent(QMouseEvent *event) { hover(markAt(QPointF(event->pos()) + scrolled())); }

void WorkingPanel::mousePressEvent(QMouseEvent *event) {
  setCurrentLine(lineAt(QPointF(event->pos()) + scrolled()));
}

bool WorkingPanel::viewportEvent(QEvent *event) {
  if (event->type() == QEvent::Leave)
    hover({});
  return QAbstractScrollArea::viewportEvent(event);
}

void WorkingPanel::hover(const QString &markId) {
  if (markId == m_hovered)
    return;
  m_hovered = markId;
  emit markHovered(markId);
}

void WorkingPanel::setCurrentLine(std::optional<std::size_t> line) {
  m_current = line;
  if (line) {
    const QRectF &box = m_placed.lines[*line].box;
    QScrollBar &bar = *verticalScrollBar();
    const int lowest = static_cast<int>(std::ceil(box.bottom())) - viewport()->height();
    const int highest = static_cast<int>(box.top());
    bar.setValue(std::min(std::max(bar.value(), lowest), highest));
  }
  viewport()->update();
}

void WorkingPanel::keyPressEvent(QKeyEvent *event) {
  if (event->matches(QKeySequence::Copy)) {
    copy(m_current ? latexOf(m_lines[*m_current].source) : latexOfAll());
  } else if (event->key() == Qt::Key_Down && !m_lines.empty()) {
    setCurrentLine(m_current ? std::min(*m_current + 1, m_lines.size() - 1) : 0);
  } else if (event->key() == Qt::Key_Up && !m_lines.empty()) {
    setCurrentLine(m_current && *m_current > 0 ? *m_current - 1 : 0);
  } else {
    QAbstractScrollArea::keyPressEvent(event);
  }
}

void WorkingPanel::contextMenuEvent(QContextMenuEvent *event) {
  if (m_lines.empty())
    return;
  const auto line = lineAt(viewport()->mapFromGlobal(event->globalPos()) + scrolled());
  QMenu menu(this);
  // The lines may change while the menu is open.
  if (line)
    menu.addAction(tr("Copy this line as LaTeX"), this,
                   [this, latex = latexOf(m_lines[*line].source)] { copy(latex); });
  menu.addAction(tr("Copy all lines as LaTeX"), this, [this] { copy(latexOfAll()); });
  menu.exec(event->globalPos());
}

void WorkingPanel::copy(const QString &text) const { QApplication::clipboard()->setText(text); }

} // namespace halfspace
