#include "app/work/progress_file.h"
#include "app/work/put_aside.h"

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
  return {{{"distance", "The side"}, {"negative", "positive", TaskProgress({true, false})}},
          {{"distance", "The foot"}, withTasks({true})},
          {{"ray", 3}, answered("on")}}; // as older files tell it
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

  LessonProgress read() const {
    const auto progress = readProgress(file);
    EXPECT_TRUE(progress) << progress.problem().text();
    return progress ? *progress : LessonProgress();
  }

  QTemporaryDir folder;
  QString file = folder.filePath("data/progress.json");
};

TEST_F(ProgressFile, ThatIsMissing_TellsNothing) {
  const auto progress = readProgress(file);
  ASSERT_TRUE(progress);
  EXPECT_TRUE(progress->empty());
}

TEST_F(ProgressFile, WrittenAndReadAgain_TellsTheSame_AndIsReadByNobodyElse) {
  ASSERT_FALSE(addProgress(someProgress(), file));
  EXPECT_EQ(read(), someProgress());
  EXPECT_FALSE(QFile::permissions(file) & (QFile::ReadGroup | QFile::ReadOther));
}

TEST_F(ProgressFile, ThatAnotherWindowHasWritten_KeepsWhatWasDoneThere) {
  const LessonProgress others{{{"distance", "The side"}, {"on", "on", TaskProgress({false, true})}},
                              {{"plane", "Normals"}, answered("positive")}};
  ASSERT_FALSE(addProgress(others, file));
  ASSERT_FALSE(addProgress(someProgress(), file));
  EXPECT_EQ(read(), merged(someProgress(), others));
}

TEST_F(ProgressFile, ThatIsDamaged_IsAProblem_AndNotWrittenOver) {
  const std::string tooLarge = "[" + std::string(std::size_t{1} << 20U, ' ') + "]";
  for (const std::string &text : {std::string(), std::string("["), std::string("{}"), std::string("3"),
                                  std::string("\xFF"), tooLarge}) {
    write(QByteArray::fromStdString(text));
    EXPECT_FALSE(readProgress(file)) << text.substr(0, 9);
    EXPECT_TRUE(addProgress(someProgress(), file)) << text.substr(0, 9);
    QFile kept(file);
    ASSERT_TRUE(kept.open(QIODevice::ReadOnly));
    EXPECT_EQ(kept.readAll().toStdString(), text) << text.substr(0, 9);
  }
}

TEST_F(ProgressFile, WithWhatIsOfNoKnownForm_PassesOverThat) {
  for (const char *text :
       {"[]", "[3, null, [], {}]", R"([{"lesson":5,"step":0}])", R"([{"lesson":"a","step":null}])"}) {
    write(text);
    EXPECT_TRUE(read().empty()) << text;
    ASSERT_FALSE(addProgress(someProgress(), file));
    EXPECT_EQ(read(), someProgress()) << text;
  }
  write(R"([7, {"lesson":"ray","step":3,"chosen":"on","right":"positive"}])");
  EXPECT_EQ(read(), (LessonProgress{{{"ray", 3}, answered("on")}}));
  write(R"([{"lesson":"ray","step":3,"chosen":4,"tasks":"all"}])");
  EXPECT_EQ(read(), (LessonProgress{{{"ray", 3}, {}}}));
}

TEST_F(ProgressFile, PutAside_KeepsItsContentUnderAnotherName_ThatIsNeverTaken) {
  for (const char *name : {"data/progress-damaged.json", "data/progress-damaged-2.json"}) {
    write(name);
    const auto aside = putAside(file);
    ASSERT_TRUE(aside) << aside.problem().text();
    EXPECT_EQ(*aside, folder.filePath(name));
    EXPECT_FALSE(QFile::exists(file));
  }
  for (const char *name : {"data/progress-damaged.json", "data/progress-damaged-2.json"}) {
    QFile kept(folder.filePath(name));
    ASSERT_TRUE(kept.open(QIODevice::ReadOnly));
    EXPECT_EQ(kept.readAll(), name);
  }
}

TEST_F(ProgressFile, ThatIsNotThere_CannotBePutAside) { EXPECT_FALSE(putAside(file)); }

TEST_F(ProgressFile, ThatCannotBeWritten_IsAProblem) {
  ASSERT_TRUE(QDir().mkpath(file)); // a folder stands in its place
  EXPECT_TRUE(addProgress(someProgress(), file));
}

} // namespace
} // namespace halfspace
