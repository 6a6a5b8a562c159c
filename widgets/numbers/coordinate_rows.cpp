#include "widgets/numbers/coordinate_rows.h"

#include <algorithm>

namespace halfspace {

CoordinateRows::CoordinateRows(SessionModel &model, const Typesetter &typesetter)
    : m_model(model), m_editor(model), m_typesetter(typesetter) {}

const std::vector<std::unique_ptr<CoordinateRow>> &
CoordinateRows::make(const std::vector<CoordinateId> &ids) {
  m_rows.clear();
  for (const CoordinateId &id : ids) {
    const auto &row =
        m_rows.emplace_back(std::make_unique<CoordinateRow>(m_model, m_editor, m_typesetter, id));
    connect(row.get(), &CoordinateRow::typing, this, &CoordinateRows::typing);
    connect(row.get(), &CoordinateRow::refused, this, &CoordinateRows::refused);
  }
  return m_rows;
}

bool CoordinateRows::areMadeFor(const std::vector<CoordinateId> &ids) const {
  return std::equal(ids.begin(), ids.end(), m_rows.begin(), m_rows.end(),
                    [](const CoordinateId &id, const auto &row) { return row->isMadeFor(id); });
}

void CoordinateRows::showNumbers() {
  for (const auto &row : m_rows)
    row->showNumbers();
}

void CoordinateRows::setTheme(const Theme &theme) {
  for (const auto &row : m_rows)
    row->setTheme(theme);
}

std::optional<ChangeObject> CoordinateRows::typed() const {
  for (const auto &row : m_rows)
    if (auto change = row->typed())
      return change;
  return {};
}

QString CoordinateRows::enterTyped() {
  QString refused;
  for (const auto &row : m_rows)
    if (const QString why = row->enterTyped(); refused.isEmpty())
      refused = why;
  return refused;
}

void CoordinateRows::dropTyped() {
  for (const auto &row : m_rows)
    row->dropTyped();
}

NumberField *CoordinateRows::field(const std::string &coordinateName, int axis) const {
  for (const auto &row : m_rows)
    if (row->name() == coordinateName)
      return row->fields().at(static_cast<std::size_t>(axis));
  return nullptr;
}

} // namespace halfspace
