#include "app/export/export_choices.h"

#include "app/figures/figure_words.h"
#include "widgets/carriers/carrier.h"
#include "widgets/scene/offscreen.h"

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

/// Takes over a number that lies within its limits.
void take(double &value, const QJsonValue &json, double least, double most) {
  const double number = json.toDouble(value);
  if (number >= least && number <= most)
    value = number;
}

template <class Meaning, std::size_t count>
void take(Meaning &value, const QJsonValue &json,
          const std::array<std::pair<const char *, Meaning>, count> &wordList) {
  value = meant(wordList, json.toString().toStdString()).value_or(value);
}

PaperSize paperSizeIn(const QJsonObject &json) {
  PaperSize size;
  take(size.width, json["width"], leastWidth, mostWidth);
  take(size.typeSize, json["typeSize"], leastType, mostType);
  take(size.pixelsPerInch, json["pixelsPerInch"], leastPixelsPerInch, mostPixelsPerInch);
  size.typeSize = std::min(size.typeSize, size.width * mostTypePerWidth);
  return size;
}

QJsonObject toJson(const ShownParts &shown) {
  QJsonObject json;
  for (const auto &[name, part] : shownPartNames)
    json[QString::fromUtf8(name.data(), static_cast<int>(name.size()))] = shown.*part;
  return json;
}

ShownParts shownPartsIn(const QJsonObject &json) {
  ShownParts shown;
  for (const auto &[name, part] : shownPartNames)
    shown.*part = json[QString::fromUtf8(name.data(), static_cast<int>(name.size()))].toBool(shown.*part);
  return shown;
}

} // namespace

const FigureFormat &ExportChoices::format() const { return *figureFormatWith(ending); }

bool ExportChoices::mayTellScene() const { return carriesSession || !carrierWith(ending); }

FigureChoices figureChoicesOf(const ExportChoices &choices, PixelSize screen, double designRatio) {
  FigureChoices figure;
  figure.format = &choices.format();
  if (choices.isOnPaper || figure.format->vectors) {
    figure.size = screen;
    figure.paper = choices.paper;
  } else {
    const double finer = static_cast<double>(choices.pixelsAcross) / screen.width;
    figure.size = {choices.pixelsAcross, std::max(1, static_cast<int>(std::lround(screen.height * finer)))};
    figure.pixelRatio = designRatio * finer;
  }
  figure.isCropped = choices.isCropped;
  figure.theme = *findTheme(choices.theme);
  figure.isTransparent = choices.isTransparent;
  figure.hidden = choices.hidden;
  figure.text = choices.text;
  figure.hasCode = choices.hasCode;
  figure.shown = choices.shown;
  return figure;
}

QJsonObject toJson(const ExportChoices &choices) {
  return {{"ending", QString::fromStdString(choices.ending)},
          {"onPaper", choices.isOnPaper},
          {"width", choices.paper.width},
          {"typeSize", choices.paper.typeSize},
          {"pixelsPerInch", choices.paper.pixelsPerInch},
          {"pixelsAcross", choices.pixelsAcross},
          {"cropped", choices.isCropped},
          {"theme", QString::fromStdString(choices.theme)},
          {"transparent", choices.isTransparent},
          {"hidden", wordFor(hiddenWords, choices.hidden)},
          {"text", wordFor(textWords, choices.text)},
          {"shown", toJson(choices.shown)},
          {"flat", choices.isFlat},
          {"session", choices.carriesSession},
          {"code", choices.hasCode}};
}

ExportChoices exportChoicesIn(const QJsonObject &json) {
  ExportChoices choices;
  if (const FigureFormat *format = figureFormatWith(json["ending"].toString().toStdString()))
    choices.ending = format->ending;
  choices.isOnPaper = json["onPaper"].toBool(choices.isOnPaper);
  choices.paper = paperSizeIn(json);
  double pixelsAcross = choices.pixelsAcross;
  take(pixelsAcross, json["pixelsAcross"], leastPixelsAcross, maxPictureSide);
  choices.pixelsAcross = static_cast<int>(pixelsAcross);
  choices.isCropped = json["cropped"].toBool(choices.isCropped);
  const std::string theme = json["theme"].toString().toStdString();
  if (findTheme(theme))
    choices.theme = theme;
  choices.isTransparent = json["transparent"].toBool(choices.isTransparent);
  take(choices.hidden, json["hidden"], hiddenWords);
  take(choices.text, json["text"], textWords);
  choices.shown = shownPartsIn(json["shown"].toObject());
  choices.isFlat = json["flat"].toBool(choices.isFlat);
  choices.carriesSession = json["session"].toBool(choices.carriesSession);
  choices.hasCode = json["code"].toBool(choices.hasCode);
  return choices;
}

} // namespace halfspace
