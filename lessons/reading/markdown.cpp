#include "lessons/reading/markdown.h"

#include "lessons/reading/markdown_entity.h"
#include "lessons/reading/markdown_formulas.h"
#include "lessons/words.h"

#include <md4c.h>

#include <algorithm>
#include <array>
#include <utility>

namespace halfspace {
namespace {

using Kind = MarkdownBlock::Kind;

/// Addresses among the words are links; HTML is text.
constexpr unsigned dialect =
    MD_FLAG_PERMISSIVEAUTOLINKS | MD_FLAG_STRIKETHROUGH | MD_FLAG_TABLES | MD_FLAG_TASKLISTS | MD_FLAG_NOHTML;

std::string textOf(const MD_ATTRIBUTE &attribute) {
  std::string text;
  for (int i = 0; attribute.substr_offsets[i] < attribute.size; ++i) {
    const MD_OFFSET begin = attribute.substr_offsets[i];
    const std::string_view part(attribute.text + begin, attribute.substr_offsets[i + 1] - begin);
    text += attribute.substr_types[i] == MD_TEXT_ENTITY     ? characterOfEntity(part)
            : attribute.substr_types[i] == MD_TEXT_NULLCHAR ? "\uFFFD"
                                                            : std::string(part);
  }
  return text;
}

/// The address of a link; empty where nobody shall be led there, or a formula stands in it.
std::string openableAddress(const MD_ATTRIBUTE &target) {
  std::string address = textOf(target);
  return isOpenable(address) && nextFormula(address).begin == address.size() ? address : std::string();
}

MarkdownBlock::Side sideOf(MD_ALIGN align) {
  return align == MD_ALIGN_CENTER  ? MarkdownBlock::Side::Middle
         : align == MD_ALIGN_RIGHT ? MarkdownBlock::Side::Right
                                   : MarkdownBlock::Side::Left;
}

/// Builds the tree from the parser's events.
class MarkdownBuilder {
public:
  MarkdownBuilder() { m_open.push_back({Kind::Quote}); } // holds all blocks, as a quote does

  /// False where there is too much of something, see `problem`.
  bool enterBlock(MD_BLOCKTYPE type, const void *detail);
  void leaveBlock(MD_BLOCKTYPE type);
  bool enterSpan(MD_SPANTYPE type, const void *detail);
  void leaveSpan(MD_SPANTYPE type);
  void text(MD_TEXTTYPE type, std::string_view text);
  [[nodiscard]] std::vector<MarkdownBlock> finish() { return std::move(m_open.front().children); }
  [[nodiscard]] std::string problem() const;

private:
  void open(MarkdownBlock block) { m_open.push_back(std::move(block)); }
  bool nest(MarkdownBlock block);
  bool openList(char mark, std::optional<unsigned> first);
  bool openItem(const MD_BLOCK_LI_DETAIL &detail);
  void openRow();
  bool openCell(const MD_BLOCK_TD_DETAIL &detail);
  void close();
  void closeBareWords();
  void addLines(std::string_view text);
  void addText(std::string_view text);
  void addSpan(MarkdownSpan span);

