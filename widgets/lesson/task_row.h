// A task of a lesson with the mark that says whether it is done.
#pragma once

#include "widgets/picture/theme.h"
#include "widgets/text/rich_label.h"

namespace halfspace {

/// Paints a filled circle with a check mark, one with a cross, or an empty one, around a point.
enum class Verdict { Open, Right, Wrong };
void paintVerdict(QPainter &painter, QPointF center, double radius, Verdict verdict, const Theme &theme);

/// The instruction beside an empty circle, or a check mark once it is done.
class TaskRow : public QWidget {
  Q_OBJECT
public:
  TaskRow(const Typesetter &typesetter, const QString &instruction, QWidget *parent = nullptr);

  void setDone(bool done);
  [[nodiscard]] bool isDone() const { return m_done; }
  void setTheme(const Theme &theme);

protected:
  void paintEvent(QPaintEvent *event) override;

private:
  void tellAccessibly();

  RichLabel *m_words;
  bool m_done = false;
  Theme m_theme;
};

} // namespace halfspace
