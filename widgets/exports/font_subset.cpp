#include "widgets/exports/font_subset.h"

#include <hb-subset.h>

#include <array>

namespace halfspace {
namespace {

using math::Destroy;
using SubsetInput = std::unique_ptr<hb_subset_input_t, Destroy<hb_subset_input_destroy>>;
using SubsetPlan = std::unique_ptr<hb_subset_plan_t, Destroy<hb_subset_plan_destroy>>;

constexpr hb_tag_t cffTable = HB_TAG('C', 'F', 'F', ' ');
/// What lays text out and tells of the font: in a file whose text is laid out it is of no use.
constexpr std::array uselessTables{
    HB_TAG('M', 'A', 'T', 'H'), HB_TAG('G', 'S', 'U', 'B'), HB_TAG('G', 'P', 'O', 'S'),
    HB_TAG('G', 'D', 'E', 'F'), HB_TAG('k', 'e', 'r', 'n'), HB_TAG('n', 'a', 'm', 'e'),
    HB_TAG('p', 'o', 's', 't'), HB_TAG('O', 'S', '/', '2'), HB_TAG('c', 'm', 'a', 'p'),
    HB_TAG('F', 'F', 'T', 'M'), HB_TAG('g', 'a', 's', 'p')};

std::string bytesOf(const math::HbBlob &blob) {
  unsigned length = 0;
  const char *bytes = hb_blob_get_data(blob.get(), &length);
  return bytes ? std::string(bytes, length) : std::string();
}

std::string nameOf(const math::FontFace &face) {
  std::array<char, 128> name{};
  auto length = static_cast<unsigned>(name.size());
  hb_ot_name_get_utf8(face.face(), HB_OT_NAME_ID_POSTSCRIPT_NAME, HB_LANGUAGE_INVALID, &length, name.data());
  return length > 0 ? std::string(name.data(), length) : "Font";
}

SubsetInput inputFor(const std::set<math::GlyphId> &glyphs) {
  SubsetInput input(hb_subset_input_create_or_fail());
  if (!input)
    return input;
  for (const math::GlyphId glyph : glyphs)
    hb_set_add(hb_subset_input_glyph_set(input.get()), glyph);
  hb_set_t *useless = hb_subset_input_set(input.get(), HB_SUBSET_SETS_DROP_TABLE_TAG);
  for (const hb_tag_t table : uselessTables)
    hb_set_add(useless, table);
  hb_subset_input_set_flags(input.get(), HB_SUBSET_FLAGS_NO_HINTING);
  return input;
}

} // namespace

std::optional<FontSubset> subsetOf(const math::FontFace &face, const std::set<math::GlyphId> &glyphs) {
  const SubsetInput input = inputFor(glyphs);
  const SubsetPlan plan(input ? hb_subset_plan_create_or_fail(face.face(), input.get()) : nullptr);
  const math::HbFace part(plan ? hb_subset_plan_execute_or_fail(plan.get()) : nullptr);
  if (!part)
    return {};
  FontSubset subset;
  subset.name = nameOf(face);
  subset.program = bytesOf(math::HbBlob(hb_face_reference_table(part.get(), cffTable)));
  if (subset.program.empty()) {
    subset.outlines = FontSubset::Outlines::TrueType;
    subset.program = bytesOf(math::HbBlob(hb_face_reference_blob(part.get())));
  }
  const hb_map_t *numbers = hb_subset_plan_old_to_new_glyph_mapping(plan.get());
  for (const math::GlyphId glyph : glyphs)
    subset.glyphs[glyph] = hb_map_get(numbers, glyph);
  return subset;
}

} // namespace halfspace
