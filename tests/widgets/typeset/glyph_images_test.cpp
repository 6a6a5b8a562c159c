// Glyphs of the program's fonts as outlines and as small images.
#include "widgets/typeset/math_typeface.h"
#include "widgets/typeset/paint_formula.h"

#include <QtTest>

#include <cmath>

using namespace halfspace;

namespace {

constexpr int pixel = GlyphLook::partsPerPixel;

double inkOf(const QImage &image) {
  double ink = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      ink += qAlpha(image.pixel(x, y)) / 255.0;
  return ink;
}

/// The middle of the ink, from the pixel of the glyph's origin.
double middleOf(const GlyphImage &glyph) {
  double sum = 0;
  for (int y = 0; y < glyph.image.height(); ++y)
    for (int x = 0; x < glyph.image.width(); ++x)
      sum += (x + 0.5) * qAlpha(glyph.image.pixel(x, y)) / 255.0;
  return glyph.leftTop.x() + sum / inkOf(glyph.image);
}

} // namespace

class GlyphImagesTest : public QObject {
  Q_OBJECT

private:
  const MathTypeface m_typeface;

  [[nodiscard]] math::GlyphId glyph(char32_t character) const {
    return m_typeface.fonts().math.face().glyph(character);
  }
  [[nodiscard]] GlyphLook look(char32_t character, double size = 40) const {
    return {math::FontIndex::Math,
            glyph(character),
            static_cast<int>(size * pixel),
            static_cast<int>(screenWeight * size * pixel),
            0,
            qRgb(0, 0, 0)};
  }
  [[nodiscard]] GlyphImage image(const GlyphLook &look) const { return m_typeface.images().image(look); }

private slots:
  void outlinePointsUpwards_inEm() {
    const QRectF letter = m_typeface.outlines().outline(math::FontIndex::Math, glyph(U'x')).boundingRect();
    QVERIFY(letter.top() < -0.3 && letter.top() > -0.7);
    QVERIFY(std::abs(letter.bottom()) < 0.05);
    const QRectF deep = m_typeface.outlines().outline(math::FontIndex::Math, glyph(U'p')).boundingRect();
    QVERIFY(deep.bottom() > 0.1 && deep.bottom() < 0.4);
  }

  void outlineOfALetterWithACounter_isOpenInside() {
    const QPainterPath &zero = m_typeface.outlines().outline(math::FontIndex::Math, glyph(U'0'));
    const QRectF box = zero.boundingRect();
    QVERIFY(!zero.contains(box.center()));
    QVERIFY(zero.contains(QPointF(box.left() + 0.04, box.center().y())));
  }

  void outlineOfASpace_isEmpty_andItsImageShowsNothing() {
    QVERIFY(m_typeface.outlines().outline(math::FontIndex::Math, glyph(U' ')).isEmpty());
    QVERIFY(image(look(U' ')).image.isNull());
  }

  void outlinesOfBothFonts_areNotMixedUp() {
    // Asked for by turns: the same number means another glyph in each.
    for (math::GlyphId id = 40; id < 60; ++id) {
      const QPainterPath math = m_typeface.outlines().outline(math::FontIndex::Math, id);
      const QPainterPath text = m_typeface.outlines().outline(math::FontIndex::Text, id);
      QVERIFY(math != text || math.isEmpty());
      QCOMPARE(m_typeface.outlines().outline(math::FontIndex::Math, id), math);
    }
  }

  void imageCoversItsOutline_atEverySize_data() {
    QTest::addColumn<double>("size");
    for (const double size : {9.0, 15.5, 24.32, 40.0, 120.0})
      QTest::newRow(qPrintable(QString::number(size))) << size;
  }
  void imageCoversItsOutline_atEverySize() {
    QFETCH(double, size);
    for (const char32_t letter : {U'Q', U'x', U'p', U'8'}) {
      const GlyphImage drawn = image(look(letter, size));
      const QRectF outline =
          QTransform::fromScale(size, size)
              .mapRect(m_typeface.outlines().outline(math::FontIndex::Math, glyph(letter)).boundingRect());
      const QRectF room(drawn.leftTop, drawn.image.size());
      QVERIFY(room.adjusted(-0.05, -0.05, 0.05, 0.05).contains(outline));
      const double more = 3 + 2 * screenWeight * size;
      QVERIFY(room.width() < outline.width() + more && room.height() < outline.height() + more);
      QVERIFY(inkOf(drawn.image) > 0.15 * outline.width() * outline.height());
    }
  }

  void inkHasTheColor_alsoAtEdgesThatAreHalfCovered() {
    GlyphLook red = look(U'Q');
    red.color = qRgb(200, 30, 60);
    const QImage drawn = image(red).image;
    int opaque = 0;
    int edges = 0;
    for (int y = 0; y < drawn.height(); ++y)
      for (int x = 0; x < drawn.width(); ++x) {
        const QRgb texel = drawn.pixelColor(x, y).rgba(); // not premultiplied
        opaque += texel == red.color ? 1 : 0;
        if (qAlpha(texel) > 100 && qAlpha(texel) < 255) {
          ++edges;
          QVERIFY2(std::abs(qRed(texel) - 200) <= 4 && std::abs(qGreen(texel) - 30) <= 4,
                   qPrintable(QColor::fromRgba(texel).name(QColor::HexArgb)));
        }
      }
    QVERIFY(opaque > 50 && edges > 10);
  }

  void thickerStrokes_haveMoreInk() {
    const GlyphLook thin = look(U'x');
    GlyphLook thick = thin;
    thick.thicker = 2 * pixel;
    QVERIFY(inkOf(image(thick).image) > 1.3 * inkOf(image(thin).image));
    QVERIFY(image(thick).leftTop.x() < image(thin).leftTop.x());
  }

  void quartersOfAPixel_moveTheInkByAsMuch() {
    GlyphLook moved = look(U'x');
    const double middle = middleOf(image(moved));
    for (const int quarter : {1, 2, 3}) {
      moved.quarter = quarter;
      const double shift = middleOf(image(moved)) - middle;
      QVERIFY2(std::abs(shift - quarter / 4.0) < 0.03, qPrintable(QString::number(shift)));
    }
  }

  void everyLook_hasItsOwnImage_howeverManyWereAskedForBetween() {
    const QImage first = image(look(U'x')).image;
    double bytes = 0;
    for (int size = 40; size < 128; ++size)
      for (char32_t letter = U'A'; letter <= U'Z'; ++letter)
        bytes += static_cast<double>(image(look(letter, size)).image.sizeInBytes());
    QVERIFY2(bytes > 20e6, qPrintable(QString::number(bytes))); // more than are kept
    QCOMPARE(image(look(U'x')).image, first);
    QVERIFY(image(look(U'y')).image != first);
  }

  void imageLargerThanAllThatIsKept_isGivenNevertheless() {
    const GlyphImage &huge = m_typeface.images().image(look(U'Q', 4000));
    QVERIFY(huge.image.sizeInBytes() > 16 << 20);
    QVERIFY(qAlpha(huge.image.pixel(huge.image.width() / 2, huge.image.height() / 2)) == 0);
  }
};

QTEST_MAIN(GlyphImagesTest)
#include "glyph_images_test.moc"
