// A piece of Markdown with formulas, as tall as its words need. A link is opened by a click, or by Enter once
// Tab has led to it.
#pragma once

#include "widgets/picture/theme.h"
#include "widgets/text/rich_text.h"

#include <QWidget>

class QHelpEvent;

namespace halfspace {

class RichLabel : public QWidget {
  Q_OBJECT
public:
  /// The typesetter must outlive the label.
  explicit RichLabel(const Typesetter &typesetter, QWidget *parent = nullptr);
  ~RichLabel() override;

  /// Whether they are others than before.
  bool setWords(FilledMarkdown words);
  /// The words in plain text, as a screen reader tells them.
  [[nodiscard]] QString plain() const { return m_text.plain(); }
  /// While it is held it becomes no less high, whatever its words are.
  void setHeld(bool held);
  /// The colour of words; the theme tells that of links and of what cannot be read.
  void setInk(Color ink, const Theme &theme);
  /// Before, pictures are told by their descriptions.
  void setPictures(LessonPictures pictures);
  /// Why the formula at a place of the label cannot be read; empty where there is nothing to say.
  [[nodiscard]] QString problemAt(QPoint place) const;
  /// The address of the link at a place of the label; empty where there is none.
  [[nodiscard]] QString linkAt(QPoint place) const;

  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

protected:
  bool event(QEvent *event) override;
  bool focusNextPrevChild(bool next) override;
  void focusInEvent(QFocusEvent *event) override;
  void keyPressEvent(QKeyEvent *event) override;
  void mouseMoveEvent(QMouseEvent *event) override;
  void mousePressEvent(QMouseEvent *event) override;
  void mouseReleaseEvent(QMouseEvent *event) override;
  void paintEvent(QPaintEvent *event) override;
  void changeEvent(QEvent *event) override;

private:
  void build();
  void lookForLinks();
  void showTip(const QHelpEvent &help);
  /// The text in lines of a width; −1: as long as they like.
  [[nodiscard]] QTextDocument &layOut(double width) const;

  const Typesetter &m_typesetter;
  RichTextStyle m_style; ///< but for the font, which is the label's
  bool m_held = false;
  RichText m_text;
  std::vector<QTextCursor> m_links;
  int m_focused = 0; ///< the link that keys are about
  QString m_pressed; ///< the address that the mouse went down on
};

} // namespace halfspace
