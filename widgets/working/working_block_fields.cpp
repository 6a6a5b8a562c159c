// The fields in blank lines.
#include "widgets/working/blank_field.h"
#include "widgets/working/working_block.h"

#include <QApplication>

#include <algorithm>

namespace halfspace {
namespace {

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

} // namespace

void WorkingBlock::forgetAnswers() {
  for (const auto &[line, field] : m_fields)
    dropField(*field);
  m_fields.clear();
}

void WorkingBlock::dropField(BlankField &field) {
  field.hide();
  field.deleteLater(); // its own signal may have led here
}

bool WorkingBlock::matchFields() {
  const std::vector<WorkingLine> lines = ownLines();
  for (const WorkingLine &line : lines)
    if (const Gap *gap = gapOf(line.id); gap && !m_fields.contains(line.id))
      addField(line, *gap);
  bool lostFocus = false;
  std::erase_if(m_fields, [&](const auto &each) {
    const auto hasId = [&](const WorkingLine &line) { return line.id == each.first; };
    if (gapOf(each.first) && std::any_of(lines.begin(), lines.end(), hasId))
      return false;
    lostFocus = lostFocus || each.second->isAncestorOf(QApplication::focusWidget());
    dropField(*each.second);
    return true;
  });
  for (const WorkingLine &line : lines)
    if (const auto field = m_fields.find(line.id); field != m_fields.end())
      field->second->setQuestion(QString::fromStdString(questionText(line, *gapOf(line.id))));
  for (const auto &[line, field] : m_fields) {
    const auto remark = m_remarks.find(line);
    field->setRemark(remark != m_remarks.end() && remark->second.isOfNow ? remark->second.text : QString());
  }
  return lostFocus;
}

bool WorkingBlock::focusField() {
  for (const TypesetLine &line : m_lines)
    if (const auto field = m_fields.find(line.source.id); field != m_fields.end()) {
      field->second->setFocus();
      return true;
    }
  return false;
}

void WorkingBlock::followFocus(QWidget *focused) {
  for (std::size_t i = 0; i < m_placed.lines.size(); ++i)
    if (const auto field = m_fields.find(m_lines[i].source.id);
        field != m_fields.end() && field->second->isAncestorOf(focused))
      setCurrentLine(i);
}

void WorkingBlock::bringIntoView(const std::string &lineId) {
  for (std::size_t i = 0; i < m_placed.lines.size(); ++i)
    if (m_lines[i].source.id == lineId)
      emit reached(m_placed.lines[i].box.toAlignedRect());
}

void WorkingBlock::addField(const WorkingLine &line, const Gap &gap) {
  auto *field = new BlankField(lettersFor(gap), this);
  const QString id = QString::fromStdString(line.id);
  connect(field, &BlankField::answered, this, [this, id](const QString &text) {
    emit answered(id, text);
    bringIntoView(id.toStdString()); // with what is said of the answer
  });
  connect(field, &BlankField::showRequested, this, [this, id] { emit showRequested(id); });
  m_fields[line.id] = field;
}

void WorkingBlock::moveFields() {
  for (std::size_t i = 0; i < m_placed.lines.size(); ++i)
    if (const auto field = m_fields.find(m_lines[i].source.id); field != m_fields.end()) {
      field->second->setGeometry(roomOf(*field->second, m_placed.lines[i].blank, rect().right()));
      field->second->show();
    }
}

} // namespace halfspace
