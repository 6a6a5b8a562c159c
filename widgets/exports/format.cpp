#include "widgets/exports/format.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace halfspace {

std::string endingOf(const std::string &file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return ending;
}

const ExportFormat *formatOfFile(const std::string &file) {
  const std::string ending = endingOf(file);
  for (const ExportFormat &format : exportFormats())
    if (format.ending == ending)
      return &format;
  return nullptr;
}

} // namespace halfspace
