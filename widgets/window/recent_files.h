// The files that were opened or saved last, as a menu.
#pragma once

#include <QObject>
#include <QStringList>

class QMenu;

namespace widgets {

class RecentFiles : public QObject {
    Q_OBJECT
public:
    static constexpr qsizetype kMost = 10;

    /// @param menu  outlives it; filled each time that it is opened
    RecentFiles(QStringList paths, QMenu &menu, QObject *parent = nullptr);

    const QStringList &paths() const { return m_paths; } ///< newest first

public Q_SLOTS:
    void add(const QString &path); ///< as the newest

Q_SIGNALS:
    void chosen(const QString &path);

private:
    void fill();

    QStringList m_paths;
    QMenu &m_menu;
};

} // namespace widgets
