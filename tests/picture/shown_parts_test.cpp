// Parts of a picture that are switched on and off: each changes what it is about, and nothing else.
#include "widgets/picture/shown_parts.h"

#include "tests/picture/labels/vectors_only.h"
#include "tests/picture/marks.h"
#include "widgets/picture/composer.h"

#include <gtest/gtest.h>

#include <set>

namespace halfspace {
namespace {

/// A point with a name and coordinates, and an arrow with a name alone.
SceneContent usualContent() {
  PointMark point = withId(pointAt({9, 6, 9}), "Q", Subject::Point);
  point.label = "Q";
  point.coordinates = "{(9,6,9)}";
  ArrowMark normal = withId(ArrowMark{}, "E.n", Subject::Plane);
  normal.from = {6, 8, 4};
  normal.vector = {0, 0, 4};
  normal.label = "n";
  SceneContent content;
  content.figure.add(point);
  content.figure.add(normal);
  return content;
}

struct ShownPartsOfAPicture : testing::Test {
  Composer composer{vectorsOnly()};
  SceneContent content = usualContent();

  void SetUp() override { composer.setView({Camera(CameraView()), {640, 400}, 1}); }
  ShapeList composed() {
    composer.forgetLabels();
    composer.setContent(content);
    return composer.compose();
  }
  /// The layers that are others without a part, or with it.
  std::set<Layer> changedBy(bool ShownParts::*part) {
    const ShapeList before = composed();
    content.shown.*part = !(content.shown.*part);
    const ShapeList after = composed();
    std::set<Layer> changed;
    for (std::size_t i = 0; i < layerCount; ++i)
      if (*after.layers[i] != *before.layers[i])
        changed.insert(static_cast<Layer>(i));
    EXPECT_EQ(after.shadows != before.shadows, part == &ShownParts::shadows);
    return changed;
  }
  /// What is written, by the mark that it is beside; of the axes there is no mark.
  std::multiset<std::pair<std::string, std::string>> written() {
    std::multiset<std::pair<std::string, std::string>> labels;
    forEach<LabelShape>(*composed().layer(Layer::Labels), [&](const Shape &shape, const LabelShape &label) {
      labels.emplace(shape.mark, shape.mark.empty() ? "" : label.latex);
    });
    return labels;
  }
};

TEST_F(ShownPartsOfAPicture, Labels_AreThoseOfMarks) {
  EXPECT_EQ(written().count({"Q", "Q"}), 1U);
  const std::size_t ofAxes = written().count({"", ""});
  EXPECT_GT(ofAxes, 3U);
  EXPECT_EQ(changedBy(&ShownParts::labels), std::set<Layer>{Layer::Labels});
  EXPECT_GE(written().size(), ofAxes) << "no name drives a number away any more";
  EXPECT_EQ(written().count({"", ""}), written().size());
}

TEST_F(ShownPartsOfAPicture, Coordinates_StandBehindTheLettersOfPoints) {
  EXPECT_EQ(changedBy(&ShownParts::coordinates), std::set<Layer>{Layer::Labels});
  EXPECT_EQ(written().count({"Q", "Q{(9,6,9)}"}), 1U);
  EXPECT_EQ(written().count({"E.n", "n"}), 1U);
}

TEST_F(ShownPartsOfAPicture, CoordinatesOfAPointWithoutALetter_AreNotWritten) {
  content.shown.coordinates = true;
  content.figure.marks.change(0, [](Mark &mark) { baseOf(mark).label.clear(); });
  EXPECT_EQ(written().count({"E.n", "n"}) + written().count({"", ""}), written().size());
}

TEST_F(ShownPartsOfAPicture, Axes_AreGoneWithTheirNumbers) {
  EXPECT_EQ(changedBy(&ShownParts::axes), (std::set<Layer>{Layer::Axes, Layer::Labels}));
  EXPECT_TRUE(composed().layer(Layer::Axes)->empty());
  EXPECT_EQ(written().size(), 2U);
}

TEST_F(ShownPartsOfAPicture, Grid_IsTheGround) {
  EXPECT_EQ(changedBy(&ShownParts::grid), std::set<Layer>{Layer::Ground});
  EXPECT_TRUE(composed().layer(Layer::Ground)->empty());
  content.shown.grid = true;
  EXPECT_FALSE(composed().layer(Layer::Ground)->empty()) << "it is back";
}

TEST_F(ShownPartsOfAPicture, Shadows_LieOnTheGroundWithoutAGrid) {
  content.shown.grid = false;
  EXPECT_TRUE(composed().shadows);
  EXPECT_EQ(changedBy(&ShownParts::shadows), std::set<Layer>());
  EXPECT_FALSE(composed().shadows);
  content.shown.shadows = true;
  content.hasShadows = false;
  EXPECT_FALSE(composed().shadows) << "the lesson has none";
}

TEST_F(ShownPartsOfAPicture, DropLines_LeadFromThePointStraightDown) {
  const auto shapesOf = [&](const std::string &mark) {
    const auto &solids = *composed().layer(Layer::Solids);
    return std::count_if(solids.begin(), solids.end(),
                         [&](const Shape &shape) { return shape.mark == mark; });
  };
  EXPECT_EQ(shapesOf("Q/drop"), 0);
  content.shown.dropLines = true;
  EXPECT_EQ(shapesOf("Q/drop"), 1);
  const auto &solids = *composed().layer(Layer::Solids);
  const auto line =
      std::find_if(solids.begin(), solids.end(), [](const Shape &shape) { return shape.mark == "Q/drop"; });
  const auto &path = std::get<LineShape>(line->form).path;
  EXPECT_EQ(path.front(), Place(9, 6, 9));
  EXPECT_EQ(path.back(), Place(9, 6, 0));
}

TEST_F(ShownPartsOfAPicture, DropLines_AreNotThereWhereThereIsNoGround) {
  content.shown.dropLines = true;
  content.stage.middle = {0, 0, 900};
  for (const Shape &shape : *composed().layer(Layer::Solids))
    EXPECT_NE(shape.mark, "Q/drop");
}

TEST(ShownPartNames, AreOnesThatTellTheirParts) {
  std::set<std::string_view> names;
  for (const ShownPartName &each : shownPartNames)
    names.insert(each.name);
  EXPECT_EQ(names,
            (std::set<std::string_view>{"labels", "coordinates", "drop-lines", "axes", "grid", "shadows"}));
}

} // namespace
} // namespace halfspace
