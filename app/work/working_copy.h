// The worked lines of the step as text for a document.
#pragma once

#include "app/panels/messages.h"
#include "lessons/construction/line_text.h"

#include <QObject>

namespace halfspace {

class StepWorking;

/// Puts the lines that stand on the page on the clipboard, with their sentences.
class WorkingCopy : public QObject {
  Q_OBJECT
public:
  /// The working must outlive it.
  WorkingCopy(const StepWorking &working, Messages messages, QObject *parent);

  /// Whether lines stand on the page.
  [[nodiscard]] bool canCopy() const;
  /// Without lines it does nothing.
  void copy(DocumentFormat format) const;

private:
  const StepWorking &m_working;
  Messages m_messages;
};

} // namespace halfspace
