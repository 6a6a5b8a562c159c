// Words that are folded away under their title.
#pragma once

#include "widgets/picture/theme.h"
#include "widgets/text/rich_label.h"

class QToolButton;

namespace halfspace {

/// The title is a button that opens and closes the words.
class NoteFold : public QWidget {
  Q_OBJECT
public:
  NoteFold(const Typesetter &typesetter, const QString &title, QWidget *parent = nullptr);

  [[nodiscard]] RichLabel &words() { return *m_words; }
  [[nodiscard]] bool isOpen() const;
  void setTheme(const Theme &theme);

signals:
  void opened();

protected:
  void resizeEvent(QResizeEvent *event) override;

private:
  QString m_text;
  QToolButton *m_title;
  RichLabel *m_words;
};

} // namespace halfspace
