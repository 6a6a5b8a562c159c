// Pictures as characters of a document.
#pragma once

#include "lessons/reading/problem.h"

#include <QImage>
#include <QTextCharFormat>
#include <QTextDocument>

#include <string>

namespace halfspace {

/// A larger picture would take more memory, once it is unpacked, than a page of words is worth.
inline constexpr int mostPicturePixels = 1 << 24;

/// More are of no use on a page: a wider or higher picture is kept smaller.
inline constexpr int longestPictureSide = 1600;

/// Each goes over all pixels; programs write ten of them.
inline constexpr std::size_t mostPictureScans = 24;

/// The pictures of a piece of words have no more pixels together: four of the largest.
inline constexpr int mostPixelsOfPiece = 4 * mostPicturePixels;

/// The image that the bytes of a PNG or JPEG file hold; else a sentence about what is wrong with them. Its
/// pixels, as they are in the file, are taken off those that are left for the piece of words.
[[nodiscard]] Result<QImage> imageOf(const std::string &bytes, int &pixelsLeft);

/// Lets a document paint pictures.
void enablePictureObjects(QTextDocument &document);

/// The format of the character that is a picture: as large as its pixels in text of the usual size, larger in
/// larger text, and never wider than the lines. It is read out as its description.
[[nodiscard]] QTextCharFormat pictureObjectFormat(const QImage &image, const QString &description,
                                                  QTextCharFormat text);
[[nodiscard]] bool isPictureObject(const QTextCharFormat &format);
[[nodiscard]] QString pictureDescription(const QTextCharFormat &format);

} // namespace halfspace
