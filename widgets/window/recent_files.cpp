#include "widgets/window/recent_files.h"

#include "widgets/base/device_text.h"

#include <QFileInfo>
#include <QMenu>

#include <utility>

namespace widgets {

RecentFiles::RecentFiles(QStringList paths, QMenu &menu, QObject *parent)
    : QObject(parent)
    , m_paths(std::move(paths))
    , m_menu(menu)
{
    connect(&menu, &QMenu::aboutToShow, this, &RecentFiles::fill);
    menu.setToolTipsVisible(true);
    fill();
}

void RecentFiles::add(const QString &path)
{
    const QString whole = QFileInfo(path).absoluteFilePath();
    m_paths.removeAll(whole);
    m_paths.prepend(whole);
    if (m_paths.size() > kMost)
        m_paths.removeLast();
    m_menu.setEnabled(true);
}

void RecentFiles::fill()
{
    m_menu.clear();
    m_menu.setEnabled(!m_paths.isEmpty()); // a disabled menu is not asked
    int number = 0;
    for (const QString &path : std::as_const(m_paths)) {
        QString name = fileNameText(path);
        name.replace(QLatin1Char('&'), QLatin1String("&&"));
        QAction *action =
            m_menu.addAction(QStringLiteral("&%1  %2").arg(QString::number(++number), name));
        action->setToolTip(plainToolTip(path));
        action->setEnabled(QFileInfo::exists(path));
        connect(action, &QAction::triggered, this, [this, path] { Q_EMIT chosen(path); });
    }
}

} // namespace widgets
