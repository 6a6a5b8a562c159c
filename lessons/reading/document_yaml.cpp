#include "lessons/reading/document_builder.h"
#include "lessons/reading/yaml_hint.h"
#include "lessons/words.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <sstream>

namespace halfspace {
namespace {

/// Thrown through yaml-cpp's parser to stop it, and caught below.
struct Stopped {
  std::string slip{}; ///< what reads as YAML, but was hardly meant; empty where it was
};

/// A text in double quotes, where `\n` ends a line. Within a formula it was LaTeX, as `\nu`, and is kept
/// apart from the ends of lines that were written: as what YAML makes of `\L`, the begin of `\Lambda`.
std::string withLatexApart(const std::string &value) {
  constexpr std::string_view lineSeparator = "\u2028";
  std::string text;
  bool inFormula = false;
  char before = '\0';
  for (std::size_t i = 0; i < value.size(); before = value[i++]) {
    if (value[i] == '$' && before != '\\') // the two of $$ cancel out: LaTeX alone has lines of its own
      inFormula = !inFormula;
    if (value.compare(i, 2, "\n\n") == 0)
      inFormula = false; // no formula goes on in another paragraph
    if (value[i] == '\n' && inFormula)
      text += lineSeparator;
    else
      text += value[i];
  }
  return text;
}

/// The receiver of yaml-cpp's events. Anchors are harmless, but what refers to them could grow without bound.
class YamlEvents : public YAML::EventHandler {
public:
  YamlEvents(DocumentBuilder &builder, std::string_view text, int firstLine)
      : m_builder(builder), m_text(text), m_firstLine(firstLine) {}

  void OnDocumentStart(const YAML::Mark &) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark &mark, YAML::anchor_t) override { scalar("", mark); }
  void OnAlias(const YAML::Mark &mark, YAML::anchor_t) override {
    m_builder.refuse(words("References with * are not read. Write the value out."), line(mark));
    throw Stopped{};
  }
  void OnScalar(const YAML::Mark &mark, const std::string &, YAML::anchor_t,
                const std::string &value) override {
    scalar(isInDoubleQuotes(mark) ? withLatexApart(value) : value, mark);
  }
  void OnSequenceStart(const YAML::Mark &mark, const std::string &, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    open(DocumentNode::Kind::List, mark);
  }
  void OnSequenceEnd() override { m_builder.close(); }
  void OnMapStart(const YAML::Mark &mark, const std::string &, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    open(DocumentNode::Kind::Map, mark);
  }
  void OnMapEnd() override { m_builder.close(); }

  [[nodiscard]] int line(const YAML::Mark &mark) const { return m_firstLine + std::max(mark.line, 0); }

private:
  [[nodiscard]] bool isInDoubleQuotes(const YAML::Mark &mark) const {
    return m_text.substr(std::min(static_cast<std::size_t>(std::max(mark.pos, 0)), m_text.size()))
        .starts_with('"');
  }
  void scalar(const std::string &value, const YAML::Mark &mark) {
    const bool goOn = m_builder.expectsKey() ? m_builder.key(value, line(mark))
                                             : m_builder.scalar(DocumentNode::Kind::Text, value, line(mark));
    if (!goOn)
      throw Stopped{};
  }
  void open(DocumentNode::Kind kind, const YAML::Mark &mark) {
    if (m_builder.expectsKey())
      refuseAsName(mark);
    if (m_builder.problem() || !m_builder.open(kind, line(mark)))
      throw Stopped{};
  }

  [[noreturn]] void refuseAsName(const YAML::Mark &mark) {
    m_builder.refuse(words("A list or a map cannot be a name. Names are plain words."), line(mark));
    throw Stopped{"a list or a map as a name"};
  }

  DocumentBuilder &m_builder;
  std::string_view m_text;
  int m_firstLine;
};

/// The problem with what it perhaps comes from. `reason` is the library's.
Problem withHint(Problem problem, std::string_view text, const std::string &reason, int firstLine) {
  const YamlHint hint = yamlHint(text, reason, problem.line - firstLine + 1);
  if (!hint.sentence.empty()) {
    problem.sentence += " " + hint.sentence;
    problem.line = firstLine + hint.line - 1;
  }
  return problem;
}

} // namespace

Result<DocumentNode> parseYaml(std::string_view text, const std::string &file, int firstLine, int maxDepth) {
  DocumentBuilder builder(file, maxDepth);
  YamlEvents events(builder, text, firstLine);
  std::string reason;
  try {
    std::istringstream stream{std::string(text)};
    YAML::Parser parser(stream);
    parser.HandleNextDocument(events);
    if (parser)
      builder.refuse(words("Something stands behind the end here. Remove it."), 0);
  } catch (const Stopped &stopped) {
    reason = stopped.slip;
  } catch (const YAML::Exception &exception) {
    reason = exception.msg;
    builder.refuse(words("This is not YAML as it should be: {reason}.", {{"reason", reason}}),
                   events.line(exception.mark));
  }
  auto root = builder.finish();
  return root || reason.empty() ? std::move(root) : withHint(root.problem(), text, reason, firstLine);
}

} // namespace halfspace
