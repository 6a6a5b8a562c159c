// PDF: an attached file, which the document as a whole is made from. It is put in as an update behind the
// file, and found by going through all streams: so it does not matter how the objects around it are kept, in
// which order, and whether the table of their places is right.
#include "lessons/words.h"
#include "widgets/carriers/carrier.h"
#include "widgets/carriers/deflate.h"
#include "widgets/carriers/packed_scene.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace halfspace {
namespace {

constexpr std::string_view sign = "%PDF-";
/// Before it may stand so many bytes of something else.
constexpr std::size_t mostBefore = 1024;

bool isPdf(std::string_view file) { return file.substr(0, mostBefore).find(sign) != std::string_view::npos; }

/// A number behind a word, which is looked for from the end of a text; nothing where none follows it.
std::optional<std::size_t> numberBehind(std::string_view word, std::string_view text) {
  const auto place = text.rfind(word);
  if (place == std::string_view::npos)
    return {};
  text.remove_prefix(place + word.size());
  text.remove_prefix(std::min(text.find_first_not_of(" \r\n"), text.size()));
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} ? std::optional(number) : std::nullopt;
}

/// What must be known of a file to put something behind it.
struct PdfEnd {
  std::size_t table = 0;   ///< where the table of the objects' places begins
  std::size_t size = 0;    ///< one more than the highest number of an object
  std::size_t catalog = 0; ///< the number of the object that all else hangs on
  std::string entries;     ///< of the trailer's dictionary
  std::string catalogEntries;
};

/// Nothing for a file that is not as this program writes them.
std::optional<PdfEnd> endOf(std::string_view file) {
  const auto trailer = file.rfind("trailer\n<<");
  if (trailer == std::string_view::npos)
    return {};
  const std::string_view rest = file.substr(trailer);
  const auto table = numberBehind("startxref", rest);
  const auto size = numberBehind("/Size", rest);
  const auto catalog = numberBehind("/Root", rest);
  if (!table || !size || !catalog)
    return {};
  const std::string head = "\n" + std::to_string(*catalog) + " 0 obj\n<<";
  const auto object = file.rfind(head);
  const auto objectEnd = file.find(">>\nendobj", object);
  const auto end = rest.find(">>\nstartxref");
  if (object == std::string_view::npos || objectEnd == std::string_view::npos ||
      end == std::string_view::npos)
    return {};
  const auto begin = object + head.size();
  const auto first = rest.find("<<") + 2;
  return PdfEnd{*table, *size, *catalog, std::string(rest.substr(first, end - first)),
                std::string(file.substr(begin, objectEnd - begin))};
}

std::string reference(std::size_t object) { return std::to_string(object) + " 0 R"; }

/// Objects behind a file, and the table of where they stand.
class PdfUpdate {
public:
  explicit PdfUpdate(std::string file) : m_file(std::move(file)) {}

  void add(std::size_t number, const std::string &content) {
    constexpr std::size_t placeDigits = 10;
    std::string place = std::to_string(m_file.size());
    place.insert(0, placeDigits - std::min(place.size(), placeDigits), '0');
    m_table += std::to_string(number) + " 1\n" + place + " 00000 n \n";
    m_file += std::to_string(number) + " 0 obj\n" + content + "\nendobj\n";
  }
  /// The whole file; `trailer` are the entries of its last dictionary.
  [[nodiscard]] std::string finished(const std::string &trailer) && {
    const std::string place = std::to_string(m_file.size());
    return std::move(m_file) + "xref\n" + m_table + "trailer\n<<" + trailer + ">>\nstartxref\n" + place +
           "\n%%EOF\n";
  }

private:
  std::string m_file;
  std::string m_table;
};

/// The trailer's entries with another number of objects, behind the table that was there before.
std::string updated(const PdfEnd &end, std::size_t size) {
  const std::string old = "/Size " + std::to_string(end.size);
  std::string entries = end.entries;
  if (const auto place = entries.find(old); place != std::string::npos)
    entries.replace(place, old.size(), "/Size " + std::to_string(size));
  return entries + "/Prev " + std::to_string(end.table);
}

