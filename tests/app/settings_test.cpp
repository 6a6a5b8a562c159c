#include "app/settings.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <sys/stat.h>

namespace halfspace {
namespace {

class SettingsFile : public testing::Test {
protected:
  /// What is read of a file with this text.
  Settings readFrom(const QByteArray &text) const {
    QFile written(file);
    EXPECT_TRUE(written.open(QIODevice::WriteOnly));
    written.write(text);
    written.close();
    const auto settings = readSettings(file);
    EXPECT_TRUE(settings) << text.toStdString();
    if (settings)
      return *settings;
    Settings none;
    none.theme = "not read";
    return none;
  }

  void expectProblem(const std::string &sentence) const {
    const auto settings = readSettings(file);
    ASSERT_FALSE(settings);
    EXPECT_EQ(settings.problem().sentence, sentence);
    EXPECT_EQ(settings.problem().file, file.toStdString());
  }

  QTemporaryDir folder;
  QString file = folder.filePath("config/settings.json");

  void SetUp() override { ASSERT_TRUE(QDir(folder.path()).mkdir("config")); }
};

TEST_F(SettingsFile, WrittenAndReadAgain_TellsTheSame) {
  Settings settings;
  settings.theme = "dark";
  settings.motion = false;
  settings.sizeScale = 1.75;
  settings.window = QByteArray("\0\xFFgeometry", 10);
  settings.snapStep = Rational(1, 4);
  settings.snapping = false;
  settings.ownLessons = QStringList{"/somewhere/über", "/elsewhere"};
  settings.flatPicture = false;
  settings.panels = "panels";
  settings.split = QByteArray("\xFF\0split", 7);
  settings.figure.ending = ".svg";
  settings.figure.isOnPaper = false;
  settings.figure.paper = {200, 8.5, 600};
  settings.figure.pixelsAcross = 1000;
  settings.figure.isCropped = true;
  settings.figure.theme = "dark";
  settings.figure.isTransparent = true;
  settings.figure.hidden = HiddenLines::Paler;
  settings.figure.text = TextAs::Letters;
  settings.figure.shown.grid = false;
  settings.figure.isFlat = true;
  settings.figure.carriesSession = false;
  settings.figure.hasCode = true;
  settings.figureFolder = "/somewhere/figures";
  ASSERT_FALSE(writeSettings(settings, file));
  auto again = readSettings(file);
  ASSERT_TRUE(again) << again.problem().text();
  EXPECT_EQ(*again, settings);
  ASSERT_FALSE(writeSettings(Settings(), file));
  again = readSettings(file);
  ASSERT_TRUE(again);
  EXPECT_EQ(*again, Settings());
}

TEST_F(SettingsFile, InAFolderThatIsMissing_IsWrittenInOneForItsOwner) {
  const QString deeper = folder.filePath("a/b/settings.json");
  ASSERT_FALSE(writeSettings(Settings(), deeper));
  EXPECT_TRUE(readSettings(deeper));
  struct stat made {};
  ASSERT_EQ(stat(folder.filePath("a/b").toStdString().c_str(), &made), 0);
  EXPECT_EQ(made.st_mode & 0777U, 0700U);
}

TEST_F(SettingsFile, ThatIsMissing_GivesTheUsualOnes) {
  const auto settings = readSettings(file);
  ASSERT_TRUE(settings);
  EXPECT_EQ(*settings, Settings());
}

TEST_F(SettingsFile, WithASizeThatIsNoNumber_PassesOverIt) {
  Settings dark;
  dark.theme = "dark";
  for (const char *size : {"null", "\"x\"", "\"2\"", "true", "[2]", "{}"})
    EXPECT_EQ(readFrom(R"({"theme":"dark","sizeScale":)" + QByteArray(size) + "}"), dark) << size;
  EXPECT_EQ(readFrom(R"({"sizeScale":1.5})").sizeScale, 1.5);
}

TEST_F(SettingsFile, WithASizeThatJsonCannotHold_NeverGivesOneThatIsNotFinite) {
  for (const char *size : {"NaN", "1e999", "-1e999", "Infinity"}) {
    QFile written(file);
    ASSERT_TRUE(written.open(QIODevice::WriteOnly));
    written.write(R"({"theme":"dark","sizeScale":)" + QByteArray(size) + "}");
    written.close();
    const auto settings = readSettings(file);
    EXPECT_TRUE(!settings || !settings->sizeScale) << size;
  }
}

TEST_F(SettingsFile, WithASnapStepThatIsNone_KeepsTheUsualOne) {
  for (const char *step : {"0", "\"0\"", "\"-1/2\"", "\"1/0\"", "\"fine\"", "null", "[1]"})
    EXPECT_EQ(readFrom(R"({"snapStep":)" + QByteArray(step) + "}"), Settings()) << step;
  EXPECT_EQ(readFrom(R"({"snapStep":"1/10"})").snapStep, Rational(1, 10));
}

TEST_F(SettingsFile, WithChoicesOfFiguresThatAreNone_KeepsTheUsualOnes) {
  for (const char *choices :
       {R"(7)", R"({"ending": ".doc"})", R"({"ending": ""})", R"({"width": 1e9, "typeSize": "9"})",
        R"({"pixelsPerInch": 0, "pixelsAcross": 1e12})", R"({"pixelsAcross": -5})", R"({"theme": "mauve"})",
        R"({"hidden": "here", "text": 3, "cropped": "no", "session": null})"})
    EXPECT_EQ(readFrom(R"({"figure":)" + QByteArray(choices) + "}"), Settings()) << choices;
  const Settings narrow = readFrom(R"({"figure":{"width":30,"typeSize":72}})"); // no room for such type
  EXPECT_EQ(narrow.figure.paper.width, 30);
  EXPECT_EQ(narrow.figure.paper.typeSize, 3);
}

TEST_F(SettingsFile, OfAnOlderProgram_HasItsOneFolderOfLessons) {
  EXPECT_EQ(readFrom(R"({"ownLessons":"/somewhere"})").ownLessons, QStringList{"/somewhere"});
  for (const char *folders : {R"("")", "[]", "null", "[\"\", 3]"})
    EXPECT_TRUE(readFrom(R"({"ownLessons":)" + QByteArray(folders) + "}").ownLessons.isEmpty()) << folders;
}

TEST_F(SettingsFile, WithOtherFieldsOfTheWrongKind_KeepsTheUsualOnes) {
  EXPECT_EQ(
      readFrom(
          R"({"theme":5,"motion":"no","window":7,"panels":null,"split":3,"flatPicture":"no","unknown":{}})"),
      Settings());
  EXPECT_EQ(readFrom("{}"), Settings());
}

TEST_F(SettingsFile, ThatIsDamaged_IsAProblem) {
  for (const char *text : {"", "{", "[]", "3", "\xFF"}) {
    QFile written(file);
    ASSERT_TRUE(written.open(QIODevice::WriteOnly));
    written.write(text);
    written.close();
    expectProblem("The settings are damaged: the usual ones are in force.");
  }
}

TEST_F(SettingsFile, ThatIsAFolder_IsAProblem) {
  ASSERT_TRUE(QDir().mkdir(file));
  expectProblem("This is a folder, not a file.");
  const auto problem = writeSettings(Settings(), file);
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->sentence, "This cannot be written: it is a folder.");
}

TEST_F(SettingsFile, ThatIsAPipe_IsAProblemAtOnce) {
  ASSERT_EQ(mkfifo(file.toStdString().c_str(), 0600), 0);
  expectProblem("This is a device, a pipe or a socket, not a file.");
  const auto problem = writeSettings(Settings(), file);
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->sentence, "This cannot be written: nobody reads from it.");
}

TEST_F(SettingsFile, BelowAFile_CannotBeWritten) {
  QFile blocking(folder.filePath("blocking"));
  ASSERT_TRUE(blocking.open(QIODevice::WriteOnly));
  EXPECT_TRUE(writeSettings(Settings(), folder.filePath("blocking/settings.json")));
}

} // namespace
} // namespace halfspace