  std::vector<MarkdownBlock> m_open; ///< each holds the next
  std::vector<MarkdownSpan::Face> m_faces{{}};
  std::vector<std::optional<unsigned>> m_numbers; ///< of the next item of each open list
  std::vector<MarkdownSpan> m_pictures;           ///< the open ones, whose descriptions are being read
  bool m_inTableHead = false;
  std::size_t m_cells = 0;
  std::size_t m_pictureCount = 0;
};

bool MarkdownBuilder::enterBlock(MD_BLOCKTYPE type, const void *detail) {
  closeBareWords();
  switch (type) {
  case MD_BLOCK_DOC:
    return true;
  case MD_BLOCK_QUOTE:
    return nest({Kind::Quote});
  case MD_BLOCK_UL:
    return openList(static_cast<const MD_BLOCK_UL_DETAIL *>(detail)->mark, {});
  case MD_BLOCK_OL: {
    const auto &list = *static_cast<const MD_BLOCK_OL_DETAIL *>(detail);
    return openList(list.mark_delimiter, list.start);
  }
  case MD_BLOCK_LI:
    return openItem(*static_cast<const MD_BLOCK_LI_DETAIL *>(detail));
  case MD_BLOCK_H:
    open({Kind::Heading, static_cast<int>(static_cast<const MD_BLOCK_H_DETAIL *>(detail)->level)});
    return true;
  case MD_BLOCK_CODE:
    open({Kind::Code});
    return true;
  case MD_BLOCK_HR:
    open({Kind::Rule});
    return true;
  case MD_BLOCK_TABLE:
    open({Kind::Table});
    return true;
  case MD_BLOCK_THEAD:
  case MD_BLOCK_TBODY:
    m_inTableHead = type == MD_BLOCK_THEAD;
    return true;
  case MD_BLOCK_TR:
    openRow();
    return true;
  case MD_BLOCK_TH:
  case MD_BLOCK_TD:
    return openCell(*static_cast<const MD_BLOCK_TD_DETAIL *>(detail));
  default: // HTML is not in our dialect
    open({Kind::Paragraph});
    return true;
  }
}

void MarkdownBuilder::leaveBlock(MD_BLOCKTYPE type) {
  if (type == MD_BLOCK_DOC || type == MD_BLOCK_THEAD || type == MD_BLOCK_TBODY)
    return;
  if (type == MD_BLOCK_LI)
    closeBareWords();
  if (type == MD_BLOCK_UL || type == MD_BLOCK_OL)
    m_numbers.pop_back();
  close();
}

bool MarkdownBuilder::enterSpan(MD_SPANTYPE type, const void *detail) {
  if (type == MD_SPAN_IMG)
    m_pictures.push_back({MarkdownSpan::Kind::Picture,
                          "",
                          0,
                          {},
                          textOf(static_cast<const MD_SPAN_IMG_DETAIL *>(detail)->src)});
  MarkdownSpan::Face face = m_faces.back();
  face.emphasized = face.emphasized || type == MD_SPAN_EM;
  face.strong = face.strong || type == MD_SPAN_STRONG;
  face.struck = face.struck || type == MD_SPAN_DEL;
  face.code = face.code || type == MD_SPAN_CODE;
  if (type == MD_SPAN_A)
    face.link = openableAddress(static_cast<const MD_SPAN_A_DETAIL *>(detail)->href);
  m_faces.push_back(std::move(face));
  m_pictureCount += type == MD_SPAN_IMG ? 1U : 0U;
  return m_pictureCount <= maxMarkdownPictures;
}

void MarkdownBuilder::leaveSpan(MD_SPANTYPE type) {
  m_faces.pop_back();
  if (type != MD_SPAN_IMG)
    return;
  MarkdownSpan picture = std::move(m_pictures.back());
  m_pictures.pop_back();
  addSpan(std::move(picture));
}

void MarkdownBuilder::text(MD_TEXTTYPE type, std::string_view text) {
  if (m_open.back().kind == Kind::Item)
    open({Kind::Paragraph});
  switch (type) {
  case MD_TEXT_BR:
    return addSpan({MarkdownSpan::Kind::LineBreak});
  case MD_TEXT_SOFTBR:
    return addText(" ");
  case MD_TEXT_NULLCHAR:
    return addText("\uFFFD");
  case MD_TEXT_ENTITY:
    return addSpan({MarkdownSpan::Kind::Text, characterOfEntity(text)});
  default:
    return addLines(text);
  }
}

/// Opens a block that holds others.
bool MarkdownBuilder::nest(MarkdownBlock block) {
  open(std::move(block));
  return m_open.size() - 1 <= maxMarkdownDepth;
}

bool MarkdownBuilder::openList(char mark, std::optional<unsigned> first) {
  m_numbers.push_back(first);
  MarkdownBlock list{Kind::List};
  list.mark = mark;
  return nest(std::move(list));
}

bool MarkdownBuilder::openItem(const MD_BLOCK_LI_DETAIL &detail) {
  MarkdownBlock item{Kind::Item};
  item.number = m_numbers.back();
  if (m_numbers.back())
    ++*m_numbers.back();
  if (detail.is_task != 0)
    item.ticked = detail.task_mark != ' ';
  return nest(std::move(item));
}

void MarkdownBuilder::openRow() {
  MarkdownBlock row{Kind::Row};
  row.heading = m_inTableHead;
  open(std::move(row));
}

bool MarkdownBuilder::openCell(const MD_BLOCK_TD_DETAIL &detail) {
  MarkdownBlock cell{Kind::Cell};
  cell.side = sideOf(detail.align);
  open(std::move(cell));
  return ++m_cells <= maxMarkdownCells;
}

std::string MarkdownBuilder::problem() const {
  if (m_pictureCount > maxMarkdownPictures)
    return words("There are too many pictures here: at most {limit} are read.",
                 {{"limit", std::to_string(maxMarkdownPictures)}});
  return m_cells > maxMarkdownCells
             ? words("The tables here are too large: at most {limit} cells are read.",
                     {{"limit", std::to_string(maxMarkdownCells)}})
             : words("Lists and quotes are nested too deeply here: at most {limit} levels are read.",
                     {{"limit", std::to_string(maxMarkdownDepth)}});
}

void MarkdownBuilder::close() {
  MarkdownBlock block = std::move(m_open.back());
  m_open.pop_back();
  // Each line of code has an end; breaks are between lines.
  if (block.kind == Kind::Code && !block.spans.empty() &&
      block.spans.back().kind == MarkdownSpan::Kind::LineBreak)
    block.spans.pop_back();
  m_open.back().children.push_back(std::move(block));
}

/// The words of an item whose list has no empty lines come without events for their paragraph. They end where
/// anything begins, or the item ends.
void MarkdownBuilder::closeBareWords() {
  if (m_open.back().kind == Kind::Paragraph)
    close();
}

void MarkdownBuilder::addLines(std::string_view text) {
  for (auto end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    addText(text.substr(0, end));
    addSpan({MarkdownSpan::Kind::LineBreak});
    text.remove_prefix(end + 1);
  }
  addText(text);
}

void MarkdownBuilder::addText(std::string_view text) {
  while (!text.empty()) {
    const FormulaPlace next = nextFormula(text);
    if (next.begin > 0)
      addSpan({MarkdownSpan::Kind::Text, std::string(text.substr(0, next.begin))});
    if (next.end > next.begin)
      addSpan({MarkdownSpan::Kind::Formula, "", next.formula});
    text.remove_prefix(next.end);
  }
}

void MarkdownBuilder::addSpan(MarkdownSpan span) {
  if (!m_pictures.empty()) { // a description is plain
    m_pictures.back().text += span.kind == MarkdownSpan::Kind::LineBreak ? " " : span.text;
    return;
  }
  span.face = m_faces.back();
  std::vector<MarkdownSpan> &spans = m_open.back().spans;
  const bool goesOn = !spans.empty() && span.kind == MarkdownSpan::Kind::Text &&
                      spans.back().kind == span.kind && spans.back().face == span.face;
  if (goesOn)
    spans.back().text += span.text;
  else
    spans.push_back(std::move(span));
}

MarkdownBuilder &builderOf(void *userData) { return *static_cast<MarkdownBuilder *>(userData); }

/// The parser's callbacks. Only numbers below 0 end it wherever it is, and no exception may go through it, as
/// it is in C.
MD_PARSER parserOfOurDialect() {
  MD_PARSER parser{};
  parser.flags = dialect;
  parser.enter_block = [](MD_BLOCKTYPE type, void *detail, void *userData) noexcept {
    return builderOf(userData).enterBlock(type, detail) ? 0 : -1;
  };
  parser.leave_block = [](MD_BLOCKTYPE type, void *, void *userData) noexcept {
    builderOf(userData).leaveBlock(type);
    return 0;
  };
  parser.enter_span = [](MD_SPANTYPE type, void *detail, void *userData) noexcept {
    return builderOf(userData).enterSpan(type, detail) ? 0 : -1;
  };
  parser.leave_span = [](MD_SPANTYPE type, void *, void *userData) noexcept {
    builderOf(userData).leaveSpan(type);
    return 0;
  };
  parser.text = [](MD_TEXTTYPE type, const MD_CHAR *text, MD_SIZE size, void *userData) noexcept {
    builderOf(userData).text(type, {text, size});
    return 0;
  };
  return parser;
}

} // namespace

std::string writtenIn(const MarkdownFormula &formula) {
  std::string written;
  for (const MarkdownFormula::Side &side : formula.sides) {
    if (!written.empty())
      written += ' ' + formula.relation + ' ';
    written += side.isLive ? '{' + side.text + '}' : side.text;
  }
  return written;
}

bool isOpenable(std::string_view address) {
  constexpr std::array<std::string_view, 3> schemes{"https://", "http://", "mailto:"};
  return std::any_of(schemes.begin(), schemes.end(),
                     [address](std::string_view scheme) { return address.starts_with(scheme); });
}

Result<Markdown> readMarkdown(std::string_view text) {
  if (text.size() > maxMarkdownBytes)
    return Problem{words("These words are too long: at most {limit} KiB are read.",
                         {{"limit", std::to_string(maxMarkdownBytes >> 10U)}}),
                   "", 0, ""};
  MarkdownWithoutFormulas taken = takeFormulas(text);
  MarkdownBuilder builder;
  const MD_PARSER parser = parserOfOurDialect();
  if (md_parse(taken.markdown.data(), static_cast<MD_SIZE>(taken.markdown.size()), &parser, &builder) != 0)
    return Problem{builder.problem(), "", 0, ""};
  return Markdown{builder.finish(), std::move(taken.formulas), std::move(taken.loneDollars)};
}

} // namespace halfspace
