// A mesh on its way from the process that reads it to the one that shows it.
#pragma once

#include "lessons/result.h"
#include "widgets/mesh_files/raw_mesh.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace halfspace {

/// Takes the next bytes of what is sent; false where they cannot go on their way.
using ByteSink = std::function<bool(std::string_view bytes)>;

/// What is sent is this beginning, then any number of parts, then a mesh or a problem, in this machine's
/// order of bytes.
[[nodiscard]] bool sendBeginning(const ByteSink &sink);
[[nodiscard]] bool sendPart(std::optional<double> part, const ByteSink &sink);
[[nodiscard]] bool sendMesh(const RawMesh &mesh, const ByteSink &sink);
[[nodiscard]] bool sendProblem(const Problem &problem, const ByteSink &sink);

/// A longer sentence is cut off.
inline constexpr std::size_t longestSentSentence = 1000;

/// Puts a mesh together again from bytes, however they are cut, and trusts none of them: counts are bounded,
/// and what is not of the form is a problem. The numbers of corners and the coordinates are as they come.
class MeshDecoder {
public:
  /// Nothing after a problem; bytes after a mesh are a problem.
  void feed(std::string_view bytes);
  /// No more bytes come: where the mesh is not whole that is a problem.
  void finish();

  /// The part of the file that is read, as it was last told, from 0 to 1.
  [[nodiscard]] std::optional<double> part() const { return m_part; }
  /// The part of the mesh that has arrived.
  [[nodiscard]] double arrived() const;
  /// Whether the mesh is whole.
  [[nodiscard]] bool isDone() const { return m_state == State::Done; }
  [[nodiscard]] const std::optional<Problem> &problem() const { return m_problem; }
  /// Requires isDone().
  [[nodiscard]] RawMesh take() { return std::move(m_mesh); }

private:
  enum class State { Beginning, Tag, Part, Sentence, SentenceText, Counts, Corners, Triangles, Done, Failed };

  /// How many bytes must have come until the state can be left.
  [[nodiscard]] std::size_t awaited() const;
  void goOn();
  void takeTag();
  void takePart();
  void takeSentenceLength();
  void takeCounts();
  template <class Item> void fill(std::vector<Item> &items, std::size_t count, std::string_view &bytes);
  void fail(std::string sentence);
  void failAsRubbish();

  State m_state = State::Beginning;
  std::string m_pending; ///< of what is not whole yet; short
  std::size_t m_sentenceLength = 0;
  std::size_t m_cornerCount = 0;
  std::size_t m_triangleCount = 0;
  std::size_t m_filled = 0; ///< bytes of the list that is being filled
  std::optional<double> m_part;
  RawMesh m_mesh;
  std::optional<Problem> m_problem;
};

} // namespace halfspace
