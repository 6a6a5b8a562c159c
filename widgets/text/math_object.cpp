#include "widgets/text/math_object.h"

#include <QAbstractTextDocumentLayout>
#include <QFontMetricsF>
#include <QPainter>
#include <QTextObjectInterface>

#include <algorithm>

Q_DECLARE_METATYPE(halfspace::Typesetter::Picture)

namespace halfspace {

namespace {

constexpr int objectType = QTextFormat::UserObject + 1;
constexpr int pictureProperty = QTextFormat::UserProperty + 1;
constexpr int numberProperty = QTextFormat::UserProperty + 2;

/// Formulas that reach deeper below the baseline (in em) make room for themselves; others hang into the
/// line's own.
constexpr double hangingDepth = 0.33;

/// The size of formulas, in heights of the text's x. Those whose x is as high as the text's (2.26) look too
/// large beside it.
constexpr double inlineSize = 2.1;

/// Draws the formulas of a document.
class MathObject : public QObject, public QTextObjectInterface {
  Q_OBJECT
  Q_INTERFACES(QTextObjectInterface)
public:
  using QObject::QObject;

  /// The room that the formula takes. Qt sets the bottom of a normal object on the baseline, and the middle
  /// of a middle one a quarter of the x-height above it.
  QSizeF intrinsicSize(QTextDocument *, int, const QTextFormat &format) override {
    const Typesetter::Picture picture = pictureOf(format);
    const double x = xHeight(format);
    const double ascent = picture->ascent() * x * inlineSize;
    const double depth = picture->depth() * x * inlineSize;
    const double width = picture->width() * x * inlineSize;
    return hangs(*picture) ? QSizeF(width, ascent)
                           : QSizeF(width, std::max(2 * ascent - x / 2, 2 * depth + x / 2));
  }

  void drawObject(QPainter *painter, const QRectF &rect, QTextDocument *, int,
                  const QTextFormat &format) override {
    const Typesetter::Picture picture = pictureOf(format);
    const double x = xHeight(format);
    const double baseline = hangs(*picture) ? rect.bottom() : rect.center().y() + x / 4;
    picture->paint(*painter, {rect.left(), baseline}, x * inlineSize,
                   [&](const QString &) { return format.foreground().color(); });
  }

  [[nodiscard]] static bool hangs(const MathPicture &picture) { return picture.depth() <= hangingDepth; }

private:
  [[nodiscard]] static Typesetter::Picture pictureOf(const QTextFormat &format) {
    return format.property(pictureProperty).value<Typesetter::Picture>();
  }
  [[nodiscard]] static double xHeight(const QTextFormat &format) {
    return QFontMetricsF(format.toCharFormat().font()).xHeight();
  }
};

} // namespace

void enableMathObjects(QTextDocument &document) {
  document.documentLayout()->registerHandler(objectType, new MathObject(&document));
}

QTextCharFormat mathObjectFormat(const Typesetter::Picture &picture, std::size_t number,
                                 QTextCharFormat text) {
  text.setObjectType(objectType);
  text.setProperty(pictureProperty, QVariant::fromValue(picture));
  text.setProperty(numberProperty, static_cast<int>(number));
  text.setVerticalAlignment(MathObject::hangs(*picture) ? QTextCharFormat::AlignNormal
                                                        : QTextCharFormat::AlignMiddle);
  return text;
}

std::size_t mathObjectNumber(const QTextCharFormat &format) {
  return static_cast<std::size_t>(format.intProperty(numberProperty));
}

} // namespace halfspace

#include "math_object.moc"
