// The formulas of each chapter, as one page, to look them up.
#pragma once

#include "lessons/lesson/chapter_formulas.h"
#include "widgets/picture/theme.h"

#include <QDialog>

class QListWidget;
class QScrollArea;

namespace halfspace {

class RichLabel;
class Typesetter;

/// Stands beside its window, which goes on meanwhile. A list of chapters, and the page of the one that is
/// chosen: its lessons, each with its formulas.
class FormulaDialog : public QDialog {
  Q_OBJECT
public:
  /// The typesetter must outlive it.
  FormulaDialog(const Typesetter &typesetter, QWidget *parent);

  /// For the chapters that come after it.
  void setTheme(const Theme &theme);
  /// The chapter that is chosen stays so, by its name.
  void setChapters(std::vector<ChapterFormulas> chapters);
  /// Comes to the front with a chapter chosen; nothing happens to the choice where it has no such chapter.
  void open(const QString &chapter);

signals:
  void lessonWanted(const QString &id);

private:
  void choose(const QString &chapter);
  void showChosen();
  [[nodiscard]] QWidget *pageOf(const ChapterFormulas &chapter);

  const Typesetter &m_typesetter;
  std::vector<ChapterFormulas> m_chapters;
  QListWidget *m_list;
  QScrollArea *m_page;
  Theme m_theme;
};

} // namespace halfspace
