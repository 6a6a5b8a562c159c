#include "app/menus/lesson_menu.h"

#include "app/library/contents_presenter.h"
#include "app/library/formula_presenter.h"
#include "app/library/glossary_presenter.h"
#include "app/library/own_lesson_folders.h"
#include "app/menus/add_item.h"
#include "app/step/flight_keys.h"
#include "app/step/flight_presenter.h"
#include "app/step/page_presenter.h"
#include "app/step/step_turner.h"

namespace halfspace {

LessonMenu::LessonMenu(StepTurner &turner, PagePresenter &page, FlightPresenter &flight,
                       ContentsPresenter &contents, GlossaryPresenter &glossary, FormulaPresenter &formulas,
                       OwnLessonFolders &ownLessons, QWidget *parent)
    : QMenu(tr("&Lesson"), parent) {
  addItem(*this, tr("&Next Step"), QKeySequence("Ctrl+Right"), &turner, [&turner] { turner.turnBy(1); });
  addItem(*this, tr("&Previous Step"), QKeySequence("Ctrl+Left"), &turner, [&turner] { turner.turnBy(-1); });
  addItem(*this, tr("Next &Lesson"), QKeySequence("Ctrl+Shift+Right"), &page, &PagePresenter::openNextLesson);
  addItem(*this, tr("&Contents"), QKeySequence("Ctrl+L"), &contents, &ContentsPresenter::show);
  addItem(*this, tr("&Glossary"), QKeySequence("Ctrl+G"), &glossary, &GlossaryPresenter::show);
  addItem(*this, tr("Fo&rmulas"), QKeySequence("Ctrl+Shift+G"), &formulas, &FormulaPresenter::show);
  addFlightMenu(flight);
  addSeparator();
  QMenu &own = *addMenu(tr("Your &Own Lessons"));
  own.setObjectName("ownLessons");
  connect(&own, &QMenu::aboutToShow, &ownLessons, [&ownLessons, &own] { ownLessons.fillMenu(own); });
}

void LessonMenu::addFlightMenu(FlightPresenter &flight) {
  QMenu &menu = *addMenu(tr("&Torpedo"));
  FlightPlayer &player = flight.player();
  const auto add = [&menu, &player](const QString &text, FlightControl control, auto slot) {
    addItem(menu, text, keysOf(control), &player, slot);
  };
  add(tr("&Fire"), FlightControl::Fire, [&player] { player.fire(); });
  add(tr("&Play or Pause"), FlightControl::Play, [&player] { player.play(!player.state().isPlaying); });
  add(tr("One Frame &Back"), FlightControl::StepBack, [&player] { player.step(-1); });
  add(tr("One Frame &On"), FlightControl::StepForward, [&player] { player.step(1); });
  connect(&flight, &FlightPresenter::controllable, menu.menuAction(), &QAction::setVisible);
}

} // namespace halfspace
