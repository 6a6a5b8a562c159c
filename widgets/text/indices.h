// Indices of letters in plain text, which has small forms only for digits: v_d, n_G, P₀_F.
// They are set so large that they can be read where words are small.
#pragma once

#include <QFont>
#include <QString>

#include <vector>

class QLabel;

namespace halfspace {

struct TextRun {
  QString text;
  bool isIndex = false; ///< set smaller and lower
};

/// A plain text without its `_`, in runs.
[[nodiscard]] std::vector<TextRun> runsOf(const QString &plain);
/// The same as rich text, for labels of Qt's own.
[[nodiscard]] QString richTextOf(const QString &plain);
/// Shows a plain text in a label, as rich text only where it has indices: that takes time, which counts in a
/// drag.
void showWords(QLabel &label, const QString &plain);

[[nodiscard]] QFont indexFont(QFont text);
/// How far below the text's baseline that of an index is, in pixels.
[[nodiscard]] double indexDrop(const QFont &text);

} // namespace halfspace
