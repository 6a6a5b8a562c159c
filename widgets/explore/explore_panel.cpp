#include "widgets/explore/explore_panel.h"

#include "widgets/explore/discovery_box.h"
#include "widgets/explore/fits_box.h"
#include "widgets/explore/number_slider.h"
#include "widgets/scene_selection.h"

#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace halfspace {
namespace {

constexpr QMargins panelMargins(14, 10, 14, 6);
/// The list has room for so many rows, whatever stands below it.
constexpr int fewestRows = 5;
/// What can be made of the selection has so much room, in lines of type; what is more is scrolled.
constexpr int linesOfFits = 8;

/// A part that keeps its height, whatever is in it: the rows of the list above it stay under the pointer of
/// who selects several.
class SteadyScroll : public QScrollArea {
public:
  explicit SteadyScroll(QWidget &content) {
    setWidget(&content);
    setWidgetResizable(true);
    setFrameShape(NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  }
  [[nodiscard]] QSize sizeHint() const override { return {0, linesOfFits * fontMetrics().lineSpacing()}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {0, 0}; }
};

} // namespace

ExplorePanel::ExplorePanel(SessionModel &model, QWidget *parent)
    : QWidget(parent), m_model(model), m_selection(new SceneSelection(this)),
      m_edits(new EntryEdits(model, this)), m_list(new EntryList(model, *m_selection, *m_edits)),
      m_slider(new NumberSlider(model)), m_fits(new FitsBox(model, *m_selection, *m_edits)),
      m_welcome(new QLabel) {
  setObjectName("explorePanel");
  m_welcome->setObjectName("exploreWelcome");
  m_welcome->setTextFormat(Qt::RichText);
  m_welcome->setWordWrap(true);
  m_welcome->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  m_welcome->setText(
      tr("<p><b>The scene is empty.</b> Type above it what is to be there, a line for each, as on paper:</p>"
         "<pre>Q = (11, 15, 8)\nE: x + 2y + 2z = 27\nd = distance(Q, E)</pre>"
         "<p>Then drag Q in the picture and watch the numbers. Each line that you have typed stands in a "
         "list here, where you can change it.</p>"));
  auto *column = new QVBoxLayout(this);
  column->setContentsMargins(panelMargins);
  column->addWidget(m_list, 1);
  column->addWidget(m_slider);
  auto *below = new QWidget;
  auto *offers = new QVBoxLayout(below);
  offers->setContentsMargins(0, 0, 0, 0);
  offers->addWidget(m_fits);
  offers->addWidget(new DiscoveryBox(model, *m_selection));
  offers->addStretch();
  m_offers = new SteadyScroll(*below);
  column->addWidget(m_offers);
  m_list->setMinimumHeight(fewestRows * 2 * fontMetrics().lineSpacing());
  column->addWidget(m_welcome, 1);
  connect(&model, &SessionModel::outcomeChanged, this, &ExplorePanel::showScene);
  connect(m_selection, &SceneSelection::changed, m_slider, [this] {
    const auto &ids = m_selection->ids();
    m_slider->setNumber(ids.size() == 1 ? ids.front() : std::string());
  });
  showScene();
}

void ExplorePanel::setTheme(const Theme &theme) { m_list->setTheme(theme); }

void ExplorePanel::showScene() {
  const bool isEmpty = m_model.session().scene.entries.size() == 0;
  m_list->setVisible(!isEmpty);
  m_offers->setVisible(!isEmpty);
  m_welcome->setVisible(isEmpty);
}

} // namespace halfspace
