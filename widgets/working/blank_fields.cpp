#include "widgets/working/blank_fields.h"

#include "widgets/working/blank_field.h"

#include <QApplication>

#include <algorithm>

namespace halfspace {
namespace {

/// A field reaches so far below the baseline, in em of the formulas.
constexpr double fieldDepth = 0.4;

/// The width of a gap's field.
int lettersFor(const Gap &gap) {
  constexpr int partOfFormula = 9;
  constexpr int number = 12;
  constexpr int list = 20;
  constexpr int equation = 26;
  const TermValue &truth = *gap.hidden->value;
  if (truth.isList)
    return list;
  if (truth.entries.front().hasUnknowns())
    return equation;
  return gap.isResult ? number : partOfFormula;
}

/// A field in its place in a formula. Where the formula is drawn smaller the field is not, nor is its button
/// cut.
QRect roomOf(const BlankField &field, const QRectF &blank, int right) {
  const QSize size = blank.size().toSize().expandedTo(field.minimumSizeHint());
  QRect room(QPoint(qRound(blank.left()), qRound(blank.center().y() - size.height() / 2.0)), size);
  room.moveRight(std::min(room.right(), right));
  return room;
}

void drop(BlankField &field) {
  field.hide();
  field.deleteLater(); // its own signal may have led here
}

} // namespace

BlankFields::BlankFields(QWidget &block, const BlockLayout &layout) : m_block(block), m_layout(layout) {
  connect(qApp, &QApplication::focusChanged, this,
          [this](QWidget *, const QWidget *focused) { followFocus(focused); });
}

BlankField *BlankFields::fieldOf(const std::string &lineId) const {
  const auto field = m_fields.find(lineId);
  return field == m_fields.end() ? nullptr : field->second;
}

void BlankFields::forget() {
  for (const auto &[line, field] : m_fields)
    drop(*field);
  m_fields.clear();
}

bool BlankFields::match(const ShownLines &lines, const LineRemarks &remarks) {
  std::map<std::string, BlankField *> before = std::exchange(m_fields, {});
  for (const WorkingLine &line : lines.lines())
    if (const Gap *gap = lines.gapOf(line.id)) {
      if (const auto field = before.extract(line.id); !field.empty())
        m_fields[line.id] = field.mapped();
      else if (!fieldOf(line.id))
        add(line, *gap);
      fieldOf(line.id)->setQuestion(QString::fromStdString(questionText(line, *gap)));
    }
  bool lostFocus = false;
  for (const auto &[line, field] : before) {
    lostFocus = lostFocus || field->isAncestorOf(QApplication::focusWidget());
    drop(*field);
  }
  for (const auto &[line, field] : m_fields) {
    const auto remark = remarks.find(line);
    field->setRemark(remark != remarks.end() && remark->second.isOfNow ? remark->second.text : QString());
  }
  return lostFocus;
}

void BlankFields::add(const WorkingLine &line, const Gap &gap) {
  auto *field = new BlankField(lettersFor(gap), &m_block);
  const QString id = QString::fromStdString(line.id);
  connect(field, &BlankField::answered, this, [this, id](const QString &text) {
    emit answered(id, text);
    bringIntoView(id.toStdString()); // with what is said of the answer
  });
  connect(field, &BlankField::showRequested, this, [this, id] { emit showRequested(id); });
  m_fields[line.id] = field;
}

void BlankFields::bringIntoView(const std::string &lineId) {
  for (std::size_t i = 0; i < m_layout.placed().lines.size(); ++i)
    if (m_layout.lines()[i].source.id == lineId)
      emit reached(m_layout.roomOf(i));
}

math::Room BlankFields::roomFor(const std::string &lineId) const {
  const QSizeF size = QSizeF(m_fields.at(lineId)->sizeHint()) / emPixelsOf(m_block.font());
  return {size.width(), size.height() - fieldDepth, fieldDepth};
}

void BlankFields::place() {
  for (std::size_t i = 0; i < m_layout.placed().lines.size(); ++i)
    if (BlankField *field = fieldOf(m_layout.lines()[i].source.id)) {
      field->setGeometry(roomOf(*field, m_layout.placed().lines[i].blank, m_block.rect().right()));
      field->show();
    }
}

bool BlankFields::focusFirst() {
  if (!m_block.isVisible())
    return false;
  for (const TypesetLine &line : m_layout.lines())
    if (BlankField *field = fieldOf(line.source.id)) {
      field->setFocus();
      return true;
    }
  return false;
}

void BlankFields::focusIn(std::size_t line) {
  if (BlankField *field = fieldOf(m_layout.lines().at(line).source.id))
    field->setFocus();
}

void BlankFields::followFocus(const QWidget *focused) {
  for (std::size_t i = 0; i < m_layout.placed().lines.size(); ++i)
    if (const BlankField *field = fieldOf(m_layout.lines()[i].source.id);
        field && field->isAncestorOf(focused))
      emit entered(i);
}

} // namespace halfspace
