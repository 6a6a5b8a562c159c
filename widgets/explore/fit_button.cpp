#include "widgets/explore/fit_button.h"

#include <QStyleOptionButton>
#include <QStylePainter>

#include <algorithm>

namespace halfspace {
namespace {

/// So many letters tell one title from another.
constexpr int fewestLetters = 16;

} // namespace

FitButton::FitButton(const QString &title) : QPushButton(title) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed); // a button takes no less than its title else
}

QSize FitButton::minimumSizeHint() const {
  const QSize whole = QPushButton::minimumSizeHint();
  return {std::min(whole.width(), fewestLetters * fontMetrics().averageCharWidth()), whole.height()};
}

void FitButton::paintEvent(QPaintEvent *) {
  QStyleOptionButton option;
  initStyleOption(&option);
  const int room = style()->subElementRect(QStyle::SE_PushButtonContents, &option, this).width();
  option.text = fontMetrics().elidedText(text(), Qt::ElideRight, room);
  QStylePainter(this).drawControl(QStyle::CE_PushButton, option);
}

} // namespace halfspace
