// The hints of a task, which are told one by one.
#pragma once

#include "lessons/lazy.h"
#include "widgets/picture/theme.h"
#include "widgets/text/rich_label.h"
#include "widgets/when_seen.h"

#include <vector>

class QToolButton;
class QVBoxLayout;

namespace halfspace {

/// A button asks for the next hint; those that were asked for stand above it. It is hidden where there is
/// none to tell, and once all are told so is the button.
class HintColumn : public QWidget {
  Q_OBJECT
public:
  explicit HintColumn(const Typesetter &typesetter, QWidget *parent = nullptr);

  /// The hints in their order, each made when it is told and seen. As many as were told before are told of
  /// these.
  void setHints(std::vector<Lazy<FilledMarkdown>> hints);
  [[nodiscard]] bool isEmpty() const { return m_hints.empty(); }
  /// While it is held no hint becomes less high.
  void setHeld(bool held);
  void setTheme(const Theme &theme);

signals:
  void told(); ///< one more, on request

private:
  void tellNext();
  void addLabel();
  void showTold();
  void showButton();

  const Typesetter &m_typesetter;
  std::vector<Lazy<FilledMarkdown>> m_hints;
  std::vector<RichLabel *> m_told; ///< of the first hints
  WhenSeen m_words;                ///< theirs
  QVBoxLayout *m_column;
  QToolButton *m_next;
  Theme m_theme;
};

} // namespace halfspace
