// What stands above the blocks of a step.
#pragma once

#include "widgets/picture/theme.h"

#include <QVBoxLayout>

class QLabel;

namespace halfspace {

/// Which step it is, and beside that the tools of practice; below them the step's title.
class PageHead : public QVBoxLayout {
  Q_OBJECT
public:
  explicit PageHead(QWidget &tools);

  /// Counted from 0; without a number where there are no steps.
  void setStep(int step, int stepCount, const QString &title);
  /// The title is in larger type than the words.
  void setLook(const Theme &theme, const QFont &words);

private:
  QLayout *m_above;
  QLabel *m_number;
  QLabel *m_title;
};

} // namespace halfspace
