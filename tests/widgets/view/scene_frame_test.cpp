// What lies over the 3D view: the card and the tools.
#include "widgets/view/scene_frame.h"

#include "tests/widgets/view/view_fixture.h"
#include "widgets/numbers/number_card.h"
#include "widgets/view/flat_view.h"

#include <QAction>
#include <QLabel>
#include <QSignalSpy>
#include <QToolButton>

using namespace halfspace;
using namespace halfspace::test;

namespace {

/// A frame around the view, with two tools.
class FrameFixture : public ViewFixture {
public:
  FrameFixture() : FrameFixture(libraryOf({distanceScene()})) {}
  explicit FrameFixture(LessonLibrary library)
      : ViewFixture(std::move(library)), card(*new NumberCard(model, m_typesetter)), frame(view, card) {
    home.setShortcut(Qt::Key_H);
    numbers.setCheckable(true);
    frame.addTool(home, ToolIcon::Home);
    frame.addTool(numbers, ToolIcon::Numbers);
    frame.setTheme(themes().front());
    window.layout()->addWidget(&frame);
    QTest::qWait(50);
  }
  ~FrameFixture() {
    view.setParent(nullptr);
    frame.setParent(nullptr);
  }

  [[nodiscard]] QList<QToolButton *> tools() const { return frame.findChildren<QToolButton *>("sceneTool"); }
  /// A widget's place in the frame.
  [[nodiscard]] QRect placeOf(const QWidget &widget) const {
    return {widget.mapTo(&frame, QPoint(0, 0)), widget.size()};
  }

private:
  Typesetter m_typesetter;

public:
  QAction home{"&Home"};
  QAction numbers{"All &Numbers"};
  NumberCard &card;
  SceneFrame frame;
};

/// Two lessons, of which the first has a flat picture.
LessonLibrary libraryWithFlatPicture() {
  LessonLibrary library = libraryOf({distanceScene(), distanceScene()});
  library.lessons.front().flat = FlatPage{{"E", 1}, {"E", 1}};
  return library;
}

} // namespace

class SceneFrameTest : public QObject {
  Q_OBJECT

private slots:
  void cardAndTools_keepTheirCorners_inEverySize() {
    FrameFixture fixture;
    QVERIFY(fixture.ready);
    for (const QSize size : {QSize(600, 450), QSize(400, 300)}) {
      fixture.window.resize(size);
      QTest::qWait(50);
      for (const std::optional<CoordinateId> &selected :
           {std::optional<CoordinateId>(), std::optional(CoordinateId{"Q", 0}),
            std::optional(CoordinateId{"E", 0})}) {
        fixture.card.setSelection(selected);
        fixture.card.setHint("What can be done.");
        QTest::qWait(20);
        const QRect card = fixture.placeOf(fixture.card);
        const int gap = card.left();
        QVERIFY(gap > 0 && gap < 30);
        QCOMPARE(card.bottom(), fixture.frame.height() - 1 - gap);
        QVERIFY(fixture.frame.rect().contains(card));
        QVERIFY(card.height() >= fixture.card.heightForWidth(card.width()));
      }
      const QRect first = fixture.placeOf(*fixture.tools()[0]);
      QCOMPARE(fixture.frame.width() - 1 - first.right(), first.top());
      QVERIFY(fixture.placeOf(*fixture.tools()[1]).top() > first.bottom());
      QVERIFY(fixture.frame.rect().contains(first));
    }
  }

  void flatPicture_keepsItsCorner_besideTheCard_whereALessonHasOne() {
    const Typesetter typesetter; // outlives the picture, which becomes the frame's
    FrameFixture fixture(libraryWithFlatPicture());
    QVERIFY(fixture.ready);
    auto &flat = *new FlatView(fixture.model, typesetter, &fixture.frame);
    fixture.frame.setFlatView(flat);
    fixture.card.setSelection(CoordinateId{"E", 0});
    for (const QSize size : {QSize(1000, 800), QSize(620, 520)}) {
      fixture.window.resize(size);
      QTest::qWait(50);
      const QRect place = fixture.placeOf(flat);
      QVERIFY(flat.isVisible());
      QCOMPARE(fixture.frame.width() - place.right(), fixture.frame.height() - place.bottom());
      QVERIFY(!place.intersects(fixture.placeOf(fixture.card)));
      for (const QToolButton *tool : fixture.tools())
        QVERIFY(!place.intersects(fixture.placeOf(*tool)));
      for (const char *handle : {"Q", "E.P0", "E.n"})
        QVERIFY(!place.contains(fixture.at(handle)));
    }
    const int unfolded = flat.height();
    flat.unfolded().toggle();
    QVERIFY(flat.height() < unfolded / 2);
    fixture.model.openLesson("lesson1");
    QVERIFY(!flat.isVisible());
  }

