#include "widgets/exports/tikz_writer.h"

#include "widgets/exports/page_number.h"

#include <map>
#include <tuple>

namespace halfspace {
namespace {

/// TeX's points in one of ours.
constexpr double texPoints = 72.27 / 72;
/// What a picture begins with. The colon is that of plain TeX, as formulas are laid out here: amsmath's has
/// other spaces. A label (at, in an ink, on a halo, in a size, with a halo so many points thick, of a
/// formula) is its formula twice: first with thick outlines, which are to have no text, and then itself.
/// Where PDF is not what is written it has a pale box instead.
constexpr const char *pictureStart = R"(\mathchardef\colon="603A
\def\halfspacenode#1#2#3#4#5{\node[anchor=base west,inner sep=0pt,text=#2,font=\fontsize{#3}{#3}\selectfont,#4] at #1 {#5};}
\def\halfspacelabel#1#2#3#4#5#6{\halfspacenode{#1}{#2}{#4}{fill=#3,fill opacity=0.75,text opacity=1}{#6}}
\def\halfspacepdf#1#2#3#4#5#6{%
{\csname pgfsys@invoke\endcsname{/Span<</ActualText<FEFF>>>BDC q 1 j 2 Tr #5 w}\halfspacenode{#1}{#3}{#4}{}{#6}%
\csname pgfsys@invoke\endcsname{Q EMC}}\halfspacenode{#1}{#2}{#4}{}{#6}}
\def\halfspacedriver{pgfsys-pdftex.def}\ifx\pgfsysdriver\halfspacedriver\let\halfspacelabel\halfspacepdf\fi
\def\halfspacedriver{pgfsys-luatex.def}\ifx\pgfsysdriver\halfspacedriver\let\halfspacelabel\halfspacepdf\fi
)";

/// What comments and titles must not hold: a line's end would end them.
std::string inOneLine(std::string text) {
  for (char &c : text)
    if (static_cast<unsigned char>(c) < ' ')
      c = ' ';
  return text;
}

std::string length(double points) { return pageNumber(points) + "bp"; }

std::string coordinates(glm::dvec2 spot) { return "(" + pageNumbers(spot, ",") + ")"; }

std::string pathText(const PagePath &path) {
  std::string text;
  for (const PageStep &step : path.steps)
    switch (step.kind) {
    case PageStep::Kind::Move:
      text += coordinates(step.to);
      break;
    case PageStep::Kind::Line:
      text += "--" + coordinates(step.to);
      break;
    case PageStep::Kind::Curve:
      text += ".. controls " + coordinates(step.first) + " and " + coordinates(step.second) + " .." +
              coordinates(step.to);
      break;
    case PageStep::Kind::Close:
      text += "--cycle";
      break;
    }
  return text;
}

class TikzWriter {
public:
  std::string write(const PathPart &part) {
    std::string options;
    if (part.fill)
      options += "fill=" + nameOf(part.fill->color) + opacityOption("fill opacity", part.fill->opacity) + ",";
    if (part.pen)
      options += penOptions(*part.pen);
    return "\\path[" + options + "]" + pathText(part.path) + ";\n";
  }

  std::string write(const FormulaPart &part) {
    // Named in an order of ours: compilers choose their own among the parts of a sum.
    const std::string halo = nameOf(part.halo);
    const std::string ink = nameOf(part.ink);
    const std::string label = "\\halfspacelabel{" + coordinates(part.start) + "}{" + ink + "}{" + halo +
                              "}{" + pageNumber(part.size * texPoints) + "}{" +
                              pageNumber(2 * haloWidth * part.size) + "}{$" + part.latex + "$}\n";
    if (part.opacity >= 1)
      return label;
    return "\\begin{scope}[opacity=" + pageNumber(part.opacity) + "]\n" + label + "\\end{scope}\n";
  }

  /// The colours that were used, by their names.
  [[nodiscard]] std::string definitions() const {
    std::string text;
    for (const auto &[channels, name] : m_names) {
      const auto &[red, green, blue] = channels;
      text += "\\definecolor{" + name + "}{RGB}{" + std::to_string(red) + "," + std::to_string(green) + "," +
              std::to_string(blue) + "}\n";
    }
    return text;
  }

  std::string nameOf(Color color) {
    const auto [known, isNew] = m_names.try_emplace(std::tuple(color.red, color.green, color.blue));
    if (isNew)
      known->second = "halfspace" + std::to_string(m_names.size());
    return known->second;
  }

private:
  static std::string opacityOption(const char *name, double opacity) {
    return opacity < 1 ? std::string(",") + name + "=" + pageNumber(opacity) : "";
  }

  std::string penOptions(const Pen &pen) {
    std::string options = "draw=" + nameOf(pen.color) + ",line width=" + length(pen.width) +
                          opacityOption("draw opacity", pen.opacity);
    if (pen.cap == Pen::Cap::Round)
      options += ",line cap=round";
    if (!pen.dashes.empty()) {
      options += ",dash pattern=";
      for (std::size_t i = 0; i < pen.dashes.size(); ++i)
        options += (i % 2 == 0 ? "on " : "off ") + length(pen.dashes[i]) + " ";
      options.back() = ',';
      options += "dash phase=" + length(pen.dashStart);
    }
    return options;
  }

  std::map<std::tuple<int, int, int>, std::string> m_names;
};

} // namespace

std::string tikzOf(const Drawing &drawing) {
  TikzWriter writer;
  std::string body;
  const std::string page = "(0,0)rectangle" + coordinates(drawing.size);
  if (drawing.ground)
    body += "\\fill[" + writer.nameOf(*drawing.ground) + "]" + page + ";\n";
  for (const DrawingPart &part : drawing.parts)
    body += std::visit([&](const auto &one) { return writer.write(one); }, part);
  return "% " + inOneLine(drawing.title) + "\n% " + inOneLine(drawing.description) +
         "\n% A document with \\usepackage{amsmath} and \\usepackage{tikz} takes this file in by \\input; "
         "alone it is "
         "a page as large as the figure.\n"
         "\\ifdefined\\tikzpicture\\def\\halfspaceend{}\\else\n"
         "\\documentclass{article}\n"
         "\\IfFileExists{lmodern.sty}{\\usepackage[T1]{fontenc}\\usepackage{lmodern}}{\\usepackage{fix-cm}}\n"
         "\\usepackage{amsmath,tikz}\n"
         "\\usepackage[paperwidth=" +
         length(drawing.size.x) + ",paperheight=" + length(drawing.size.y) +
         ",margin=0bp]{geometry}\n"
         "\\pagestyle{empty}\\parindent=0pt\\topskip=0pt\n"
         "\\begin{document}\\def\\halfspaceend{\\end{document}}\n"
         "\\fi\n" +
         "\\begin{tikzpicture}[x=1bp,y=-1bp,line join=round]\n" + pictureStart + writer.definitions() +
         "\\path[clip]" + page + ";\n" + body + "\\end{tikzpicture}%\n\\halfspaceend\n";
}

} // namespace halfspace
