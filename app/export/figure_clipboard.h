// Figures on the clipboard, and scenes that come from there.
#pragma once

#include "app/export/figure_workshop.h"
#include "widgets/carriers/found_session.h"

#include <memory>

class QMimeData;

namespace halfspace {

/// Of a session on the clipboard, as a .halfspace file has it.
inline constexpr const char *sessionMimeType = "application/x-halfspace-session+json";

/// One figure in the forms that programs take.
struct CopiedFigure {
  std::string description; ///< what is to be seen, in a sentence
  std::string png;
  std::string svg;
  std::string latex;     ///< the source of the TikZ picture
  std::string session{}; ///< empty: it carries none
};

/// Fails with a sentence as `FigureMaker` does.
[[nodiscard]] Result<CopiedFigure> copiedFigure(FigureMaker &maker, const FigureSubject &subject,
                                                FigureChoices choices);

/// Never null. Text alone is the LaTeX, for editors; the picture is there as HTML too: word processors take
/// text before pictures, and HTML before text.
[[nodiscard]] std::unique_ptr<QMimeData> toMimeData(const CopiedFigure &figure);

/// The session that lies there by itself or in a picture, from whichever program's hands; a sentence where
/// there is none.
[[nodiscard]] Result<FoundSession> sessionOn(const QMimeData &clipboard);

} // namespace halfspace
