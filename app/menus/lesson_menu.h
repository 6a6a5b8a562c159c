// Lesson: from step to step, the flight of the step, and the user's own lessons.
#pragma once

#include <QMenu>

namespace halfspace {

class ContentsPresenter;
class FlightPresenter;
class FormulaPresenter;
class GlossaryPresenter;
class OwnLessonFolders;
class PagePresenter;
class StepTurner;

class LessonMenu : public QMenu {
  Q_OBJECT
public:
  /// All must outlive it.
  LessonMenu(StepTurner &turner, PagePresenter &page, FlightPresenter &flight, ContentsPresenter &contents,
             GlossaryPresenter &glossary, FormulaPresenter &formulas, OwnLessonFolders &ownLessons,
             QWidget *parent);

private:
  /// There in steps with a flight alone. The keys are those of the window, as the page may be hidden.
  void addFlightMenu(FlightPresenter &flight);
};

} // namespace halfspace
