// PDF files from other hands.
#include "lessons/text.h"
#include "tests/carriers/pictures.h"
#include "widgets/carriers/deflate.h"

namespace halfspace {
namespace {

using test::sentenceOf;

Result<std::string> taken(const std::string &pdf) { return test::carrierCalled("PDF").take(pdf); }

std::string stream(const std::string &entries, const std::string &content) {
  return "9 0 obj\n<<" + entries + ">>\nstream\r\n" + content + "\r\nendstream\nendobj\n";
}

TEST(PdfCarrier, InAnyStream_PackedOrNot_IsFound) {
  const std::string session = test::someSession();
  for (const std::string &content : {session, deflated(session), session.substr(0, session.size() - 1)})
    EXPECT_EQ(sentenceOf(taken("%PDF-1.5\n" + stream("", "q Q") + stream("", content) +
                               stream("", deflated("q Q")) + "no table")),
              "taken: " + session);
}

TEST(PdfCarrier, PutInAnew_TakesThePlaceOfWhatWasThere) {
  const std::string other = replacedAll(test::someSession(), "version\": 4", "version\": 3");
  EXPECT_EQ(sentenceOf(taken("%PDF-1.5\n" + stream("", deflated(test::someSession())) +
                             stream("", deflated(other)))),
            "taken: " + other);
}

TEST(PdfCarrier, WhoseStreamIsDamaged_SaysSo) {
  const std::string damaged = "The scene in this picture is damaged, and cannot be read any more.";
  const std::string packed = deflated(test::someSession());
  const std::string type = "/Subtype/application#2Fx-halfspace+json";
  EXPECT_EQ(sentenceOf(taken("%PDF-1.5\n" + stream(type, "x" + packed))), damaged);
  EXPECT_EQ(sentenceOf(taken("%PDF-1.5\n" + stream("", packed.substr(0, packed.size() - 3)))), damaged);
  EXPECT_EQ(sentenceOf(taken("%PDF-1.5\n" + stream(type, "encrypted") + "trailer\n<</Encrypt 3 0 R>>")),
            "This PDF is encrypted, and its scene cannot be read. Save it without a password first.");
}

TEST(PdfCarrier, OfAFileThatIsNotOurs_LeavesItAsItIs) {
  const Carrier &carrier = test::carrierCalled("PDF");
  for (const std::string pdf : {"%PDF-1.5\n", "%PDF-1.5\ntrailer\n<</Size 3/Root 1 0 R>>\nstartxref\n9\n"})
    EXPECT_EQ(carrier.put(pdf, test::someSession()), pdf);
}

TEST(PdfCarrier, OfVeryManyStreams_IsReadInProportionToTheirNumber) {
  std::string pdf = "%PDF-1.5\n";
  for (int i = 0; i < 200000; ++i)
    pdf += "stream\n";
  EXPECT_EQ(sentenceOf(taken(pdf)), test::foreign);
}

} // namespace
} // namespace halfspace
