#include "widgets/exports/tikz_writer.h"

#include "widgets/exports/page_number.h"

#include <map>
#include <tuple>

namespace halfspace {
namespace {

/// TeX's points in one of ours.
constexpr double texPoints = 72.27 / 72;
/// The halo of a formula: how much is left of what it lies over, and how far it reaches, in em.
constexpr double haloOpacity = 0.75;
constexpr double haloReach = 0.06;

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
    const double reach = haloReach * part.size;
    const glm::dvec2 low = part.start - glm::dvec2(reach, part.formula->ascent * part.size + reach);
    const glm::dvec2 high =
        part.start + glm::dvec2(part.formula->width, part.formula->depth) * part.size + glm::dvec2(reach);
    const std::string size = pageNumber(part.size * texPoints);
    // Named in an order of ours: compilers choose their own among the parts of a sum.
    const std::string halo = nameOf(part.halo);
    const std::string ink = nameOf(part.ink);
    return "\\fill[" + halo + ",opacity=" + pageNumber(haloOpacity * part.opacity) +
           ",rounded corners=" + length(reach) + "]" + coordinates(low) + "rectangle" + coordinates(high) +
           ";\n" + "\\node[anchor=base west,inner sep=0pt,text=" + ink +
           opacityOption("text opacity", part.opacity) + ",font=\\fontsize{" + size + "}{" + size +
           "}\\selectfont] at " + coordinates(part.start) + " {$" + part.latex + "$};\n";
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
         "\\begin{tikzpicture}[x=1bp,y=-1bp,line join=round]\n" + writer.definitions() + "\\path[clip]" +
         page + ";\n" + body + "\\end{tikzpicture}%\n\\halfspaceend\n";
}

} // namespace halfspace
