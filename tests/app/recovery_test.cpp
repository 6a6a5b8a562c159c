// Unsaved work of programs that live, that were killed, and that ended.
#include "app/work/recovery.h"
#include "lessons/object/kinds/point.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <csignal>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace halfspace {
namespace {

UnsavedWork workAt(int x) {
  UnsavedWork work;
  work.session = {"signed-distance", 2, {{{"Q", PointObject{ExactVec3(x, Rational(-10, 3), 0)}}}}};
  return work;
}

class RecoveryTest : public testing::Test {
protected:
  /// Another program that keeps work and goes on living until it is killed.
  pid_t startProgram(int x) const {
    int ready[2];
    EXPECT_EQ(pipe(ready), 0);
    const pid_t child = fork();
    if (child == 0) {
      Recovery recovery(folder.path());
      static_cast<void>(recovery.keep(workAt(x)));
      static_cast<void>(!write(ready[1], "x", 1));
      for (;;)
        pause();
    }
    char byte = 0;
    EXPECT_EQ(read(ready[0], &byte, 1), 1);
    close(ready[0]);
    close(ready[1]);
    return child;
  }
  static void killProgram(pid_t child) {
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
  }

  QTemporaryDir folder;
};

TEST_F(RecoveryTest, LessonsThatAreBeingWritten_AreKeptWithTheWork) {
  UnsavedWork work = workAt(3);
  const DraftQuestion question{"Where?", "side", {{"positive", "Here"}, {"otherwise", "There"}}, "So."};
  const DraftStep first{"One", "Words: “{f}”\n\n$x$", {"d"}, {"E", "Q"}, question};
  const DraftStep second{"Two", "", {}, {}, {}, DraftTask{"Do it.", "side ="}};
  LessonWorks lessons;
  lessons["explore"] = {{"", "Half", {first, second}}, {}, false};
  lessons["mine"] = {{"", "Mine", {second}}, {"/tmp/mine.md", "---\n", "mine"}, true};
  work.lessons = std::make_shared<const LessonWorks>(lessons);
  {
    Recovery recovery(folder.path());
    ASSERT_FALSE(recovery.keep(work));
    recovery.leave();
  }
  Recovery recovery(folder.path());
  const auto leftovers = recovery.leftovers();
  ASSERT_EQ(leftovers.size(), 1U);
  EXPECT_EQ(*leftovers.front().work.lessons, lessons);
  EXPECT_TRUE(hasUnsaved(lessons));
  lessons.erase("explore");
  EXPECT_FALSE(hasUnsaved(lessons));
}

TEST_F(RecoveryTest, OfAProgramThatLives_IsLeftAlone_AndOfferedOnceItIsKilled) {
  const pid_t child = startProgram(7);
  Recovery recovery(folder.path());
  EXPECT_TRUE(recovery.leftovers().empty());
  killProgram(child);
  const auto leftovers = recovery.leftovers();
  ASSERT_EQ(leftovers.size(), 1U);
  EXPECT_EQ(leftovers.front().work.session, workAt(7).session);
}

TEST_F(RecoveryTest, OfTwoProgramsAtOnce_IsKeptApart) {
  Recovery first(folder.path());
  Recovery second(folder.path());
  EXPECT_FALSE(first.keep(workAt(1)));
  EXPECT_FALSE(second.keep(workAt(2)));
  Recovery third(folder.path());
  EXPECT_TRUE(third.leftovers().empty());
  first.forget();
  EXPECT_TRUE(third.leftovers().empty());
  killProgram(startProgram(3));
  EXPECT_EQ(third.leftovers().size(), 1U);
}

TEST_F(RecoveryTest, Prepared_IsKeptFromAnyThread_UntilNothingIsUnsaved) {
  {
    Recovery recovery(folder.path());
    EXPECT_FALSE(recovery.keep(workAt(1)));
    recovery.prepare(workAt(2));
    std::thread([&] { EXPECT_FALSE(recovery.keepPrepared()); }).join();
  }
  {
    Recovery next(folder.path());
    ASSERT_EQ(next.leftovers().size(), 1U);
    EXPECT_EQ(next.leftovers().front().work.session, workAt(2).session);
    ASSERT_TRUE(next.adopt(next.leftovers().front().path));
    EXPECT_FALSE(next.keepPrepared()); // nothing is prepared: what was taken up stays
  }
  Recovery last(folder.path());
  ASSERT_EQ(last.leftovers().size(), 1U);
  ASSERT_TRUE(last.adopt(last.leftovers().front().path));
  last.prepare(workAt(3));
  last.forget();
  EXPECT_FALSE(last.keepPrepared());
  EXPECT_TRUE(Recovery(folder.path()).leftovers().empty());
}

TEST_F(RecoveryTest, OfAWindowThatIsGone_IsOfferedThoughItsProgramStillLives) {
  Recovery gone(folder.path());
  EXPECT_FALSE(gone.keep(workAt(1)));
  Recovery next(folder.path());
  EXPECT_TRUE(next.leftovers().empty());
  gone.leave();
  EXPECT_EQ(next.leftovers().size(), 1U);
}

TEST_F(RecoveryTest, LookedForByTwoProgramsAtOnce_IsSeenByBoth) {
  constexpr int looks = 300;
  killProgram(startProgram(7));
  const auto missed = [this] {
    const Recovery recovery(folder.path());
    int count = 0;
    for (int i = 0; i < looks; ++i)
      count += recovery.leftovers().empty() ? 1 : 0;
    return count;
  };
  const pid_t other = fork();
  if (other == 0)
    _exit(missed() == 0 ? 0 : 1);
  EXPECT_EQ(missed(), 0);
  int status = -1;
  waitpid(other, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST_F(RecoveryTest, Adopted_BelongsToTheNewProgram_UntilThatForgetsIt) {
  killProgram(startProgram(7));
  Recovery recovery(folder.path());
  const auto leftovers = recovery.leftovers();
  ASSERT_EQ(leftovers.size(), 1U);
  ASSERT_TRUE(recovery.adopt(leftovers.front().path));
  Recovery other(folder.path());
  EXPECT_TRUE(other.leftovers().empty());
  EXPECT_FALSE(other.adopt(leftovers.front().path));
  recovery.forget();
  EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST_F(RecoveryTest, AfterTheFirstChange_LeavesAnotherLeftoverAsItWas) {
  killProgram(startProgram(7));
  {
    Recovery recovery(folder.path());
    EXPECT_FALSE(recovery.keep(workAt(1)));
    recovery.forget();
  }
  const auto leftovers = Recovery(folder.path()).leftovers();
  ASSERT_EQ(leftovers.size(), 1U);
  EXPECT_EQ(leftovers.front().work.session, workAt(7).session);
}

TEST_F(RecoveryTest, KeepsFileViewAndOtherLessons) {
  UnsavedWork work = workAt(4);
  work.file = std::make_shared<KnownFile>(KnownFile{"/somewhere/mine.halfspace", "{}", "signed-distance"});
  work.left["plane-implicit"] = {"plane-implicit", 1, workAt(9).session.scene};
  work.session.view = ChosenView{{{1, 2, 3}, {4, 5, 6}, 7}, true};
  EXPECT_FALSE(Recovery(folder.path()).keep(work));
  const auto leftovers = Recovery(folder.path()).leftovers();
  ASSERT_EQ(leftovers.size(), 1U);
  const UnsavedWork &found = leftovers.front().work;
  EXPECT_EQ(found.session, work.session);
  ASSERT_TRUE(found.file);
  EXPECT_EQ(*found.file, *work.file);
  EXPECT_EQ(found.left, work.left);
  EXPECT_EQ(found.session.view, work.session.view);
}

TEST_F(RecoveryTest, Kept_IsReadByNobodyElse) {
  const mode_t before = umask(0);
  const QString inner = folder.filePath("data/unsaved");
  Recovery recovery(inner);
  EXPECT_FALSE(recovery.keep(workAt(1)));
  umask(before);
  const auto onlyOwner = QFile::ReadOwner | QFile::WriteOwner | QFile::ReadUser | QFile::WriteUser;
  for (const QString &made : {folder.filePath("data"), inner})
    EXPECT_EQ(QFile::permissions(made), onlyOwner | QFile::ExeOwner | QFile::ExeUser) << made.toStdString();
  const auto files = QDir(inner).entryInfoList({"*.json"}, QDir::Files);
  ASSERT_EQ(files.size(), 1);
  EXPECT_EQ(files.front().permissions(), onlyOwner);
}

TEST_F(RecoveryTest, BesideAnUnfinishedFile_RemovesItOnceNobodyCanBeWritingIt) {
  const QString old = folder.filePath(".halfspace-1.part");
  const QString young = folder.filePath(".halfspace-2.part");
  const QString other = folder.filePath("mine.part");
  const QDateTime longAgo = QDateTime::currentDateTime().addDays(-1);
  for (const QString &path : {old, young, other}) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    EXPECT_TRUE(path == young || file.setFileTime(longAgo, QFileDevice::FileModificationTime));
  }
  const Recovery recovery(folder.path());
  EXPECT_FALSE(QFile::exists(old));
  EXPECT_TRUE(QFile::exists(young));
  EXPECT_TRUE(QFile::exists(other));
}

TEST_F(RecoveryTest, OfADamagedFile_IsPassedOver) {
  QFile file(folder.filePath("broken.json"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{\"session\": 3");
  file.close();
  EXPECT_TRUE(Recovery(folder.path()).leftovers().empty());
  EXPECT_TRUE(QFile::exists(folder.filePath("broken.json")));
}

} // namespace
} // namespace halfspace
