#include "app/work/working_copy.h"

#include "widgets/working/copy_lines.h"
#include "widgets/working/step_working.h"

namespace halfspace {

WorkingCopy::WorkingCopy(const StepWorking &working, Messages messages, QObject *parent)
    : QObject(parent), m_working(working), m_messages(messages) {}

bool WorkingCopy::canCopy() const { return !m_working.toldLines().empty(); }

void WorkingCopy::copy(DocumentFormat format) const {
  if (!canCopy())
    return;
  copyLines(m_working.toldLines(), {}, format);
  m_messages.say(tr("Working copied."));
}

} // namespace halfspace
