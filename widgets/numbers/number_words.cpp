#include "widgets/numbers/number_words.h"

#include "lessons/term/plain_text.h"
#include "lessons/term/spoken.h"

#include <QCoreApplication>

#include <array>

namespace halfspace {
namespace {

/// Longer formulas would fill the screen.
constexpr int longestOrigin = 48;

struct NumberWords {
  Q_DECLARE_TR_FUNCTIONS(halfspace::NumberWords)
};

/// x of n; `name` is that of the whole coordinate.
QString componentOf(const Term &number, const QString &name) {
  static constexpr std::array axes{'x', 'y', 'z'};
  const int axis = number->source->component.value_or(0);
  return NumberWords::tr("%1 of %2", "a coordinate: x of n")
      .arg(QChar(axes.at(static_cast<std::size_t>(axis))))
      .arg(name);
}

QString nameOf(const Term &number, std::string (*write)(const Term &)) {
  return QString::fromStdString(number->origin ? write(*number->origin) : number->source->object);
}

} // namespace

QString nameOfCoordinate(const Term &number) { return componentOf(number, nameOf(number, plainText)); }

QString tipOf(const Term &number) {
  if (number->source)
    return NumberWords::tr("%1: drag sideways to change it, double-click to type.")
        .arg(nameOfCoordinate(number));
  const QString origin = nameOf(number, plainText);
  return origin.size() > longestOrigin
             ? NumberWords::tr("Click to see where this number comes from.")
             : NumberWords::tr("From %1: click to see where it comes from.").arg(origin);
}

QString spokenWithOrigin(const Term &number) {
  const QString value = QString::fromStdString(spoken(number));
  const QString origin = nameOf(number, spoken);
  return number->source ? NumberWords::tr("%1, %2", "spoken: a number, and the coordinate that it is")
                              .arg(value, componentOf(number, origin))
                        : NumberWords::tr("%1, from %2").arg(value, origin);
}

} // namespace halfspace
