#include "app/menus/help_dialog.h"

#include "widgets/drawn_icon.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QScreen>
#include <QScrollArea>

#include <initializer_list>
#include <vector>

namespace halfspace {
namespace {

/// The width of the page with two columns, in letters, and its height in lines.
constexpr int letters = 128;
constexpr int lines = 42;
/// A picture is so high, in lines.
constexpr double pictureHeight = 1.5;
constexpr int columnGap = 28;
constexpr int rowGap = 6;
/// Of the screen, at most.
constexpr double mostOfScreen = 0.9;

/// What a hand or a key does: a picture or the names of keys, and words.
struct Row {
  QPainterPath picture;
  QString keys;
  QString words;
};
struct Section {
  QString title;
  std::vector<Row> rows;
};

QString tr(const char *text) { return HelpDialog::tr(text); }

/// Lines from point to point.
QPainterPath strokes(std::initializer_list<std::initializer_list<QPointF>> pieces) {
  QPainterPath path;
  for (const auto &piece : pieces)
    path.addPolygon(QPolygonF(QVector<QPointF>(piece)));
  return path;
}

/// A ball in a flat disc, with arrows to both sides.
QPainterPath sideways() {
  QPainterPath path = strokes(
      {{{1, 8}, {5, 8}}, {{11, 8}, {15, 8}}, {{3, 6}, {1, 8}, {3, 10}}, {{13, 6}, {15, 8}, {13, 10}}});
  path.addEllipse(QPointF(8, 8), 2, 2);
  path.addEllipse(QPointF(8, 8), 5, 2.8);
  return path;
}

/// A ball with arrows up and down.
QPainterPath upright() {
  QPainterPath path = strokes(
      {{{8, 1}, {8, 5}}, {{8, 11}, {8, 15}}, {{6, 3}, {8, 1}, {10, 3}}, {{6, 13}, {8, 15}, {10, 13}}});
  path.addEllipse(QPointF(8, 8), 2, 2);
  return path;
}

/// The tip of an arrow with a ring around it.
QPainterPath tip() {
  QPainterPath path = strokes({{{1, 15}, {11, 5}}, {{7, 5}, {11, 5}, {11, 9}}});
  path.addEllipse(QPointF(11, 5), 4, 4);
  return path;
}

/// An arrow that goes around.
QPainterPath turning() {
  QPainterPath path;
  path.arcMoveTo(2, 5, 12, 6, 60);
  path.arcTo(2, 5, 12, 6, 60, 260);
  path.addPolygon(QPolygonF({{11.5, 6.5}, {13, 9.6}, {9.6, 10.6}}));
  return path;
}

/// A number with arrows to both sides.
QPainterPath scrubbed() {
  return strokes({{{6, 5}, {8, 3}, {8, 10}},
                  {{1, 13}, {15, 13}},
                  {{3, 11}, {1, 13}, {3, 15}},
                  {{13, 11}, {15, 13}, {13, 15}}});
}

std::vector<Section> sections() {
  return {
      {tr("Handles"),
       {{sideways(), {}, tr("Drag a handle to move it in x and y.")},
        {upright(), {}, tr("Click it once more, or hold Shift, to move it up and down.")},
        {tip(), {}, tr("The tip of an arrow turns it and changes its length.")},
        {{}, tr("X, Y, Z"), tr("during a drag lock an axis")},
        {{}, tr("Ctrl or Alt"), tr("during a drag suspends snapping")},
        {{}, tr("Escape"), tr("takes the drag back")},
        {{}, tr("Tab"), tr("goes from handle to handle")},
        {{},
         tr("Arrow keys, Page Up, Page Down"),
         tr("step the selected handle, with Shift a tenth, with Ctrl ten steps")}}},
      {tr("Worked lines"),
       {{{}, {}, tr("Point at a term and its mark lights up in the scene, and the other way round.")},
        {{}, {}, tr("Click a number to see where it comes from.")},
        {scrubbed(), {}, tr("Drag a number that is a coordinate sideways, or double-click it to type.")},
        {{}, tr("Enter"), tr("checks what is typed in a blank, Escape leaves it")},
        {{}, tr("Ctrl C"), tr("copies a line as LaTeX, the right button as MathML and plain text too")},
        {{}, tr("Ctrl ← →"), tr("go from step to step")}}},
      {tr("View"),
       {{turning(), {}, tr("Drag beside the handles to turn the view, with the right button to move it.")},
        {{}, tr("Wheel"), tr("zooms")},
        {{}, tr("F, H"), tr("fit everything, go home")},
        {{}, tr("1 – 4, 7"), tr("are views from the sides, and of the plane")},
        {{}, tr("5, 8"), tr("look along a ray or line, and against it")},
        {{}, tr("V"), tr("goes back to the view before")},
        {{}, tr("6"), tr("folds the flat picture of a lesson that has one")},
        {{}, tr("O"), tr("is orthographic")}}},
      {tr("Window"),
       {{{}, tr("Ctrl +, Ctrl −"), tr("make text and lines larger and smaller")},
        {{}, tr("F9, F8, F11"), tr("the scene alone, the page alone, the whole screen")},
        {{}, tr("Ctrl I"), tr("all numbers")},
        {{}, tr("Ctrl L"), tr("all lessons")},
        {{}, tr("Ctrl G"), tr("what the terms mean")}}},
      {tr("Torpedo and meshes"),
       {{{}, tr("T, P"), tr("fire; play and pause")},
        {{}, tr(", and ."), tr("go back and on by one frame")},
        {{}, tr("Ctrl M"), tr("opens a mesh of your own")},
        {{}, tr("Ctrl D"), tr("puts another beside the one that is selected")},
        {{}, tr("Delete"), tr("takes it away again")}}}};
}

QLabel *wordsLabel(const QString &words) {
  auto *label = new QLabel(words);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  return label;
}

QLabel *boldLabel(const QString &words) {
  QLabel *label = wordsLabel(words);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  return label;
}

/// What stands before the words.
QLabel *signOf(const Row &row) {
  if (row.picture.isEmpty())
    return boldLabel(row.keys);
  auto *label = new QLabel;
  const int side = static_cast<int>(pictureHeight * label->fontMetrics().height());
  label->setPixmap(drawnIcon(row.picture, label->palette().color(QPalette::WindowText)).pixmap(side, side));
  label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  return label;
}

/// Signs and words beside each other; words without a sign take the whole width.
QWidget *columnOf(const std::vector<Section> &all, std::size_t begin, std::size_t end) {
  auto *column = new QWidget;
  auto *grid = new QGridLayout(column);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(rowGap);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 2);
  int place = 0;
  for (std::size_t i = begin; i < end; ++i) {
    auto *title = wordsLabel(all[i].title);
    title->setObjectName("heading");
    grid->addWidget(title, place++, 0, 1, 2);
    for (const Row &row : all[i].rows) {
      const bool hasSign = !row.picture.isEmpty() || !row.keys.isEmpty();
      if (hasSign)
        grid->addWidget(signOf(row), place, 0);
      grid->addWidget(wordsLabel(row.words), place++, hasSign ? 1 : 0, 1, hasSign ? 1 : 2);
    }
    grid->setRowMinimumHeight(place++, 2 * rowGap);
  }
  grid->setRowStretch(place, 1);
  return column;
}

} // namespace

HelpDialog::HelpDialog(QWidget *parent) : QDialog(parent) {
  setWindowTitle(tr("Mouse and keys"));
  const QSize most = (QSizeF(parent->screen()->availableSize()) * mostOfScreen).toSize();
  const QSize wanted(letters * fontMetrics().averageCharWidth(), lines * fontMetrics().lineSpacing());
  const std::vector<Section> all = sections();
  constexpr std::size_t inFirst = 2;
  auto *content = new QWidget;
  auto *columns = new QBoxLayout(
      wanted.width() <= most.width() ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom, content);
  columns->setSpacing(columnGap);
  columns->addWidget(columnOf(all, 0, inFirst), 1);
  columns->addWidget(columnOf(all, inFirst, all.size()), 1);
  auto *scroll = new QScrollArea;
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(content);
  auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto *layout = new QVBoxLayout(this);
  layout->addWidget(scroll, 1);
  layout->addWidget(buttons);
  resize(wanted.boundedTo(most));
}

} // namespace halfspace
