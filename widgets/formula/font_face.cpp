#include "widgets/formula/font_face.h"

#include <hb-ot.h>

#include <utility>

namespace halfspace::math {
namespace {

/// Collects an outline while HarfBuzz draws it.
struct Pen {
  std::vector<PathStep> steps;
  double unitsPerEm = 1;

  [[nodiscard]] PathStep::Point point(float x, float y) const {
    return {static_cast<double>(x) / unitsPerEm, static_cast<double>(y) / unitsPerEm};
  }
};

Pen &penOf(void *data) { return *static_cast<Pen *>(data); }

void moveTo(hb_draw_funcs_t * /*functions*/, void *data, hb_draw_state_t * /*state*/, float x, float y,
            void * /*user*/) {
  penOf(data).steps.push_back({PathStep::Kind::Move, penOf(data).point(x, y), {}, {}});
}

void lineTo(hb_draw_funcs_t * /*functions*/, void *data, hb_draw_state_t * /*state*/, float x, float y,
            void * /*user*/) {
  penOf(data).steps.push_back({PathStep::Kind::Line, penOf(data).point(x, y), {}, {}});
}

// What a pen is told is HarfBuzz's.
// NOLINTNEXTLINE(readability-function-size)
void quadTo(hb_draw_funcs_t * /*functions*/, void *data, hb_draw_state_t * /*state*/, float ax, float ay,
            float x, float y, void * /*user*/) {
  penOf(data).steps.push_back({PathStep::Kind::Quad, penOf(data).point(ax, ay), penOf(data).point(x, y), {}});
}

// NOLINTNEXTLINE(readability-function-size)
void cubicTo(hb_draw_funcs_t * /*functions*/, void *data, hb_draw_state_t * /*state*/, float ax, float ay,
             float bx, float by, float x, float y, void * /*user*/) {
  const Pen &pen = penOf(data);
  penOf(data).steps.push_back({PathStep::Kind::Cubic, pen.point(ax, ay), pen.point(bx, by), pen.point(x, y)});
}

void closePath(hb_draw_funcs_t * /*functions*/, void *data, hb_draw_state_t * /*state*/, void * /*user*/) {
  penOf(data).steps.push_back({PathStep::Kind::Close, {}, {}, {}});
}

using DrawFunctions = std::unique_ptr<hb_draw_funcs_t, Destroy<hb_draw_funcs_destroy>>;

DrawFunctions makeDrawFunctions() {
  DrawFunctions functions(hb_draw_funcs_create());
  hb_draw_funcs_set_move_to_func(functions.get(), moveTo, nullptr, nullptr);
  hb_draw_funcs_set_line_to_func(functions.get(), lineTo, nullptr, nullptr);
  hb_draw_funcs_set_quadratic_to_func(functions.get(), quadTo, nullptr, nullptr);
  hb_draw_funcs_set_cubic_to_func(functions.get(), cubicTo, nullptr, nullptr);
  hb_draw_funcs_set_close_path_func(functions.get(), closePath, nullptr, nullptr);
  hb_draw_funcs_make_immutable(functions.get());
  return functions;
}

} // namespace

FontFace::FontFace(HbFace face)
    : m_face(std::move(face)), m_font(hb_font_create(m_face.get())), m_buffer(hb_buffer_create()),
      m_unitsPerEm(static_cast<double>(hb_face_get_upem(m_face.get()))),
      m_metrics(hb_face_get_glyph_count(m_face.get())) {}

std::optional<FontFace> FontFace::fromBlob(const HbBlob &blob) {
  if (hb_face_count(blob.get()) == 0)
    return std::nullopt;
  HbFace face(hb_face_create(blob.get(), 0));
  if (hb_face_get_glyph_count(face.get()) == 0)
    return std::nullopt;
  return FontFace(std::move(face));
}

std::optional<FontFace> FontFace::fromMemory(std::span<const std::byte> bytes) {
  return fromBlob(
      HbBlob(hb_blob_create(reinterpret_cast<const char *>(bytes.data()), static_cast<unsigned>(bytes.size()),
                            HB_MEMORY_MODE_READONLY, nullptr, nullptr)));
}

std::optional<FontFace> FontFace::fromFile(const std::string &path) {
  return fromBlob(HbBlob(hb_blob_create_from_file(path.c_str())));
}

GlyphId FontFace::glyph(char32_t character) const {
  const auto [known, isNew] = m_glyphs.try_emplace(character, 0);
  if (isNew)
    hb_font_get_nominal_glyph(m_font.get(), character, &known->second);
  return known->second;
}

const GlyphMetrics &FontFace::metrics(GlyphId glyph) const {
  std::optional<GlyphMetrics> &known = m_metrics[glyph < m_metrics.size() ? glyph : 0];
  if (!known) {
    hb_glyph_extents_t extents{};
    hb_font_get_glyph_extents(m_font.get(), glyph, &extents);
    const auto em = [this](hb_position_t units) { return static_cast<double>(units) / m_unitsPerEm; };
    known = GlyphMetrics{em(hb_font_get_glyph_h_advance(m_font.get(), glyph)), em(extents.y_bearing),
                         -em(extents.y_bearing + extents.height), em(extents.x_bearing), em(extents.width)};
  }
  return *known;
}

ShapedText FontFace::shape(std::string_view text) const {
  hb_buffer_t *buffer = m_buffer.get();
  hb_buffer_clear_contents(buffer);
  const auto size = static_cast<int>(text.size());
  hb_buffer_add_utf8(buffer, text.data(), size, 0, size);
  hb_buffer_guess_segment_properties(buffer);
  hb_buffer_set_direction(buffer, HB_DIRECTION_LTR);
  hb_shape(m_font.get(), buffer, nullptr, 0);
  unsigned count = 0;
  const hb_glyph_info_t *infos = hb_buffer_get_glyph_infos(buffer, &count);
  const hb_glyph_position_t *positions = hb_buffer_get_glyph_positions(buffer, &count);
  ShapedText shaped;
  for (unsigned i = 0; i < count; ++i) {
    shaped.glyphs.push_back({infos[i].codepoint, shaped.width + positions[i].x_offset / m_unitsPerEm,
                             positions[i].y_offset / m_unitsPerEm});
    shaped.width += positions[i].x_advance / m_unitsPerEm;
  }
  return shaped;
}

std::vector<PathStep> FontFace::outline(GlyphId glyph) const {
  static const DrawFunctions functions = makeDrawFunctions();
  Pen pen{{}, m_unitsPerEm};
  hb_font_get_glyph_shape(m_font.get(), glyph, functions.get(), &pen);
  return std::move(pen.steps);
}

} // namespace halfspace::math
