#include "widgets/exports/pdf_file.h"

#include "lessons/text.h"
#include "widgets/carriers/deflate.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace halfspace {
namespace {

constexpr char32_t replacement = 0xFFFD;

/// A number for a content, by which files are told apart (FNV-1a, beginning with a seed).
std::uint64_t numberFor(std::string_view content, std::uint64_t seed) {
  constexpr std::uint64_t prime = 0x100000001b3;
  for (const char c : content)
    seed = (seed ^ static_cast<unsigned char>(c)) * prime;
  return seed;
}

/// The file's own id, which follows from its content.
std::string idOf(std::string_view content) {
  constexpr std::uint64_t firstSeed = 0xcbf29ce484222325;
  constexpr std::uint64_t secondSeed = 0x9ae16a3b2f90404f;
  const std::string id = "<" + hexDigits(numberFor(content, firstSeed), 16) +
                         hexDigits(numberFor(content, secondSeed), 16) + ">";
  return "[" + id + " " + id + "]";
}

/// An entry of the table, of exactly 20 bytes.
std::string tableEntry(std::size_t place) {
  std::string digits = std::to_string(place);
  digits.insert(0, 10 - std::min<std::size_t>(digits.size(), 10), '0');
  return digits + " 00000 n \n";
}

} // namespace

int PdfFile::reserve() {
  m_objects.emplace_back();
  return static_cast<int>(m_objects.size());
}

void PdfFile::put(int number, std::string content) {
  m_objects[static_cast<std::size_t>(number) - 1] = std::move(content);
}

int PdfFile::add(std::string content) {
  m_objects.push_back(std::move(content));
  return static_cast<int>(m_objects.size());
}

int PdfFile::addStream(std::string_view content, const std::string &entries) {
  const std::string packed = deflated(content);
  return add("<</Filter/FlateDecode/Length " + std::to_string(packed.size()) + entries + ">>\nstream\n" +
             packed + "\nendstream");
}

std::string PdfFile::bytes(int catalog, int info) const {
  // Four bytes that are no ASCII tell those who send files on that this is none of text.
  std::string file = "%PDF-1.7\n%\xE2\xE3\xCF\xD3\n";
  std::string table = "0000000000 65535 f \n";
  for (std::size_t i = 0; i < m_objects.size(); ++i) {
    table += tableEntry(file.size());
    file += std::to_string(i + 1) + " 0 obj\n" + m_objects[i] + "\nendobj\n";
  }
  const std::string id = idOf(file);
  const std::string place = std::to_string(file.size());
  const std::string size = std::to_string(m_objects.size() + 1);
  return file + "xref\n0 " + size + "\n" + table + "trailer\n<</Size " + size + "/Root " +
         pdfReference(catalog) + "/Info " + pdfReference(info) + "/ID" + id + ">>\nstartxref\n" + place +
         "\n%%EOF\n";
}

std::string pdfReference(int object) { return std::to_string(object) + " 0 R"; }

std::string hexDigits(std::uint64_t number, int digits) {
  std::string text(static_cast<std::size_t>(digits), '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, number /= 16)
    *digit = "0123456789ABCDEF"[number % 16];
  return text;
}

std::string utf16Digits(char32_t character) {
  constexpr char32_t firstBeyond = 0x10000;
  if (character < firstBeyond)
    return hexDigits(character, 4);
  const char32_t beyond = character - firstBeyond;
  return hexDigits(0xD800 + beyond / 0x400, 4) + hexDigits(0xDC00 + beyond % 0x400, 4);
}

std::string pdfText(std::string_view text) {
  std::string digits = "FEFF";
  while (!text.empty()) {
    const Character character = firstCharacter(text);
    digits += utf16Digits(character.length > 0 ? character.code : replacement);
    text.remove_prefix(std::max<std::size_t>(character.length, 1));
  }
  return "<" + digits + ">";
}

} // namespace halfspace
