// Pictures that other programs have written anew: docs/reliability.md says which of them keep the session.
#include "tests/carriers/pictures.h"
#include "tests/program_test.h"

namespace halfspace {
namespace {

struct Rewriting {
  std::string program;
  std::string arguments; ///< from `in` to `out`
};

class OtherPrograms : public ProgramTest {
protected:
  /// Each program that is installed writes a picture with a session anew, and the session is taken out of
  /// that.
  void expectKept(const Carrier &carrier, const std::vector<Rewriting> &rewritings) const {
    write("in" + carrier.ending, carrier.put(test::pictureOf(carrier), test::someSession()));
    for (const auto &[program, arguments] : rewritings)
      if (has(program)) {
        SCOPED_TRACE(program + " " + arguments);
        std::filesystem::remove(inFolder("out" + carrier.ending));
        const Ran ran = shell(program + " " + arguments + " >.out 2>.err");
        EXPECT_EQ(ran.status, 0) << ran.out << ran.err;
        const std::string out = contentOf(inFolder("out" + carrier.ending));
        EXPECT_EQ(carrierOf(out), &carrier);
        EXPECT_EQ(test::sentenceOf(carrier.take(out)), "taken: " + test::someSession());
      }
  }
};

TEST_F(OtherPrograms, WritingAPngAnew_KeepTheSession) {
  expectKept(test::carrierCalled("PNG"),
             {{"optipng", "-quiet -o5 in.png -out out.png"}, {"pngcrush", "-q -brute in.png out.png"}});
}

TEST_F(OtherPrograms, LayingAnSvgOutAnew_KeepTheSession) {
  expectKept(test::carrierCalled("SVG"),
             {{"xmllint", "--format in.svg --output out.svg"}, {"scour", "-i in.svg -o out.svg"}});
}

TEST_F(OtherPrograms, WritingAPdfAnew_KeepTheSession) {
  expectKept(test::carrierCalled("PDF"),
             {{"qpdf", "--object-streams=generate --recompress-flate --compression-level=9 in.pdf out.pdf"},
              {"qpdf", "--linearize in.pdf out.pdf"},
              {"qpdf", "--qdf --stream-data=uncompress in.pdf out.pdf"},
              {"mutool", "clean -gggg -z in.pdf out.pdf"},
              {"gs", "-q -dNOPAUSE -dBATCH -sDEVICE=pdfwrite -sOutputFile=out.pdf in.pdf"}});
}

TEST_F(OtherPrograms, FindAnAttachedFileInThePdf_AndNoFault) {
  if (!has("qpdf") || !has("pdfdetach"))
    GTEST_SKIP() << "qpdf or pdfdetach is not installed";
  const Carrier &carrier = test::carrierCalled("PDF");
  write("in.pdf", carrier.put(test::pictureOf(carrier), test::someSession()));
  const Ran checked = shell("qpdf --check in.pdf >.out 2>.err");
  EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
  EXPECT_EQ(shell("pdfdetach -save 1 -o scene.halfspace in.pdf >.out 2>.err").status, 0);
  EXPECT_EQ(contentOf(inFolder("scene.halfspace")), test::someSession());
}

TEST_F(OtherPrograms, EncryptingThePdf_AreToldOf) {
  if (!has("qpdf"))
    GTEST_SKIP() << "qpdf is not installed";
  const Carrier &carrier = test::carrierCalled("PDF");
  write("in.pdf", carrier.put(test::pictureOf(carrier), test::someSession()));
  EXPECT_EQ(shell("qpdf --encrypt a b 256 -- in.pdf out.pdf >.out 2>.err").status, 0);
  EXPECT_EQ(test::sentenceOf(carrier.take(contentOf(inFolder("out.pdf")))),
            "This PDF is encrypted, and its scene cannot be read. Save it without a password first.");
}

} // namespace
} // namespace halfspace
