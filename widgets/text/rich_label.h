// A piece of Markdown with formulas, as tall as its words need.
#pragma once

#include "widgets/text/rich_text.h"

#include <QWidget>

namespace halfspace {

class RichLabel : public QWidget {
  Q_OBJECT
public:
  /// The typesetter must outlive the label.
  explicit RichLabel(const Typesetter &typesetter, QWidget *parent = nullptr);
  ~RichLabel() override;

  void setMarkdown(const QString &markdown);
  /// `warning` is for formulas that cannot be read.
  void setInk(const QColor &ink, const QColor &warning);
  /// Why the formula at a place of the label cannot be read; empty where there is nothing to say.
  [[nodiscard]] QString problemAt(QPoint place) const;

  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

protected:
  bool event(QEvent *event) override;
  void paintEvent(QPaintEvent *event) override;
  void changeEvent(QEvent *event) override;

private:
  void build();
  /// The text in lines of a width; −1: as long as they like.
  [[nodiscard]] QTextDocument &layOut(double width) const;

  const Typesetter &m_typesetter;
  QColor m_ink;
  QColor m_warning;
  QString m_markdown;
  RichText m_text;
};

} // namespace halfspace
