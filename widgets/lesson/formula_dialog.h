// The formulas of each chapter, as one page, to look them up.
#pragma once

#include "lessons/lesson/chapter_formulas.h"
#include "widgets/picture/theme.h"
#include "widgets/when_seen.h"

#include <QDialog>

class QScrollArea;

namespace halfspace {

class NameList;
class Typesetter;

/// Stands beside its window, which goes on meanwhile. A list of chapters, and the page of the one that is
/// chosen: its lessons, each with its formulas.
class FormulaDialog : public QDialog {
  Q_OBJECT
public:
  /// The typesetter must outlive it.
  FormulaDialog(const Typesetter &typesetter, QWidget *parent);

  void setTheme(const Theme &theme);
  /// The chapter that is chosen stays so, by its name. The same chapters change nothing.
  void setChapters(std::vector<ChapterFormulas> chapters);
  /// Comes to the front with a chapter chosen; nothing happens to the choice where it has no such chapter.
  void open(const QString &chapter);

signals:
  void lessonWanted(const QString &id);

private:
  void showChosen();
  [[nodiscard]] QWidget *pageOf(const ChapterFormulas &chapter);

  const Typesetter &m_typesetter;
  std::vector<ChapterFormulas> m_chapters;
  NameList *m_list;
  QScrollArea *m_room;
  WhenSeen m_page; ///< of the chapter that is chosen
  Theme m_theme;
};

} // namespace halfspace
