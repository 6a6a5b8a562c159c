#include "lessons/scene/file/camera_reader.h"

#include "lessons/reading/decimal_field.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

void readPlace(const DocumentNode &node, const std::string &field, FieldReader &fields, glm::dvec3 &place) {
  if (node.kind != DocumentNode::Kind::List || node.children.size() != 3)
    return fields.complain(node, field, words("Here three numbers are expected, as [1, 2, 3]."));
  for (int i = 0; i < 3; ++i)
    place[i] = readDecimal(node.children[static_cast<std::size_t>(i)], field, fields);
}

} // namespace

void readCameraView(const DocumentNode &node, const std::string &field, FieldReader &fields,
                    CameraView &view) {
  if (const DocumentNode *from = fields.optional("from"))
    readPlace(*from, field + ".from", fields, view.from);
  if (const DocumentNode *at = fields.optional("at"))
    readPlace(*at, field + ".at", fields, view.at);
  if (const DocumentNode *height = fields.optional("height"))
    view.height = readDecimal(*height, field + ".height", fields);
  if (view.from == glm::dvec3(0))
    fields.complain(node, field + ".from",
                    words("The camera cannot look from no direction: give one that is not zero."));
  if (!(view.height > 0))
    fields.complain(node, field + ".height", words("The height of the view must be greater than 0."));
}

} // namespace halfspace
