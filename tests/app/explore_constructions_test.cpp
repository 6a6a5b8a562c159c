// Each construction in Explore by the mouse alone, by keys alone, and typed.
#include "lessons/construction/construction.h"
#include "lessons/object/kind.h"
#include "lessons/object/solid.h"
#include "lessons/typed/call_words.h"
#include "tests/app/explore_fixture.h"

using namespace halfspace;

namespace {

/// An object for each role of a construction, as its kind begins.
Scene objectsFor(const Construction &construction) {
  Scene scene;
  for (std::size_t i = 0; i < construction.roles.size(); ++i) {
    const Kind &kind = *findKind(kindsSeenAs(construction.roles[i].kind).front());
    Object object(kind);
    kind.settle(object);
    scene.entries.push_back({"object" + std::to_string(i), std::move(object)});
  }
  return scene;
}

/// Looks at all of the objects, each in the role of its place.
ConstructionUse useOf(const Construction &construction) {
  ConstructionUse use{std::string(construction.id), {}};
  for (std::size_t i = 0; i < construction.roles.size(); ++i)
    use.roles[construction.roles[i].name] = "object" + std::to_string(i);
  return use;
}

/// A window on the objects that a construction looks at.
class ConstructionFixture : public ExploreFixture {
public:
  explicit ConstructionFixture(const Construction &construction) : m_construction(construction) {
    model().startWith({exploreId, 0, objectsFor(construction)});
  }

  /// What was made; nothing where the scene has nothing more.
  std::optional<ConstructionUse> made() {
    const Scene &scene = model().session().scene;
    if (scene.entries.size() != m_construction.roles.size() + 1)
      return {};
    return std::get<ConstructionUse>(scene.entries[m_construction.roles.size()].content);
  }
  /// The button that makes it.
  QPushButton *button() { return fit(QString::fromStdString(std::string(callOf(m_construction)) + "(")); }

private:
  const Construction &m_construction;
};

} // namespace

class ExploreConstructionsTest : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init() { forgetStarts(); }

  void construction_data() {
    QTest::addColumn<int>("place");
    for (std::size_t i = 0; i < constructions().size(); ++i)
      QTest::newRow(constructions()[i].id.data()) << static_cast<int>(i);
  }
  void construction() {
    QFETCH(int, place);
    const Construction &construction = constructions().at(static_cast<std::size_t>(place));
    ConstructionFixture fixture(construction);
    QVERIFY(fixture.ready);
    const ConstructionUse expected = useOf(construction);

    // By the mouse: the objects are clicked in the list, and what fits them.
    for (std::size_t i = 0; i < construction.roles.size(); ++i) {
      fixture.list().scrollTo(fixture.row("object" + std::to_string(i)));
      fixture.clickRow("object" + std::to_string(i), i > 0 ? Qt::ControlModifier : Qt::NoModifier);
    }
    QPushButton *fit = fixture.button();
    QVERIFY(fit);
    QTest::mouseClick(fit, Qt::LeftButton);
    QCoreApplication::processEvents();
    QVERIFY(fixture.made() == expected);
    fixture.model().history().undo();
    QVERIFY(!fixture.made());

    // By keys: from row to row, Space chooses; then the button.
    fixture.selection().set({});
    fixture.list().setFocus();
    QTest::keyClick(&fixture.list(), Qt::Key_Home);
    for (std::size_t i = 1; i < construction.roles.size(); ++i) {
      QTest::keyClick(&fixture.list(), Qt::Key_Down, Qt::ControlModifier);
      QTest::keyClick(&fixture.list(), Qt::Key_Space, Qt::ControlModifier);
    }
    fit = fixture.button();
    QVERIFY(fit);
    fit->setFocus();
    QTest::keyClick(fit, Qt::Key_Space);
    QCoreApplication::processEvents();
    QVERIFY(fixture.made() == expected);
    fixture.model().history().undo();

    // Typed.
    QStringList names;
    for (std::size_t i = 0; i < construction.roles.size(); ++i)
      names << QString("object%1").arg(i);
    fixture.enter(QString("made = %1(%2)").arg(QString::fromUtf8(construction.id.data()), names.join(", ")));
    QVERIFY(fixture.made() == expected);
  }
};

QTEST_MAIN(ExploreConstructionsTest)
#include "explore_constructions_test.moc"
