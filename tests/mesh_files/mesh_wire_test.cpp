#include "widgets/mesh_files/mesh_wire.h"

#include "tests/mesh_files/mesh_texts.h"

#include <gtest/gtest.h>

#include <limits>

namespace halfspace {
namespace {

RawMesh smallMesh() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.5F}}, {{0, 1, 2}, {0, 1, 3}, {7, noCorner, 0}}};
}

ByteSink into(std::string &bytes) {
  return [&bytes](std::string_view more) {
    bytes += more;
    return true;
  };
}

std::string beginning() {
  std::string bytes;
  EXPECT_TRUE(sendBeginning(into(bytes)));
  return bytes;
}

std::string sent(const RawMesh &mesh) {
  std::string bytes = beginning();
  EXPECT_TRUE(sendPart(0.5, into(bytes)));
  EXPECT_TRUE(sendMesh(mesh, into(bytes)));
  return bytes;
}

std::string counts(std::uint64_t corners, std::uint64_t triangles) {
  return beginning() + "M" + bytesOf(corners) + bytesOf(triangles);
}

MeshDecoder decoded(std::string_view bytes, std::size_t pieceSize) {
  MeshDecoder decoder;
  for (std::size_t at = 0; at < bytes.size(); at += pieceSize)
    decoder.feed(bytes.substr(at, pieceSize));
  decoder.finish();
  return decoder;
}

void expectProblem(const MeshDecoder &decoder) {
  EXPECT_FALSE(decoder.isDone());
  ASSERT_TRUE(decoder.problem());
  EXPECT_FALSE(decoder.problem()->sentence.empty());
}

TEST(MeshWire, GivesTheSameMeshHoweverItsBytesAreCut) {
  const std::string bytes = sent(smallMesh());
  for (std::size_t piece = 1; piece <= bytes.size(); ++piece) {
    MeshDecoder decoder = decoded(bytes, piece);
    ASSERT_TRUE(decoder.isDone()) << piece;
    EXPECT_FALSE(decoder.problem());
    EXPECT_EQ(decoder.part(), 0.5);
    EXPECT_EQ(decoder.arrived(), 1);
    EXPECT_EQ(decoder.take(), smallMesh());
  }
}

TEST(MeshWire, ThatEndsTooEarlyIsAProblemWhereverItEnds) {
  const std::string bytes = sent(smallMesh());
  for (std::size_t length = 0; length < bytes.size(); ++length)
    expectProblem(decoded(std::string_view(bytes).substr(0, length), bytes.size()));
}

TEST(MeshWire, BytesAfterTheMeshAreAProblem) { expectProblem(decoded(sent(smallMesh()) + "x", 5)); }

TEST(MeshWire, OtherBytesAreAProblemAtOnce) {
  MeshDecoder decoder;
  decoder.feed("Segmentation fault (core dumped)");
  expectProblem(decoder);
  decoder.feed(sent(smallMesh()));
  expectProblem(decoder);
  expectProblem(decoded(beginning() + "X", 1));
}

TEST(MeshWire, CountsBeyondTheLimitsAreAProblemBeforeAnythingFollows) {
  for (const auto &[corners, triangles] : {std::pair<std::uint64_t, std::uint64_t>{mostMeshCorners + 1, 1},
                                           {1, mostMeshTriangles + 1},
                                           {~0ULL, ~0ULL},
                                           {0, 1},
                                           {1, 0}}) {
    MeshDecoder decoder;
    decoder.feed(counts(corners, triangles));
    expectProblem(decoder);
  }
}

TEST(MeshWire, TheLargestCountsAreWaitedFor) {
  MeshDecoder decoder;
  decoder.feed(counts(mostMeshCorners, mostMeshTriangles));
  EXPECT_FALSE(decoder.problem());
  EXPECT_EQ(decoder.arrived(), 0);
  decoder.finish();
  expectProblem(decoder);
}

TEST(MeshWire, PartsThatAreNoPartsAreUnknown) {
  for (const float part :
       {-1.0F, 1.5F, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    MeshDecoder decoder;
    decoder.feed(beginning() + "P" + bytesOf(0.25F));
    EXPECT_EQ(decoder.part(), 0.25);
    decoder.feed("P" + bytesOf(part));
    EXPECT_FALSE(decoder.part());
    EXPECT_FALSE(decoder.problem());
  }
}

TEST(MeshWire, AProblemArrivesAsASentenceThatSteersNoTerminal) {
  std::string bytes = beginning();
  ASSERT_TRUE(sendProblem({"Bad \x1b[2J file", "", 0, ""}, into(bytes)));
  const MeshDecoder decoder = decoded(bytes, 3);
  expectProblem(decoder);
  EXPECT_EQ(decoder.problem()->sentence, "Bad �[2J file");
}

TEST(MeshWire, ALongSentenceIsCutOffAndOneThatClaimsToBeLongerRefused) {
  std::string bytes = beginning();
  ASSERT_TRUE(sendProblem({std::string(5000, 'a'), "", 0, ""}, into(bytes)));
  EXPECT_EQ(decoded(bytes, 100).problem()->sentence, std::string(longestSentSentence, 'a'));
  MeshDecoder decoder;
  decoder.feed(beginning() + "E" + bytesOf(std::uint64_t{longestSentSentence + 1}));
  expectProblem(decoder);
}

TEST(MeshWire, WhereNothingCanBeSentTellsSo) {
  const ByteSink closed = [](std::string_view) { return false; };
  EXPECT_FALSE(sendBeginning(closed));
  EXPECT_FALSE(sendPart({}, closed));
  EXPECT_FALSE(sendMesh(smallMesh(), closed));
  EXPECT_FALSE(sendProblem({"No.", "", 0, ""}, closed));
}

} // namespace
} // namespace halfspace
