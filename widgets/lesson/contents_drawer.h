// The contents: all lessons, in a drawer over the scene.
#pragma once

#include "lessons/lesson/lesson_progress.h"
#include "widgets/picture/theme.h"

#include <QFrame>
#include <QPointer>

class QLineEdit;
class QListWidget;
class QListWidgetItem;

namespace halfspace {

/// Opens at the left edge of its parent, as high as that; closes when a lesson is chosen, with Escape, and by
/// a press beside it. The keys go back to whom they came from. What is typed is looked for among the lessons.
class ContentsDrawer : public QFrame {
  Q_OBJECT
public:
  explicit ContentsDrawer(QWidget *parent);

  struct Entry {
    QString id; ///< stands below the title, small
    QString title;
    LessonState state = LessonState::New;
    QString chapter{};   ///< stands above the first of its lessons; may be empty
    QStringList needs{}; ///< the ids of lessons that come first and are not done
  };
  void setLessons(const std::vector<Entry> &lessons, const QString &current);
  void setTheme(const Theme &theme);
  void open();
  void close();

signals:
  void lessonChosen(const QString &id);
  void openChanged(bool open);

protected:
  bool eventFilter(QObject *watched, QEvent *event) override;
  void keyPressEvent(QKeyEvent *event) override;

private:
  void arrange();
  /// A line of the list that is no lesson.
  void addWords(const QString &words, bool isHeading);
  void choose(const QListWidgetItem *item);
  /// Leaves of the list the lessons that have all words of the search, with their chapters.
  void search(const QString &words);

  QLineEdit *m_search;
  QListWidget *m_list;
  Theme m_theme;
  QPointer<QWidget> m_before; ///< had the focus
};

} // namespace halfspace
