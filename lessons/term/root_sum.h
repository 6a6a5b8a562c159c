// Sums of square roots, which tell exactly whether they are zero.
#pragma once

#include "geometry/surd.h"

#include <optional>
#include <vector>

namespace halfspace {

/// A sum of square roots of whole numbers, each times a fraction: √2/3 − √5 + 1.
///
/// The ratio of two of its roots is never a fraction, so no multiples of them cancel: square roots of whole
/// numbers are linearly independent over the fractions where no two have such a ratio. So it is zero only
/// where no root is left.
class RootSum {
public:
  RootSum() = default; ///< 0
  explicit RootSum(const Surd &value);

  /// Each one fraction or one root, and none of them zero.
  [[nodiscard]] const std::vector<Surd> &summands() const { return m_summands; }

  [[nodiscard]] RootSum operator-() const;
  friend RootSum operator+(const RootSum &a, const RootSum &b);
  friend RootSum operator*(const RootSum &a, const RootSum &b);

  /// The value where one root at most is left beside a fraction.
  [[nodiscard]] std::optional<Surd> surd() const;

private:
  void add(const Surd &summand);

  std::vector<Surd> m_summands;
};

} // namespace halfspace
