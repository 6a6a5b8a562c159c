// The contents: all lessons, in a drawer over the scene.
#pragma once

#include "lessons/lesson/lesson_progress.h"
#include "widgets/picture/theme.h"

#include <QFrame>
#include <QPointer>

class QListWidget;

namespace halfspace {

/// Opens at the left edge of its parent, as high as that; closes when a lesson is chosen, with Escape, and by
/// a press beside it. The keys go back to whom they came from.
class ContentsDrawer : public QFrame {
  Q_OBJECT
public:
  explicit ContentsDrawer(QWidget *parent);

  struct Entry {
    QString id;
    QString title;
    LessonState state = LessonState::New;
    QString chapter{};   ///< stands above the first of its lessons; may be empty
    QStringList needs{}; ///< the titles of lessons that come first and are not done
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

  QListWidget *m_list;
  Theme m_theme;
  QPointer<QWidget> m_before; ///< had the focus
};

} // namespace halfspace
