#include "app/export/export_window.h"

#include "app/export/export_form.h"
#include "app/export/preview_labels.h"
#include "app/export/preview_pane.h"
#include "app/export/size_words.h"
#include "app/work/save_dialog.h"
#include "lessons/files/write_file.h"
#include "widgets/picture/shapes/surface_layers.h"
#include "widgets/repolish.h"
#include "widgets/scene/offscreen.h"
#include "widgets/session_model.h"
#include "widgets/speak_by.h"

#include <QApplication>
#include <QButtonGroup>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QScreen>
#include <QShortcut>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <tuple>
#include <utility>

namespace halfspace {
namespace {

/// The usual width of the whole, in letters; on a small screen this part of it.
constexpr int lettersInAll = 130;
constexpr double mostOfScreen = 0.9;
/// Nothing was chosen for so long, in milliseconds: the file is made to tell its size.
constexpr int rest = 300;
/// … unless that takes too long, as it has more pixels than this.
constexpr double mostPixelsUnasked = 4e6;

/// As high as all choices are.
QSize usualSize(const QWidget &window, const ExportForm &form) {
  const QSize size(lettersInAll * window.fontMetrics().averageCharWidth(),
                   window.sizeHint().height() - form.sizeHint().height() + form.wholeHeight());
  return size.boundedTo(window.screen()->availableSize() * mostOfScreen);
}

/// Whether the file is made unasked: soon, or refused at once.
bool isMadeUnasked(const FigureExtent &extent) {
  if (!extent.inPixels)
    return true;
  const auto [width, height] = *extent.inPixels;
  return double(width) * height <= mostPixelsUnasked || std::max(width, height) > maxPictureSide;
}

} // namespace

ExportWindow::ExportWindow(SessionModel &model, const WindowFigure &figure, const ExportChoices &choices,
                           QString folder, QWidget *parent)
    : QDialog(parent), m_figure(figure), m_folder(std::move(folder)),
      m_form(new ExportForm(figure.hasFlat(), this)), m_pane(new PreviewPane(this)),
      m_labels(new PreviewLabels(model, *m_pane, this)), m_size(new QLabel), m_message(new QLabel) {
  setObjectName("export");
  setWindowTitle(tr("Export Figure"));
  m_rest.setSingleShot(true);
  m_rest.setInterval(rest);
  fill();
  m_form->fill(choices);
  connect(m_form, &ExportForm::changed, this, &ExportWindow::takeChoices);
  connect(m_pane, &PreviewPane::roomChanged, this, &ExportWindow::askForPreview);
  followLabels(model);
  connect(&m_rest, &QTimer::timeout, this, [this] { askForFile(); });
  ensurePolished(); // as high as it is in its style
  resize(usualSize(*this, *m_form));
}

const ExportChoices &ExportWindow::choices() const { return m_form->choices(); }

void ExportWindow::fill() {
  m_size->setObjectName("figureSize");
  m_message->setObjectName("exportMessage");
  m_message->setWordWrap(true);
  m_message->setTextFormat(Qt::PlainText); // it may tell a file's name
  auto *columns = new QHBoxLayout;
  columns->addLayout(previewColumn(), 1);
  columns->addWidget(m_form);
  auto *buttons = new QDialogButtonBox;
  m_save = buttons->addButton(tr("&Save…"), QDialogButtonBox::AcceptRole);
  m_copy = buttons->addButton(tr("&Copy"), QDialogButtonBox::ActionRole);
  m_copy->setObjectName("copyFigure");
  QPushButton *close = buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
  close->setAutoDefault(false);
  m_copy->setAutoDefault(false);
  m_save->setDefault(true);
  connect(m_save, &QPushButton::clicked, this, &ExportWindow::askAndSave);
  connect(m_copy, &QPushButton::clicked, this, &ExportWindow::copy);
  connect(close, &QPushButton::clicked, this, &ExportWindow::reject);
  auto *rows = new QVBoxLayout(this);
  rows->addLayout(columns, 1);
  rows->addWidget(m_message);
  rows->addWidget(buttons);
  tell({});
}

QBoxLayout *ExportWindow::previewColumn() {
  auto *below = new QHBoxLayout;
  auto *sizes = new QButtonGroup(this);
  for (const auto &[words, name, isActual] :
       {std::tuple(tr("Whole fig&ure"), "fit", false), std::tuple(tr("Actual si&ze"), "actualSize", true)}) {
    auto *button = new QToolButton;
    button->setObjectName(name);
    button->setText(words);
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    sizes->addButton(button);
    below->addWidget(button);
    connect(button, &QToolButton::clicked, m_pane,
            [this, isActual = isActual] { m_pane->setActualSize(isActual); });
  }
  sizes->buttons().first()->setChecked(true);
  auto *labels = new QToolButton;
  labels->setObjectName("labelsMenu");
  labels->setText(tr("Indi&vidual labels"));
  labels->setToolTip(tr("Labels can be dragged in the preview, and hidden with a right click or Delete."));
  labels->setAutoRaise(true);
  labels->setFocusPolicy(Qt::StrongFocus);
  labels->setPopupMode(QToolButton::InstantPopup);
  labels->setMenu(new QMenu(labels));
  connect(labels->menu(), &QMenu::aboutToShow, this, [this, labels] { m_labels->fillMenu(*labels->menu()); });
  below->addWidget(labels);
  below->addStretch(1);
  below->addWidget(m_size);
  auto *column = new QVBoxLayout;
  column->addWidget(m_pane, 1);
  column->addLayout(below);
  return column;
}

void ExportWindow::followLabels(SessionModel &model) {
  connect(&model, &SessionModel::outcomeChanged, this, &ExportWindow::askForPreview);
  const auto addKeys = [this](QKeySequence::StandardKey keys, void (PreviewLabels::*act)()) {
    for (const QKeySequence &each : QKeySequence::keyBindings(keys))
      connect(new QShortcut(each, this), &QShortcut::activated, m_labels, act);
  };
  addKeys(QKeySequence::Undo, &PreviewLabels::undo);
  addKeys(QKeySequence::Redo, &PreviewLabels::redo);
}

void ExportWindow::takeChoices() {
  tell({});
  askForPreview();
}

void ExportWindow::askForPreview() {
  m_rest.stop();
  ++m_chosen;
  ExportChoices seen = choices();
  seen.carriesSession = seen.carriesSession && seen.hasCode; // it is seen in the code alone
  FigureRequest wanted = m_figure.requestFor(seen);
  m_pane->setAccessibleDescription(QString::fromStdString(wanted.subject.description));
  m_previews.ask([this, request = std::move(wanted), room = m_pane->room()](FigureStudio &studio) {
    auto preview = previewOf(studio, request.subject, request.choices, room);
    return [this, preview = std::move(preview), isTransparent = request.choices.isTransparent] {
      takePreview(preview, isTransparent);
    };
  });
}

void ExportWindow::takePreview(const Result<FigurePreview> &preview, bool isTransparent) {
  if (!preview)
    return complain(QString::fromStdString(preview.problem().sentence));
  m_pane->setPreview(*preview, isTransparent);
  m_labels->setShapes(preview->shapes);
  if (m_previews.isBusy())
    return; // something else is chosen by now
  m_size->setText(toWords(preview->extent));
  if (preview->leavesOutSurfaces)
    tell(QString::fromStdString(overfullWords()));
  if (isMadeUnasked(preview->extent))
    m_rest.start();
  emit previewed();
}

void ExportWindow::askForFile(const QString &saveTo) {
  if (!m_save->isEnabled() && saveTo.isEmpty())
    return; // what is asked for comes first
  m_files.ask(
      [this, saveTo, chosen = m_chosen, request = m_figure.requestFor(choices())](FigureStudio &studio) {
        auto figure = studio.maker.file(request.subject, request.choices);
        return [this, saveTo, chosen, figure = std::move(figure)] {
          if (!saveTo.isEmpty())
            return write(figure, saveTo);
          if (chosen != m_chosen)
            return; // something else is chosen by now
          if (!figure)
            return complain(QString::fromStdString(figure.problem().sentence));
          m_size->setText(m_size->text() + ", " + bytesInWords(figure->content.size()));
        };
      });
}

void ExportWindow::askAndSave() {
  const FigureFormat &format = choices().format();
  const QString ending = QString::fromStdString(format.ending);
  const QString file = askWhereToSave(*this, tr("Save figure"),
                                      QString("%1 (*%2)").arg(QString::fromStdString(format.name), ending),
                                      m_figure.name(), ending.mid(1), m_folder);
  if (!file.isEmpty())
    saveTo(file);
}

void ExportWindow::saveTo(const QString &file) {
  const FigureFormat *format = figureFormatOf(file.toStdString());
  if (!format)
    return complain(
        tr("Figures are not written to files that end as %1 does.").arg(QFileInfo(file).fileName()));
  if (format->ending != choices().ending) {
    ExportChoices other = choices();
    other.ending = format->ending;
    m_form->fill(other);
    takeChoices();
  }
  m_folder = QFileInfo(file).absolutePath();
  setBusy(true);
  askForFile(file);
}

void ExportWindow::write(const Result<FigureFile> &figure, const QString &file) {
  setBusy(false);
  if (!figure)
    return complain(QString::fromStdString(figure.problem().sentence));
  if (const auto problem = writeFile(file.toStdString(), figure->content))
    return complain(QString::fromStdString(problem->text()));
  tell(tr("Saved as %1, %2.").arg(QFileInfo(file).fileName(), bytesInWords(figure->content.size())));
  emit settled();
}

void ExportWindow::copy() {
  setBusy(true);
  m_files.ask([this, request = m_figure.requestFor(choices())](FigureStudio &studio) {
    auto figure = copiedFigure(studio.maker, request.subject, request.choices);
    return [this, figure = std::move(figure)] { takeCopy(figure); };
  });
}

void ExportWindow::takeCopy(const Result<CopiedFigure> &figure) {
  setBusy(false);
  if (!figure)
    return complain(QString::fromStdString(figure.problem().sentence));
  QApplication::clipboard()->setMimeData(toMimeData(*figure).release());
  tell(tr("Copied as a picture, as SVG and as LaTeX."));
  emit settled();
}

void ExportWindow::setBusy(bool isBusy) {
  m_save->setEnabled(!isBusy);
  m_copy->setEnabled(!isBusy);
  if (isBusy)
    tell(tr("The figure is being drawn …"));
}

void ExportWindow::reject() {
  const bool isDrawing = !m_save->isEnabled();
  if (!m_labels->putBackHeld() && !isDrawing)
    QDialog::reject();
}

void ExportWindow::done(int result) {
  m_labels->letGo();
  emit settled();
  QDialog::done(result);
}

void ExportWindow::tell(const QString &sentence, bool isWrong) {
  m_message->setText(sentence);
  m_message->setProperty("wrong", isWrong);
  repolish(*m_message);
  tellSpoken(*m_message, QAccessible::Alert);
}

} // namespace halfspace
