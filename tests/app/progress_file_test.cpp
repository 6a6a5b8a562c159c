#include "app/progress_file.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

namespace halfspace {
namespace {

StepProgress answered(const std::string &chosen) { return {chosen, "positive", {}}; }
StepProgress withTasks(std::vector<bool> done) { return {{}, {}, TaskProgress(std::move(done))}; }

LessonProgress someProgress() {
  return {{{"distance", 0}, {"negative", "positive", TaskProgress({true, false})}},
          {{"distance", 12}, withTasks({true})},
          {{"ray", 3}, answered("on")}};
}

TEST(ProgressAsJson, ReadAgain_IsTheSame) { EXPECT_EQ(progressFrom(toJson(someProgress())), someProgress()); }

class ProgressFile : public testing::Test {
protected:
  void write(const QByteArray &text) const {
    ASSERT_TRUE(QDir().mkpath(folder.filePath("data")));
    QFile written(file);
    ASSERT_TRUE(written.open(QIODevice::WriteOnly));
    written.write(text);
  }

  QTemporaryDir folder;
  QString file = folder.filePath("data/progress.json");
};

TEST_F(ProgressFile, ThatIsMissing_TellsNothing) { EXPECT_TRUE(readProgress(file).empty()); }

TEST_F(ProgressFile, WrittenAndReadAgain_TellsTheSame_AndIsReadByNobodyElse) {
  ASSERT_FALSE(addProgress(someProgress(), file));
  EXPECT_EQ(readProgress(file), someProgress());
  EXPECT_FALSE(QFile::permissions(file) & (QFile::ReadGroup | QFile::ReadOther));
}

TEST_F(ProgressFile, ThatAnotherWindowHasWritten_KeepsWhatWasDoneThere) {
  const LessonProgress others{{{"distance", 0}, {"on", "on", TaskProgress({false, true})}},
                              {{"plane", 0}, answered("positive")}};
  ASSERT_FALSE(addProgress(others, file));
  ASSERT_FALSE(addProgress(someProgress(), file));
  EXPECT_EQ(readProgress(file), merged(someProgress(), others));
}

TEST_F(ProgressFile, ThatIsDamaged_TellsWhatCanBeRead_AndIsWrittenAnew) {
  for (const char *text : {"", "[", "{}", "3", "\xFF", "[3, null, [], {}]", R"([{"lesson":5,"step":0}])",
                           R"([{"lesson":"a","step":"b"}])"}) {
    write(text);
    EXPECT_TRUE(readProgress(file).empty()) << text;
    ASSERT_FALSE(addProgress(someProgress(), file));
    EXPECT_EQ(readProgress(file), someProgress()) << text;
  }
  write(R"([7, {"lesson":"ray","step":3,"chosen":"on","right":"positive"}])");
  EXPECT_EQ(readProgress(file), (LessonProgress{{{"ray", 3}, answered("on")}}));
  write(R"([{"lesson":"ray","step":3,"chosen":4,"tasks":"all"}])");
  EXPECT_EQ(readProgress(file), (LessonProgress{{{"ray", 3}, {}}}));
}

TEST_F(ProgressFile, ThatCannotBeWritten_IsAProblem) {
  ASSERT_TRUE(QDir().mkpath(file)); // a folder stands in its place
  EXPECT_TRUE(addProgress(someProgress(), file));
}

} // namespace
} // namespace halfspace
