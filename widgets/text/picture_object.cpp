#include "widgets/text/picture_object.h"

#include "lessons/files/picture_bytes.h"
#include "lessons/lesson/lesson_picture.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QFontInfo>
#include <QImageReader>
#include <QPainter>
#include <QTextBlock>
#include <QTextObjectInterface>
#include <QTextTable>

#include <algorithm>

namespace halfspace {

namespace {

constexpr int objectType = QTextFormat::UserObject + 2;
constexpr int imageProperty = QTextFormat::UserProperty + 3;
constexpr int descriptionProperty = QTextFormat::UserProperty + 4;

constexpr std::string_view pngBegin = "\x89PNG";

/// The type, in pixels, beside which a pixel of a picture is one of the screen's.
constexpr double usualTypeSize = 16;

/// The room beside the margins and the indent of the paragraph at a place of the document; in a table its
/// share.
double lineWidth(const QTextDocument &document, int place) {
  const QTextBlock block = document.findBlock(place);
  if (const QTextTable *table = QTextCursor(block).currentTable())
    return document.textWidth() / table->columns();
  const QTextBlockFormat format = block.blockFormat();
  return document.textWidth() - format.leftMargin() - format.rightMargin() -
         format.indent() * document.indentWidth();
}

/// Draws the pictures of a document.
class PictureObject : public QObject, public QTextObjectInterface {
  Q_OBJECT
  Q_INTERFACES(QTextObjectInterface)
public:
  using QObject::QObject;

  QSizeF intrinsicSize(QTextDocument *document, int place, const QTextFormat &format) override {
    const QSizeF size = QSizeF(imageIn(format).size()) *
                        (QFontInfo(format.toCharFormat().font()).pixelSize() / usualTypeSize);
    const bool asLongAsTheyLike = document->textWidth() < 0;
    const double room = asLongAsTheyLike ? size.width() : std::max(1.0, lineWidth(*document, place));
    return size.width() > room ? size * (room / size.width()) : size;
  }

  void drawObject(QPainter *painter, const QRectF &rect, QTextDocument *, int,
                  const QTextFormat &format) override {
    painter->setRenderHint(QPainter::SmoothPixmapTransform);
    painter->drawImage(rect, imageIn(format));
  }

private:
  [[nodiscard]] static QImage imageIn(const QTextFormat &format) {
    return format.property(imageProperty).value<QImage>();
  }
};

Problem noRoom() {
  return {words("The pictures before it have so many pixels that there is no room for it: at most {limit} "
                "million are shown together on a page.",
                {{"limit", std::to_string(mostPixelsOfPage >> 20)}}),
          "", 0, ""};
}

Problem notShown(const std::string &name, const Problem &why) {
  return {words("The picture “{name}” cannot be shown. {reason}",
                {{"name", shortened(name)}, {"reason", why.sentence}}),
          "", 0, ""};
}

} // namespace

std::optional<Problem> whyNoMorePictures(int pixelsLeft) {
  return pixelsLeft < leastPixelsTaken ? std::optional(noRoom()) : std::nullopt;
}

Result<QImage> imageOf(const std::string &bytes, int &pixelsLeft) {
  if (const auto problem = whyNoMorePictures(pixelsLeft))
    return *problem;
  pixelsLeft -= leastPixelsTaken;
  const std::string seen = bytes.starts_with(pngBegin) ? seenPartOfPng(bytes) : bytes;
  QByteArray data = QByteArray::fromRawData(seen.data(), static_cast<int>(seen.size()));
  QBuffer buffer(&data);
  QImageReader reader(&buffer);
  reader.setDecideFormatFromContent(true);
  const QByteArray format = reader.format();
  if (format != "png" && format != "jpeg")
    return Problem{words("It is neither a PNG nor a JPEG file."), "", 0, ""};
  const Problem damaged{words("The file is damaged."), "", 0, ""};
  const QSize size = reader.size();
  if (size.isEmpty())
    return damaged;
  if (size.height() > mostPicturePixels / size.width())
    return Problem{words("It has too many pixels: at most {limit} million are shown.",
                         {{"limit", std::to_string(mostPicturePixels >> 20)}}),
                   "", 0, ""};
  if (format == "jpeg" && scansOfJpeg(seen) > mostPictureScans)
    return Problem{words("It goes over its pixels too often: at most {limit} scans are shown.",
                         {{"limit", std::to_string(mostPictureScans)}}),
                   "", 0, ""};
  const int more = std::max(0, size.width() * size.height() - leastPixelsTaken);
  if (more > pixelsLeft)
    return noRoom();
  pixelsLeft -= more;
  const QSize longest(longestPictureSide, longestPictureSide);
  if (size.width() > longest.width() || size.height() > longest.height())
    reader.setScaledSize(size.scaled(longest, Qt::KeepAspectRatio).expandedTo({1, 1}));
  QImage image = reader.read();
  if (image.isNull())
    return damaged;
  return image;
}

Result<QImage> readPicture(const LessonPictures &pictures, const std::string &name) {
  if (const auto problem = whyNoMorePictures(*pictures.pixelsLeft))
    return notShown(name, *problem);
  const auto bytes = readLessonPicture(pictures.folder, name);
  if (!bytes)
    return bytes.problem();
  auto image = imageOf(*bytes, *pictures.pixelsLeft);
  return image ? std::move(image) : notShown(name, image.problem());
}

void enablePictureObjects(QTextDocument &document) {
  document.documentLayout()->registerHandler(objectType, new PictureObject(&document));
}

QTextCharFormat pictureObjectFormat(const QImage &image, const QString &description, QTextCharFormat text) {
  text.setObjectType(objectType);
  text.setProperty(imageProperty, image);
  text.setProperty(descriptionProperty, description);
  return text;
}

bool isPictureObject(const QTextCharFormat &format) { return format.objectType() == objectType; }

QString pictureDescription(const QTextCharFormat &format) {
  return format.stringProperty(descriptionProperty);
}

} // namespace halfspace

#include "picture_object.moc"
