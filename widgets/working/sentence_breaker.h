// Sentences on lines of a width.
#pragma once

#include <QFont>
#include <QString>

#include <map>
#include <utility>
#include <vector>

namespace halfspace {

/// Breaks sentences, and remembers how: from one frame to the next most of them stay the same.
class SentenceBreaker {
public:
  struct Run {
    QString text;
    double x = 0; ///< from the line's left
    bool isIndex = false;
  };
  struct Line {
    QString text;
    std::vector<Run> runs; ///< the same text, in pieces of one font
    double ascent = 0;
    double height = 0;
  };

  /// The lines of a sentence in a width, in logical pixels. They stay valid until the next call.
  const std::vector<Line> &lines(const QString &sentence, const QFont &font, double width);

private:
  QFont m_font;
  std::map<std::pair<QString, double>, std::vector<Line>> m_broken; ///< by sentence and width
};

} // namespace halfspace
