#include "widgets/animation/animation_format.h"

#include <QFileInfo>

#include <algorithm>

namespace halfspace {

const AnimationFormat *animationFormatOf(const std::string &file) {
  const std::string ending = "." + QFileInfo(QString::fromStdString(file)).suffix().toLower().toStdString();
  const auto &formats = animationFormats();
  const auto found = std::find_if(formats.begin(), formats.end(),
                                  [&](const AnimationFormat &format) { return format.ending == ending; });
  return found == formats.end() ? nullptr : &*found;
}

} // namespace halfspace
