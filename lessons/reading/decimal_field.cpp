#include "lessons/reading/decimal_field.h"

#include "lessons/reading/typed_number.h"

namespace halfspace {

double readDecimal(const DocumentNode &node, const std::string &field, FieldReader &fields) {
  const auto value = readCoordinate(node.text);
  if (value)
    return toDouble(*value);
  fields.complain(node, field, value.problem().sentence);
  return 0;
}

} // namespace halfspace
