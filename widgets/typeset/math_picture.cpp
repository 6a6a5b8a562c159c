#include "widgets/typeset/math_picture.h"

#include "widgets/formula/break_lines.h"
#include "widgets/typeset/paint_formula.h"

namespace halfspace {
MathPicture::MathPicture(math::SetFormula formula, std::shared_ptr<const MathTypeface> typeface)
    : m_typeface(std::move(typeface)),
      m_layout(std::make_shared<const math::Layout>(std::move(formula.layout))),
      m_error(QString::fromStdString(formula.error)), m_errorColumn(static_cast<int>(formula.errorColumn)) {
  takeTagBoxes();
}

MathPicture::MathPicture(std::shared_ptr<const math::Layout> layout,
                         std::shared_ptr<const MathTypeface> typeface)
    : m_typeface(std::move(typeface)), m_layout(std::move(layout)) {
  takeTagBoxes();
}

MathPicture MathPicture::brokenTo(double widthInEm) const {
  MathPicture broken = *this;
  math::LineRules rules;
  rules.width = widthInEm;
  broken.m_layout = std::make_shared<const math::Layout>(math::breakLines(*m_layout, rules));
  broken.takeTagBoxes();
  return broken;
}

void MathPicture::takeTagBoxes() {
  m_markBoxes.clear();
  m_indexBoxes.clear();
  m_leftOut.reset();
  for (const math::TagBox &tagged : m_layout->tagBoxes) {
    const math::TagId &id = m_layout->tags[static_cast<std::size_t>(tagged.tag)].id;
    const QRectF box(tagged.box.x, tagged.box.y, tagged.box.width, tagged.box.height);
    if (const auto *index = std::get_if<std::size_t>(&id))
      m_indexBoxes.emplace_back(*index, box);
    else if (const auto *mark = std::get_if<std::string>(&id))
      m_markBoxes.emplace_back(QString::fromStdString(*mark), box);
    else
      m_leftOut = box;
  }
}

std::vector<QColor> MathPicture::inksOfTags(const InkOf &inkOf, const QColor &plain) const {
  std::vector<QColor> inks;
  inks.reserve(m_layout->tags.size());
  for (const math::Tag &tag : m_layout->tags) {
    if (const auto *mark = std::get_if<std::string>(&tag.id))
      inks.push_back(inkOf(QString::fromStdString(*mark)));
    else // an index has no colour of its own
      inks.push_back(tag.parent == math::noTag ? plain : inks[static_cast<std::size_t>(tag.parent)]);
  }
  return inks;
}

void MathPicture::paint(QPainter &painter, QPointF baseline, double emPixels, const InkOf &inkOf) const {
  const QColor plain = inkOf({});
  const std::vector<QColor> marked = inksOfTags(inkOf, plain);
  const auto colorOf = [&](const math::Ink &ink) {
    if (ink.color)
      return QColor(ink.color->red, ink.color->green, ink.color->blue);
    return ink.tag == math::noTag ? plain : marked[static_cast<std::size_t>(ink.tag)];
  };
  paintFormula(painter, *m_layout, *m_typeface, {baseline, emPixels, 0, colorOf});
}

void MathPicture::paintHalo(QPainter &painter, QPointF baseline, double emPixels, double width,
                            const QColor &color) const {
  paintFormula(painter, *m_layout, *m_typeface,
               {baseline, emPixels, width / emPixels, [&](const math::Ink &) { return color; }});
}

} // namespace halfspace
