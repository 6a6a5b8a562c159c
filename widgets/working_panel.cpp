#include "widgets/working_panel.h"

#include "widgets/blank_field.h"
#include "widgets/colors.h"
#include "widgets/picture/term_formula.h"
#include "widgets/task_row.h"

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
constexpr double remarkMarkRadius = 6.5;
constexpr QSize usualSize(400, 480);

/// What a screen reader says of a line.
QString spokenOf(const WorkingLine &line, bool blanked) {
  if (blanked)
    return QString::fromStdString(questionText(line));
  QString text = QString::fromStdString(plainText(line));
  if (!line.sentence.empty())
    text += QStringLiteral(". ") + QString::fromStdString(line.sentence);
  return text;
}

} // namespace

WorkingPanel::WorkingPanel(const Typesetter &typesetter, QWidget *parent)
    : QAbstractScrollArea(parent), m_typesetter(typesetter), m_theme(themes().front()) {
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Working"));
  viewport()->setMouseTracking(true);
  viewport()->setAutoFillBackground(false);
  connect(qApp, &QApplication::focusChanged, this,
          [this](QWidget *, QWidget *focused) { followFocus(focused); });
}

WorkingPanel::~WorkingPanel() = default;

void WorkingPanel::setWorking(const Working &working) {
  const auto pictureOf = [this](const math::Row &formula) {
    return formula.empty() ? nullptr : m_typesetter.picture(formula);
  };
  m_lines.clear();
  for (const WorkingLine &line : working.lines)
    m_lines.push_back(
        {line,
         {pictureOf(formulaOf(line, LinePiece::Symbols)), pictureOf(formulaOf(line, LinePiece::Numbers)),
          pictureOf(formulaOf(line, LinePiece::Result))},
         line.blank ? pictureOf(promptOf(*line.blank)) : nullptr});
  if (m_current && *m_current >= m_lines.size())
    m_current.reset();
  placeLines();
  updateAccessibleText();
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

void WorkingPanel::hideNumbers() {
  if (m_numbersHidden)
    return;
  m_numbersHidden = true;
  m_blanks.clear();
  m_remarks.clear();
  placeLines();
  updateAccessibleText();
}

void WorkingPanel::setBlanks(std::set<std::string> lineIds, std::map<std::string, LineRemark> remarks) {
  if (!m_numbersHidden && lineIds == m_blanks && remarks == m_remarks)
    return;
  m_numbersHidden = false;
  m_blanks = std::move(lineIds);
  m_remarks = std::move(remarks);
  placeLines();
  updateAccessibleText();
  followFocus(QApplication::focusWidget()); // what is said about a line makes it taller
}

bool WorkingPanel::isBlank(const std::string &lineId) const {
  return m_numbersHidden || m_blanks.contains(lineId);
}

std::map<std::string, LineState> WorkingPanel::lineStates() const {
  std::map<std::string, LineState> states;
  for (const auto &[line, remark] : m_remarks)
    states[line].remark = remark.text;
  for (const TypesetLine &line : m_lines)
    states[line.source.id].blank = isBlank(line.source.id);
  for (const auto &[line, field] : m_fields)
    states[line].field = field->sizeHint();
  return states;
}

void WorkingPanel::placeLines() {
  const bool lostFocus = matchFields();
  const QSize room = viewport()->size();
  m_placed = placeWorking(m_lines, lineStates(), font(), room.width());
  const QSize content(static_cast<int>(std::ceil(m_placed.size.width())),
                      static_cast<int>(std::ceil(m_placed.size.height())));
  verticalScrollBar()->setRange(0, std::max(0, content.height() - room.height()));
  verticalScrollBar()->setPageStep(room.height());
  verticalScrollBar()->setSingleStep(fontMetrics().height() * 2);
  horizontalScrollBar()->setRange(0, std::max(0, content.width() - room.width()));
  horizontalScrollBar()->setPageStep(room.width());
  moveFields();
  viewport()->update();
  if (lostFocus)
    focusField();
}

bool WorkingPanel::matchFields() {
  std::set<std::string> wanted;
  for (const TypesetLine &line : m_lines)
    if (m_blanks.contains(line.source.id)) {
      wanted.insert(line.source.id);
      if (!m_fields.contains(line.source.id))
        addField(line.source);
    }
  bool lostFocus = false;
  std::erase_if(m_fields, [&](const auto &each) {
    if (wanted.contains(each.first))
      return false;
    lostFocus = lostFocus || each.second->isAncestorOf(QApplication::focusWidget());
    each.second->hide();
    each.second->deleteLater(); // its own signal may have led here
    return true;
  });
  for (const auto &[line, field] : m_fields)
    field->setRemark(m_remarks.contains(line) ? m_remarks.at(line).text : QString());
  return lostFocus;
}

void WorkingPanel::focusField() {
  for (const TypesetLine &line : m_lines)
    if (const auto field = m_fields.find(line.source.id); field != m_fields.end())
      return field->second->setFocus();
  setFocus();
}

void WorkingPanel::followFocus(QWidget *focused) {
  for (std::size_t i = 0; i < m_placed.lines.size(); ++i)
    if (const auto field = m_fields.find(m_lines[i].source.id);
        field != m_fields.end() && field->second->isAncestorOf(focused))
      setCurrentLine(i);
}

void WorkingPanel::addField(const WorkingLine &line) {
  auto *field = new BlankField(QString::fromStdString(questionText(line)),
                               line.blank ? line.blank->answer.size() : 0, viewport());
  const QString id = QString::fromStdString(line.id);
  connect(field, &BlankField::answered, this, [this, id](const QString &text) { emit answered(id, text); });
  connect(field, &BlankField::showRequested, this, [this, id] { emit showRequested(id); });
  m_fields[line.id] = field;
}

void WorkingPanel::moveFields() {
  for (std::size_t i = 0; i < m_placed.lines.size(); ++i)
    if (const auto field = m_fields.find(m_lines[i].source.id); field != m_fields.end()) {
      field->second->setGeometry(m_placed.lines[i].blank.translated(-scrolled()).toRect());
      field->second->show();
    }
}

void WorkingPanel::scrollContentsBy(int, int) {
  moveFields();
  viewport()->update();
}

void WorkingPanel::updateAccessibleText() {
  QStringList texts;
  for (const TypesetLine &line : m_lines)
    texts << spokenOf(line.source, isBlank(line.source.id));
  setAccessibleDescription(texts.join(u'\n'));
}

PlacedWorking WorkingPanel::placed() const {
  PlacedWorking placed = m_placed;
  for (PlacedLine &line : placed.lines) {
    line.box.translate(-scrolled());
    for (std::vector<PlacedText> *texts : {&line.remark, &line.sentence})
      for (PlacedText &text : *texts)
        text.baseline -= scrolled();
    if (!line.blank.isNull())
      line.blank.translate(-scrolled());
    for (PlacedFormula &formula : line.formulas)
      formula.baseline -= scrolled();
  }
  return placed;
}

QString WorkingPanel::latexOf(const WorkingLine &line) const {
  return QString::fromStdString(isBlank(line.id) ? halfspace::latexOf(line, LinePiece::Symbols)
                                                 : halfspace::latexOf(line));
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
    const int margin = fontMetrics().height();
    const QRect separator(margin, static_cast<int>(line.box.top()),
                          static_cast<int>(line.box.width()) - 2 * margin, 1);
    painter.fillRect(separator, toQColor(m_theme.border)); // a line costs as much as all formulas together
  }
  if (m_current == index && hasFocus()) {
    const QRectF bar(0, line.box.top() + termMargin, currentBarWidth, line.box.height() - 2 * termMargin);
    painter.fillRect(bar, toQColor(m_theme.accent));
  }
  for (const PlacedFormula &formula : line.formulas) {
    paintHighlights(painter, formula);
    const bool failed = !formula.picture->error().isEmpty();
    formula.picture->paint(painter, formula.baseline, formula.emPixels, [&](const QString &mark) {
      return failed ? toQColor(m_theme.warning) : inkOf(mark);
    });
  }
  if (!line.blank.isNull() && !m_fields.contains(m_lines[index].source.id))
    paintBlank(painter, line.blank);
  if (const auto remark = m_remarks.find(m_lines[index].source.id); remark != m_remarks.end())
    paintRemark(painter, line, remark->second);
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

void WorkingPanel::paintRemark(QPainter &painter, const PlacedLine &line, const LineRemark &remark) const {
  if (line.remark.empty())
    return;
  const double middle = fontMetrics().capHeight() / 2.0;
  const QPointF first = line.remark.front().baseline;
  paintVerdict(painter, first - QPointF(1.5 * remarkMarkRadius, middle), remarkMarkRadius,
               remark.right ? Verdict::Right : Verdict::Wrong, m_theme);
  painter.setPen(toQColor(remark.right ? m_theme.inkOf(Subject::Triangle) : m_theme.warning));
  for (const PlacedText &text : line.remark)
    painter.drawText(text.baseline, text.text);
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
  if (const auto field = m_current ? m_fields.find(m_lines[*m_current].source.id) : m_fields.end();
      field != m_fields.end())
    field->second->setFocus();
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
