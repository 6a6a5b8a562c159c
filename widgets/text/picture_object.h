// Pictures as characters of a document.
#pragma once

#include "lessons/result.h"
#include "widgets/text/lesson_pictures.h"

#include <QImage>
#include <QTextCharFormat>
#include <QTextDocument>

#include <optional>
#include <string>

namespace halfspace {

/// More are of no use on a page: a wider or higher picture is kept smaller.
inline constexpr int longestPictureSide = 1600;

/// Each goes over all pixels; programs write ten of them.
inline constexpr std::size_t mostPictureScans = 24;

/// Why no more pictures are read for a page that has room for so many pixels; nothing: some are.
[[nodiscard]] std::optional<Problem> whyNoMorePictures(int pixelsLeft);

/// The image that the bytes of a PNG or JPEG file hold; else a sentence about what is wrong with them. What
/// it takes, its pixels as they are in the file, is taken off those that are left for the page.
[[nodiscard]] Result<QImage> imageOf(const std::string &bytes, int &pixelsLeft);

/// The picture of this name; else a sentence that names it and says why it is not shown. Where its page has
/// no more room no file is read.
[[nodiscard]] Result<QImage> readPicture(const LessonPictures &pictures, const std::string &name);

/// Lets a document paint pictures.
void enablePictureObjects(QTextDocument &document);

/// The format of the character that is a picture: as large as its pixels in text of the usual size, larger in
/// larger text, and never wider than the lines. It is read out as its description.
[[nodiscard]] QTextCharFormat pictureObjectFormat(const QImage &image, const QString &description,
                                                  QTextCharFormat text);
[[nodiscard]] bool isPictureObject(const QTextCharFormat &format);
[[nodiscard]] QString pictureDescription(const QTextCharFormat &format);

} // namespace halfspace
