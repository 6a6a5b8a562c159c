#include "widgets/mesh_files/mesh_wire.h"

#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

namespace halfspace {
namespace {

constexpr std::string_view beginning = "halfspace mesh 1\n";
constexpr char partTag = 'P';
constexpr char meshTag = 'M';
constexpr char problemTag = 'E';

/// A part that is not known.
constexpr float unknownPart = -1;

using Count = std::uint64_t;
using Counts = std::array<Count, 2>; ///< of corners and of triangles

template <class Value> std::string_view bytesOf(const Value &value) {
  static_assert(std::is_trivially_copyable_v<Value>);
  return {reinterpret_cast<const char *>(&value), sizeof value};
}

template <class Item> std::string_view bytesOf(const std::vector<Item> &items) {
  static_assert(std::is_trivially_copyable_v<Item>);
  return {reinterpret_cast<const char *>(items.data()), items.size() * sizeof(Item)};
}

/// Requires as many bytes.
template <class Value> Value valueOf(std::string_view bytes) {
  static_assert(std::is_trivially_copyable_v<Value>);
  Value value{};
  std::memcpy(&value, bytes.data(), sizeof value);
  return value;
}

bool sendTag(char tag, const ByteSink &sink) { return sink(bytesOf(tag)); }

} // namespace

bool sendBeginning(const ByteSink &sink) { return sink(beginning); }

bool sendPart(std::optional<double> part, const ByteSink &sink) {
  const float told = part ? static_cast<float>(*part) : unknownPart;
  return sendTag(partTag, sink) && sink(bytesOf(told));
}

bool sendMesh(const RawMesh &mesh, const ByteSink &sink) {
  const Counts counts{mesh.corners.size(), mesh.triangles.size()};
  return sendTag(meshTag, sink) && sink(bytesOf(counts)) && sink(bytesOf(mesh.corners)) &&
         sink(bytesOf(mesh.triangles));
}

bool sendProblem(const Problem &problem, const ByteSink &sink) {
  const std::string_view sentence = std::string_view(problem.sentence).substr(0, longestSentSentence);
  const Count length = sentence.size();
  return sendTag(problemTag, sink) && sink(bytesOf(length)) && sink(sentence);
}

std::size_t MeshDecoder::awaited() const {
  switch (m_state) {
  case State::Beginning:
    return beginning.size();
  case State::Tag:
    return sizeof(char);
  case State::Part:
    return sizeof(float);
  case State::Sentence:
    return sizeof(Count);
  case State::SentenceText:
    return m_sentenceLength;
  case State::Counts:
    return sizeof(Counts);
  case State::Corners:
  case State::Triangles:
  case State::Done:
  case State::Failed:
    break;
  }
  return 0;
}

void MeshDecoder::feed(std::string_view bytes) {
  while (!bytes.empty() && m_state != State::Failed) {
    if (m_state == State::Corners) {
      fill(m_mesh.corners, m_cornerCount, bytes);
    } else if (m_state == State::Triangles) {
      fill(m_mesh.triangles, m_triangleCount, bytes);
    } else if (m_state == State::Done) {
      failAsRubbish();
    } else {
      const std::size_t taken = std::min(awaited() - m_pending.size(), bytes.size());
      m_pending += bytes.substr(0, taken);
      bytes.remove_prefix(taken);
      if (m_pending.size() == awaited())
        goOn();
    }
  }
}

void MeshDecoder::finish() {
  if (m_state != State::Done && m_state != State::Failed)
    fail(
        words("Reading the file ended too early. It may be damaged, or need more memory or time than reading "
              "a mesh is allowed."));
}

double MeshDecoder::arrived() const {
  const std::size_t all = m_cornerCount * sizeof(Vec3<float>) + m_triangleCount * sizeof(m_mesh.triangles[0]);
  const std::size_t before = m_state == State::Triangles ? m_cornerCount * sizeof(Vec3<float>) : 0;
  return m_state == State::Done ? 1
         : all == 0             ? 0
                                : static_cast<double>(before + m_filled) / static_cast<double>(all);
}

void MeshDecoder::goOn() {
  switch (m_state) {
  case State::Beginning:
    if (m_pending == beginning)
      m_state = State::Tag;
    else
      failAsRubbish();
    break;
  case State::Tag:
    takeTag();
    break;
  case State::Part:
    takePart();
    break;
  case State::Sentence:
    takeSentenceLength();
    break;
  case State::SentenceText:
    fail(printable(m_pending));
    break;
  case State::Counts:
    takeCounts();
    break;
  case State::Corners:
  case State::Triangles:
  case State::Done:
  case State::Failed:
    break;
  }
  m_pending.clear();
}

void MeshDecoder::takeTag() {
  switch (m_pending.front()) {
  case partTag:
    m_state = State::Part;
    return;
  case problemTag:
    m_state = State::Sentence;
    return;
  case meshTag:
    m_state = State::Counts;
    return;
  default:
    failAsRubbish();
  }
}

void MeshDecoder::takePart() {
  const auto part = valueOf<float>(m_pending);
  m_part = part >= 0 && part <= 1 ? std::optional<double>(part) : std::nullopt; // what is no number is not
  m_state = State::Tag;
}

void MeshDecoder::takeSentenceLength() {
  const auto length = valueOf<Count>(m_pending);
  if (length == 0 || length > longestSentSentence) {
    failAsRubbish();
    return;
  }
  m_sentenceLength = length;
  m_state = State::SentenceText;
}

void MeshDecoder::takeCounts() {
  const auto [corners, triangles] = valueOf<Counts>(m_pending);
  if (corners == 0 || corners > mostMeshCorners || triangles == 0 || triangles > mostMeshTriangles) {
    failAsRubbish();
    return;
  }
  m_cornerCount = corners;
  m_triangleCount = triangles;
  // Within the limits, and the system gives the memory only as it is filled.
  m_mesh.corners.reserve(corners);
  m_mesh.triangles.reserve(triangles);
  m_state = State::Corners;
}

template <class Item>
void MeshDecoder::fill(std::vector<Item> &items, std::size_t count, std::string_view &bytes) {
  const std::size_t taken = std::min(count * sizeof(Item) - m_filled, bytes.size());
  items.resize((m_filled + taken + sizeof(Item) - 1) / sizeof(Item));
  std::memcpy(reinterpret_cast<char *>(items.data()) + m_filled, bytes.data(), taken);
  bytes.remove_prefix(taken);
  m_filled += taken;
  if (m_filled < count * sizeof(Item))
    return;
  m_filled = 0;
  m_state = m_state == State::Corners ? State::Triangles : State::Done;
}

void MeshDecoder::fail(std::string sentence) {
  m_state = State::Failed;
  m_problem = Problem{std::move(sentence), "", 0, ""};
  m_mesh = {};
}

void MeshDecoder::failAsRubbish() {
  fail(words("What came from reading the file is no mesh. The file may be damaged."));
}

} // namespace halfspace
