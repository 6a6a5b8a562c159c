// What there is to typeset: a formula as vectors, or a label as an image.
#pragma once

#include "widgets/scene/label_picture.h"

#include <QHash>
#include <QString>

#include <optional>

namespace halfspace {

struct TypesetOrder {
  QString latex;
  std::optional<LabelStyle> label; ///< what the label looks like; none: a formula
  bool operator==(const TypesetOrder &) const = default;
};

inline auto qHash(const TypesetOrder &order) { return ::qHash(order.latex); }

} // namespace halfspace
