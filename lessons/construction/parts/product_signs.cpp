#include "lessons/construction/parts/product_signs.h"

#include <algorithm>

namespace halfspace {

ProductSigns signsOf(std::span<const Rational> products) {
  const bool hasPositive = std::any_of(products.begin(), products.end(), [](const auto &p) { return p > 0; });
  const bool hasNegative = std::any_of(products.begin(), products.end(), [](const auto &p) { return p < 0; });
  if (hasPositive && hasNegative)
    return ProductSigns::Mixed;
  return hasPositive || hasNegative ? ProductSigns::Same : ProductSigns::Zero;
}

Word wordOf(ProductSigns signs) {
  switch (signs) {
  case ProductSigns::Same:
    return {"same", words("the same")};
  case ProductSigns::Mixed:
    return {"mixed", words("mixed")};
  case ProductSigns::Zero:
    break;
  }
  return {"zero", words("zero")};
}

} // namespace halfspace