std::string putIntoPdf(std::string picture, std::string_view session) {
  const auto end = endOf(picture);
  if (!end)
    return picture;
  const std::size_t attachment = end->size;
  const std::size_t description = end->size + 1;
  const std::string packed = deflated(session);
  const std::string name = "(scene.halfspace)";
  const std::string described = reference(description);
  PdfUpdate update(std::move(picture));
  update.add(end->catalog, "<<" + end->catalogEntries + "/Names<</EmbeddedFiles<</Names[" + name + " " +
                               described + "]>>>>/AF[" + described + "]>>");
  update.add(attachment, "<</Type/EmbeddedFile/Subtype/application#2Fx-halfspace+json/Params<</Size " +
                             std::to_string(session.size()) + ">>/Filter/FlateDecode/Length " +
                             std::to_string(packed.size()) + ">>\nstream\n" + packed + "\nendstream");
  const std::string stream = reference(attachment);
  update.add(description, "<</Type/Filespec/F" + name + "/UF" + name + "/AFRelationship/Source/EF<</F " +
                              stream + "/UF " + stream + ">>>>");
  return std::move(update).finished(updated(*end, description + 1));
}

/// What stands in a stream that begins here, packed or not, looks like a session at its beginning.
bool beginsWithSession(std::string_view content) {
  // Enough for the first words of a session, also where they are packed. No more is looked at, so that a file
  // full of streams takes no longer than its length.
  constexpr std::size_t packedBytes = 1024;
  constexpr std::size_t bytes = 64;
  return beginsAsSession(content.substr(0, bytes)) ||
         beginsAsSession(inflated(content.substr(0, packedBytes), bytes).content);
}

/// Whether the dictionary before a stream says that a session is in it.
bool isDeclared(std::string_view file, std::size_t stream) {
  constexpr std::size_t mostBytes = 1024;
  const std::size_t begin = stream - std::min(stream, mostBytes);
  const std::string_view before = file.substr(begin, stream - begin);
  const auto object = before.rfind("obj");
  return object != std::string_view::npos &&
         before.substr(object).find("x-halfspace+json") != std::string_view::npos;
}

/// The content of a stream whose word stands at a place; nothing where it is none.
std::optional<std::string_view> streamAt(std::string_view file, std::size_t place) {
  constexpr std::string_view word = "stream";
  constexpr std::string_view end = "end";
  if (file.substr(0, place).ends_with(end))
    return {};
  file.remove_prefix(place + word.size());
  if (file.starts_with('\r'))
    file.remove_prefix(1);
  if (!file.starts_with('\n'))
    return {};
  return file.substr(1);
}

/// A session that is not packed. What ends a stream may have the last line's end for its own.
std::string plainScene(std::string_view content) {
  content = content.substr(0, content.find("endstream"));
  const auto end = content.rfind('}');
  return std::string(content.substr(0, end == std::string_view::npos ? end : end + 1)) + "\n";
}

Problem encryptedScene() {
  return {words("This PDF is encrypted, and its scene cannot be read. Save it without a password first."), "",
          0, ""};
}

Result<std::string> takeFromPdf(std::string_view picture) {
  std::optional<std::string_view> found; // the last: what is put in later takes the place of what was there
  for (auto place = picture.find("stream"); place != std::string_view::npos;
       place = picture.find("stream", place + 1))
    if (const auto content = streamAt(picture, place))
      if (isDeclared(picture, place) || beginsWithSession(*content))
        found = content;
  if (!found)
    return noScene();
  if (beginsAsSession(*found))
    return plainScene(*found);
  auto scene = unpackedScene(*found);
  if (!scene && picture.find("/Encrypt") != std::string_view::npos)
    return encryptedScene();
  return scene;
}

} // namespace

Carrier pdf_carrier() {
  return {"PDF",       ".pdf",
          isPdf,       putIntoPdf,
          takeFromPdf, [] { return words("Included in a document by LaTeX, the figure loses the scene."); }};
}

} // namespace halfspace
