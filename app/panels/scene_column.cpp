#include "app/panels/scene_column.h"

#include "widgets/explore/entry_bar.h"
#include "widgets/numbers/number_card.h"
#include "widgets/view/case_line.h"
#include "widgets/view/flat_view.h"
#include "widgets/view/scene_frame.h"
#include "widgets/view/scene_view.h"

#include <QVBoxLayout>

namespace halfspace {

SceneColumn::SceneColumn(SessionModel &model, const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_bar(new EntryBar), m_view(new SceneView(model, typesetter)),
      m_card(new NumberCard(model, typesetter)), m_frame(new SceneFrame(*m_view, *m_card)),
      m_flat(new FlatView(model, typesetter, m_frame)), m_caseLine(new CaseLine) {
  m_frame->setFlatView(*m_flat);
  auto *column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(m_bar);
  column->addWidget(m_frame, 1);
  column->addWidget(m_caseLine);
  connect(m_view, &SceneView::hint, m_card, &NumberCard::setHint);
  connect(&m_view->handles(), &SceneHandles::selectionChanged, m_card,
          [this] { m_card->setSelection(m_view->handles().selectedCoordinate()); });
  connect(m_flat, &FlatView::handleGrabbed, m_view,
          [this](const QString &id) { m_view->handles().select(id.toStdString()); });
}

void SceneColumn::setLook(const Theme &theme, double sizeScale, const Theme &panels) {
  m_view->setTheme(theme);
  m_view->setSizeScale(sizeScale);
  m_flat->setTheme(theme);
  m_flat->setSizeScale(sizeScale);
  m_card->setTheme(panels);
  m_bar->setTheme(panels);
  m_frame->setTheme(panels);
}

} // namespace halfspace