  void whatTheViewDoesNotDraw_isTold_beforeTheTools_asLongAsItHolds() {
    FrameFixture fixture;
    QVERIFY(fixture.ready);
    const auto &notice = *fixture.frame.findChild<QLabel *>("sceneNotice");
    QVERIFY(!notice.isVisible());
    const Camera camera = fixture.view.viewpoint().camera();
    emit fixture.view.drawing().noticeChanged("Only some are filled.");
    QVERIFY(notice.isVisible());
    QCOMPARE(notice.text(), QString("Only some are filled."));
    QVERIFY(fixture.frame.rect().contains(fixture.placeOf(notice)));
    QVERIFY(!fixture.placeOf(notice).intersects(fixture.placeOf(*fixture.tools()[0])));
    QVERIFY(fixture.view.viewpoint().camera() == camera);
    emit fixture.view.drawing().noticeChanged({});
    QVERIFY(!notice.isVisible());
  }

  void veryManyTriangles_oneBehindAnother_areToldOf_untilAnotherLesson() {
    Scene stack;
    for (int i = 0; i < 60; ++i)
      stack.entries.push_back(
          {"T" + std::to_string(i), TriangleObject{{-90, -90, 0}, {90, -90, 0}, {0, 150, 0}}});
    FrameFixture fixture(libraryOf({distanceScene(), stack}));
    QVERIFY(fixture.ready);
    const auto &notice = *fixture.frame.findChild<QLabel *>("sceneNotice");
    QVERIFY(!notice.isVisible());
    fixture.model.openLesson("lesson1");
    QTRY_VERIFY(notice.isVisible());
    QVERIFY(notice.text().contains("So many surfaces"));
    fixture.model.openLesson("lesson0");
    QTRY_VERIFY(!notice.isVisible());
  }

  void tool_doesWhatItsActionDoes_andSaysItsKey() {
    FrameFixture fixture;
    QVERIFY(fixture.ready);
    QSignalSpy triggered(&fixture.home, &QAction::triggered);
    QTest::mouseClick(fixture.tools()[0], Qt::LeftButton);
    QCOMPARE(triggered.count(), 1);
    QCOMPARE(fixture.tools()[0]->toolTip(), QString("Home (H)"));
    QCOMPARE(fixture.tools()[0]->accessibleName(), QString("Home"));
    QCOMPARE(fixture.tools()[1]->toolTip(), QString("All Numbers"));
  }

  void toolOfAChoice_isPressedWhileTheChoiceHolds() {
    FrameFixture fixture;
    QVERIFY(fixture.ready);
    QToolButton *tool = fixture.tools()[1];
    QTest::mouseClick(tool, Qt::LeftButton);
    QVERIFY(fixture.numbers.isChecked() && tool->isChecked());
    fixture.numbers.setChecked(false);
    QVERIFY(!tool->isChecked());
    QTest::mouseClick(tool, Qt::LeftButton);
    QVERIFY(fixture.numbers.isChecked() && tool->isChecked());
  }

  void tool_clicked_leavesTheKeysWithTheView() {
    FrameFixture fixture;
    QVERIFY(fixture.ready);
    fixture.view.setFocus();
    QTest::mouseClick(fixture.tools()[0], Qt::LeftButton);
    QCOMPARE(fixture.window.focusWidget(), &fixture.view);
  }

  void icons_growWithTheType_upToAHalf_andTakeTheThemesInk() {
    FrameFixture fixture;
    QVERIFY(fixture.ready);
    Theme theme = *findTheme("dark");
    const QSize usual = fixture.tools()[0]->iconSize();
    const QImage light = fixture.tools()[0]->icon().pixmap(32).toImage();
    theme.textScale = 2;
    fixture.frame.setTheme(theme);
    QCOMPARE(fixture.tools()[0]->iconSize(), 1.5 * usual);
    QVERIFY(fixture.tools()[0]->icon().pixmap(32).toImage() != light);
  }
};

QTEST_MAIN(SceneFrameTest)
#include "scene_frame_test.moc"
