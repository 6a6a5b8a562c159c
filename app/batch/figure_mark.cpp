#include "app/batch/figure_mark.h"

#include "widgets/carriers/png_chunks.h"

#include <QCryptographicHash>
#include <QFile>

#include <algorithm>
#include <array>
#include <optional>

namespace halfspace {
namespace {

constexpr std::string_view chunkType = "tEXt";
constexpr std::string_view keyword = "halfspace-made-of";
/// Of a chunk besides its data: length, type and checksum.
constexpr std::size_t chunkFrame = 12;
constexpr std::size_t digestLength = 64;

/// How a line of a format begins and ends that its readers pass over.
struct Comment {
  std::string_view ending; ///< of files
  std::string_view begin;
  std::string_view end;
};
constexpr std::array comments{Comment{".svg", "<!-- ", " -->\n"}, Comment{".pdf", "% ", "\n"},
                              Comment{".tex", "% ", "\n"}};

const Comment *commentOf(const std::string &ending) {
  const auto *found = std::find_if(comments.begin(), comments.end(),
                                   [&](const Comment &comment) { return comment.ending == ending; });
  return found == comments.end() ? nullptr : found;
}

void add(QCryptographicHash &hash, std::string_view bytes) {
  hash.addData(QByteArray::fromRawData(bytes.data(), static_cast<int>(bytes.size())));
}

/// 64 digits that stand for a figure and for what it was made of.
std::string digestOf(std::string_view content, std::string_view madeOf) {
  QCryptographicHash ofBoth(QCryptographicHash::Sha256);
  QCryptographicHash ofSource(QCryptographicHash::Sha256);
  add(ofSource, madeOf);
  ofBoth.addData(ofSource.result());
  add(ofBoth, content);
  return ofBoth.result().toHex().toStdString();
}

std::string lineOf(const Comment &comment, const std::string &digest) {
  return std::string(comment.begin) + std::string(keyword) + " " + digest + std::string(comment.end);
}

/// A PNG file without its mark, which stands behind its sizes; nothing where it has none.
std::optional<std::string> withoutChunk(std::string_view file) {
  std::string_view rest = file.substr(std::min(file.size(), pngSignature.size()));
  const auto sizes = isPng(file) ? takePngChunk(rest) : std::nullopt;
  const std::size_t begin = file.size() - rest.size();
  const auto mark = sizes ? takePngChunk(rest) : std::nullopt;
  if (!mark || mark->type != chunkType || mark->data.size() != keyword.size() + 1 + digestLength)
    return {};
  return std::string(file.substr(0, begin)) +
         std::string(file.substr(begin + mark->data.size() + chunkFrame));
}

/// What stands before a mark, if there is one; which is not yet looked at.
std::optional<std::string> withoutMark(std::string_view file, const std::string &ending) {
  const Comment *comment = commentOf(ending);
  if (!comment)
    return withoutChunk(file);
  const std::size_t length = lineOf(*comment, std::string(digestLength, '0')).size();
  return file.size() < length ? std::nullopt
                              : std::optional(std::string(file.substr(0, file.size() - length)));
}

} // namespace

std::string marked(std::string content, const std::string &ending, std::string_view madeOf) {
  const std::string digest = digestOf(content, madeOf);
  if (const Comment *comment = commentOf(ending))
    return content + lineOf(*comment, digest);
  return withPngChunk(std::move(content), chunkType, std::string(keyword) + '\0' + digest);
}

bool isMarked(std::string_view file, const std::string &ending, std::string_view madeOf) {
  const auto content = withoutMark(file, ending);
  return content && marked(*content, ending, madeOf) == file;
}

std::string programFingerprint() {
  QFile program("/proc/self/exe");
  QCryptographicHash hash(QCryptographicHash::Sha256);
  return program.open(QIODevice::ReadOnly) && hash.addData(&program) ? hash.result().toHex().toStdString()
                                                                     : "";
}

} // namespace halfspace
