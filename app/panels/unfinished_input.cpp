#include "app/panels/unfinished_input.h"

#include "widgets/numbers/coordinate_rows.h"
#include "widgets/view/scene_input.h"
#include "widgets/working/working_editor.h"

namespace halfspace {

UnfinishedInput::UnfinishedInput(SceneInput &scene, StepWorking &working,
                                 const std::vector<CoordinateRows *> &lists, const WorkingEditor &editor,
                                 Messages messages)
    : m_scene(scene), m_working(working), m_lists(lists), m_editor(editor), m_messages(messages) {
  connect(&working.coordinates(), &StepCoordinates::typing, this, &UnfinishedInput::typing);
  for (const CoordinateRows *list : lists)
    connect(list, &CoordinateRows::typing, this, &UnfinishedInput::typing);
}

QString UnfinishedInput::finish() {
  m_scene.finish();
  QString refused = m_working.coordinates().enter();
  for (CoordinateRows *list : m_lists)
    if (const QString other = list->enterTyped(); refused.isEmpty())
      refused = other;
  return refused;
}

bool UnfinishedInput::finishOrAsk() {
  const QString refused = finish();
  if (refused.isEmpty())
    return true;
  if (m_messages.ask(QMessageBox::Question, refused + "\n" + tr("Close this session without the number?"),
                     QMessageBox::Yes | QMessageBox::Cancel, QMessageBox::Cancel) != QMessageBox::Yes)
    return false;
  drop();
  return true;
}

void UnfinishedInput::drop() {
  m_working.coordinates().drop();
  for (CoordinateRows *list : m_lists)
    list->dropTyped();
}

std::optional<ChangeObject> UnfinishedInput::typedChange() const {
  if (m_working.coordinates().typed())
    return m_editor.typedChange();
  for (const CoordinateRows *list : m_lists)
    if (auto typed = list->typed())
      return typed;
  return {};
}

} // namespace halfspace
