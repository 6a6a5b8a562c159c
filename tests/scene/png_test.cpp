#include "widgets/scene/png.h"

#include "tests/scene/pictures.h"

#include <gtest/gtest.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace halfspace {
namespace {

RgbaImage fourPixels() { return {2, 2, {255, 0, 0, 255, 0, 255, 0, 128, 0, 0, 255, 1, 9, 8, 7, 0}}; }

struct Png : testing::Test {
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      ("halfspace_png_" + std::to_string(testing::UnitTest::GetInstance()->random_seed()) +
       testing::UnitTest::GetInstance()->current_test_info()->name());
  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }

  [[nodiscard]] std::size_t fileCount() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
  }
};

TEST_F(Png, HoldsExactlyThePixelsThatWereWritten) {
  ASSERT_FALSE(writePng(fourPixels(), folder / "a.png"));
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName((folder / "a.png").c_str());
  reader->Update();
  const auto *bottomRow = static_cast<const std::uint8_t *>(reader->GetOutput()->GetScalarPointer(0, 0, 0));
  const auto *topRow = static_cast<const std::uint8_t *>(reader->GetOutput()->GetScalarPointer(0, 1, 0));
  const std::vector<std::uint8_t> expected = fourPixels().rgba;
  EXPECT_TRUE(std::equal(topRow, topRow + 8, expected.begin()));
  EXPECT_TRUE(std::equal(bottomRow, bottomRow + 8, expected.begin() + 8));
  EXPECT_EQ(fileCount(), 1U);
}

TEST_F(Png, IntoAMissingFolderIsAProblemThatNamesTheFile) {
  const auto problem = writePng(fourPixels(), folder / "none" / "a.png");
  ASSERT_TRUE(problem);
  EXPECT_FALSE(problem->sentence.empty());
  EXPECT_EQ(problem->file, (folder / "none" / "a.png").string());
}

TEST_F(Png, OntoAFolderLeavesNothingBehind) {
  std::filesystem::create_directory(folder / "a.png");
  std::ofstream(folder / "a.png" / "kept") << "x";
  EXPECT_TRUE(writePng(fourPixels(), folder / "a.png"));
  EXPECT_EQ(fileCount(), 1U);
}

TEST_F(Png, OfNothingIsAProblem) { EXPECT_TRUE(writePng({}, folder / "a.png")); }

} // namespace
} // namespace halfspace
