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

/// The receiver of yaml-cpp's events. Anchors are harmless, but what refers to them could grow without bound.
class YamlEvents : public YAML::EventHandler {
public:
  YamlEvents(DocumentBuilder &builder, int firstLine) : m_builder(builder), m_firstLine(firstLine) {}

  void OnDocumentStart(const YAML::Mark &) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark &mark, YAML::anchor_t) override { scalar("", mark); }
  void OnAlias(const YAML::Mark &mark, YAML::anchor_t) override {
    m_builder.refuse(words("References with * are not read. Write the value out."), line(mark));
    throw Stopped{};
  }
  void OnScalar(const YAML::Mark &mark, const std::string &, YAML::anchor_t,
                const std::string &value) override {
    scalar(value, mark);
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
  YamlEvents events(builder, firstLine);
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
