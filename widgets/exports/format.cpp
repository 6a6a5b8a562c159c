#include "widgets/exports/format.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace halfspace {

const ExportFormat *formatOfFile(const std::string &file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  for (const ExportFormat &format : exportFormats())
    if (format.ending == ending)
      return &format;
  return nullptr;
}

} // namespace halfspace
