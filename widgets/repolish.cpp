#include "widgets/repolish.h"

#include <QStyle>
#include <QWidget>

namespace halfspace {

void repolish(QWidget &widget) {
  widget.style()->unpolish(&widget);
  widget.style()->polish(&widget);
}

} // namespace halfspace
