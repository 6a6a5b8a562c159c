#include "app/panels/window_header.h"

#include "widgets/colors.h"
#include "widgets/lesson/contents_drawer.h"
#include "widgets/view/tool_icons.h"

#include <QLabel>
#include <QMenuBar>
#include <QToolButton>

namespace halfspace {

WindowHeader::WindowHeader(QMenuBar &menus, const SessionModel &model, ContentsDrawer &contents)
    : QObject(&menus), m_menus(menus), m_model(model), m_contentsButton(new QToolButton),
      m_title(new QLabel) {
  m_contentsButton->setObjectName("contentsButton");
  m_contentsButton->setToolTip(tr("All lessons"));
  m_contentsButton->setAccessibleName(tr("Contents"));
  m_contentsButton->setAutoRaise(true);
  m_contentsButton->setCheckable(true);
  connect(m_contentsButton, &QToolButton::clicked, this, [this, &contents](bool open) {
    if (open)
      emit contentsWanted();
    else
      contents.close();
  });
  connect(&contents, &ContentsDrawer::openChanged, m_contentsButton, &QToolButton::setChecked);
  connect(&model, &SessionModel::lessonChanged, this, &WindowHeader::showTitle);
  m_title->setObjectName("lessonTitle");
  m_title->setTextFormat(Qt::PlainText);
  menus.setCornerWidget(m_contentsButton, Qt::TopLeftCorner);
  menus.setCornerWidget(m_title, Qt::TopRightCorner);
}

void WindowHeader::showTitle() {
  m_title->setText(QString::fromStdString(m_model.lesson().title));
  m_title->hide(); // the menus alone
  m_title->setVisible(m_menus.sizeHint().width() + m_title->sizeHint().width() <= m_menus.window()->width());
}

void WindowHeader::setTheme(const Theme &theme) {
  m_contentsButton->setIcon(iconOf(ToolIcon::Contents, toQColor(theme.ink)));
  showTitle();
}

} // namespace halfspace
