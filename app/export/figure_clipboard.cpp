#include "app/export/figure_clipboard.h"

#include "lessons/words.h"

#include <QImage>
#include <QMimeData>

#include <utility>

namespace halfspace {
namespace {

constexpr const char *pngMimeType = "image/png";
constexpr const char *svgMimeType = "image/svg+xml";
constexpr const char *pdfMimeType = "application/pdf";
constexpr const char *latexMimeType = "application/x-tex";

QByteArray toBytes(const std::string &content) { return QByteArray::fromStdString(content); }

/// HTML measures in pixels that are so many to an inch, and those of a picture in so many to a metre.
constexpr double htmlPixelsPerInch = 96;
constexpr double inchesPerMetre = 1 / 0.0254;

/// A piece of a page with the picture in it, as large as on paper.
QString toHtml(const CopiedFigure &figure, const QImage &picture) {
  const double scale = htmlPixelsPerInch * inchesPerMetre / picture.dotsPerMeterX();
  return QString(R"(<img width="%1" height="%2" alt="%3" src="data:%4;base64,%5">)")
      .arg(qRound(picture.width() * scale))
      .arg(qRound(picture.height() * scale))
      .arg(QString::fromStdString(figure.description).toHtmlEscaped(), pngMimeType,
           QString::fromLatin1(toBytes(figure.png).toBase64()));
}

} // namespace

Result<CopiedFigure> copiedFigure(FigureMaker &maker, const FigureSubject &subject, FigureChoices choices) {
  CopiedFigure copied;
  copied.description = subject.description;
  for (const auto &[ending, content] : {std::pair(".png", &CopiedFigure::png),
                                        {".svg", &CopiedFigure::svg},
                                        {".tex", &CopiedFigure::latex}}) {
    choices.format = figureFormatWith(ending);
    auto file = maker.file(subject, choices);
    if (!file)
      return file.problem();
    copied.*content = std::move(file->content);
  }
  copied.session = subject.session;
  return copied;
}

std::unique_ptr<QMimeData> toMimeData(const CopiedFigure &figure) {
  auto data = std::make_unique<QMimeData>();
  data->setData(pngMimeType, toBytes(figure.png));
  const QImage picture = QImage::fromData(toBytes(figure.png));
  data->setImageData(picture);
  data->setHtml(toHtml(figure, picture));
  data->setData(svgMimeType, toBytes(figure.svg));
  data->setData(latexMimeType, toBytes(figure.latex));
  data->setText(QString::fromStdString(figure.latex));
  if (!figure.session.empty())
    data->setData(sessionMimeType, toBytes(figure.session));
  return data;
}

Result<FoundSession> sessionOn(const QMimeData &clipboard) {
  Problem problem{words("There is no scene on the clipboard."), "", 0, ""};
  for (const char *type : {sessionMimeType, pngMimeType, svgMimeType, pdfMimeType}) {
    if (!clipboard.hasFormat(type))
      continue;
    auto found = findSessionIn(clipboard.data(type).toStdString(), "");
    if (found)
      return found;
    problem = found.problem();
  }
  return problem;
}

} // namespace halfspace
