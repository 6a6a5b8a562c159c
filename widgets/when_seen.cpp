#include "widgets/when_seen.h"

#include <QEvent>
#include <QWidget>

#include <utility>

namespace halfspace {
namespace {

bool wouldBeSeen(const QWidget &widget) {
  for (const QWidget *each = &widget; each; each = each->isWindow() ? nullptr : each->parentWidget())
    if (each->isHidden() && each->testAttribute(Qt::WA_WState_ExplicitShowHide))
      return false;
  return true;
}

} // namespace

WhenSeen::WhenSeen(QWidget &widget, std::function<void()> make) : m_widget(widget), m_make(std::move(make)) {
  widget.installEventFilter(this);
}

bool WhenSeen::renew() {
  m_isStale = true;
  makeIfSeen();
  return !m_isStale;
}

bool WhenSeen::eventFilter(QObject *watched, QEvent *event) {
  if (event->type() == QEvent::Show || event->type() == QEvent::ShowToParent)
    makeIfSeen();
  return QObject::eventFilter(watched, event);
}

void WhenSeen::makeIfSeen() {
  if (!m_isStale || !wouldBeSeen(m_widget))
    return;
  m_isStale = false;
  m_make();
}

} // namespace halfspace
