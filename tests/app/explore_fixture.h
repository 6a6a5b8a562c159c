// A window on Explore.
#pragma once

#include "lessons/typed/write_line.h"
#include "tests/app/window_fixture.h"
#include "widgets/explore/entry_bar.h"
#include "widgets/explore/entry_list.h"
#include "widgets/explore/explore_panel.h"
#include "widgets/explore/fits_box.h"
#include "widgets/scene_selection.h"

#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTreeWidget>

namespace halfspace {

class ExploreFixture : public WindowFixture {
public:
  ExploreFixture() : WindowFixture("explore") {}

  EntryBar &bar() { return *window.findChild<EntryBar *>(); }
  EntryField &field() { return *window.findChild<EntryField *>(); }
  EntryList &list() { return *window.findChild<EntryList *>(); }
  FitsBox &fits() { return *window.findChild<FitsBox *>(); }
  SceneSelection &selection() { return window.findChild<ExplorePanel *>()->selection(); }
  QTreeWidget &suggestions() {
    return *window.findChild<QFrame *>("suggestions")->findChild<QTreeWidget *>();
  }
  QString sentence() { return window.findChild<QLabel *>("entrySentence")->text(); }

  /// Types into the field, after what is there is gone, and enters it.
  void enter(const QString &line) {
    type(line);
    QTest::keyClick(&field(), Qt::Key_Return);
  }
  void type(const QString &line) {
    field().setFocus();
    field().selectAll();
    QTest::keyClicks(&field(), line);
  }
  /// The scene as somebody would type it.
  QStringList scene() {
    QStringList lines;
    for (const Entry &entry : model().session().scene.entries)
      lines << QString::fromStdString(lineFor(entry));
    return lines;
  }
  QModelIndex row(const std::string &id, int column = 0) {
    const auto *rows = static_cast<EntryRows *>(list().model());
    return rows->index(rows->rowOf(id), column);
  }
  void clickRow(const std::string &id, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::qWait(30); // what was typed before has its rows
    QTest::mouseClick(list().viewport(), Qt::LeftButton, modifiers, list().visualRect(row(id, 1)).center());
  }
  /// An item of a menu within the menu of what is selected in the list.
  void chooseInMenu(const QString &submenu, const QString &item) {
    QMenu menu;
    list().fillMenu(menu);
    for (QAction *action : menu.findChild<QMenu *>(submenu)->actions())
      if (action->text().remove('&') == item)
        return action->trigger();
    QFAIL(qPrintable(item));
  }
  /// The button that makes something, by the beginning of the line that this would be behind its name.
  QPushButton *fit(const QString &definition) {
    QCoreApplication::sendPostedEvents();
    for (QPushButton *button : fits().findChildren<QPushButton *>("fit"))
      if (button->toolTip().section(" = ", 1).startsWith(definition))
        return button;
    return nullptr;
  }
  /// Where a mark of the picture is that is a point.
  QPoint placeOf(const std::string &id) {
    const auto *point = std::get_if<PointMark>(findMark(WindowFixture::scene().drawn().figure(), id));
    return pixelOf(point->at);
  }
};

} // namespace halfspace
