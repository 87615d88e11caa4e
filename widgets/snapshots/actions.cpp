#include "widgets/snapshots/actions.h"

#include "widgets/base/device_text.h"
#include "widgets/base/look/named.h"
#include "widgets/snapshots/panel.h"

#include <QDropEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QUrl>

namespace widgets {
namespace {

/// The one local JSON file that is dragged; empty if it is anything else.
QString draggedFile(const QMimeData &data)
{
    const QList<QUrl> urls = data.urls();
    if (urls.size() != 1 || !urls.first().isLocalFile())
        return {};
    const QString path = urls.first().toLocalFile();
    return path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive) ? path : QString();
}

} // namespace

SnapshotActions::SnapshotActions(
    Device &device, FilePrompt &files, std::function<SnapshotPanel &()> panel, QWidget &window)
    : QObject(&window)
    , m_device(device)
    , m_files(files)
    , m_panel(std::move(panel))
    , m_window(window)
    , m_save(named(new QAction(tr("&Save a snapshot\u2026"), this), "saveSnapshot"))
    , m_header(named(new QAction(tr("&Export C header\u2026"), this), "exportHeader"))
{
    m_save->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_S);
    connect(m_save, &QAction::triggered, this, [this] { open(SnapshotDialog::Form::Snapshot); });
    connect(m_header, &QAction::triggered, this, [this] { open(SnapshotDialog::Form::Header); });
    connect(&device, &Device::linkStateChanged, this, &SnapshotActions::update);
    connect(&device, &Device::identityChanged, this, &SnapshotActions::update);
    window.setAcceptDrops(true);
    window.installEventFilter(this);
    update();
}

void SnapshotActions::update()
{
    const bool can = m_device.answering() && m_device.identified();
    const auto show = [can](QAction *action, const QString &does) {
        action->setEnabled(can);
        action->setToolTip(plainToolTip(can ? does : tr("No board is answering.")));
    };
    show(m_save, tr("Saves every register that can be read, with the names of board and firmware"));
    show(m_header,
        tr("Saves gains and start-up of the motor in the names of the SDK's drive_parameters.h"));
}

void SnapshotActions::open(SnapshotDialog::Form form)
{
    auto *dialog = new SnapshotDialog(form, m_device, m_files, m_panel().folder(), &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &SnapshotDialog::saved, this, [this](const QString &path, int registers) {
        m_panel().setFolder(QFileInfo(path).path());
        Q_EMIT saved(tr("%n register(s) saved to %1.", nullptr, registers).arg(deviceText(path)));
    });
    dialog->open();
}

bool SnapshotActions::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::DragEnter && event->type() != QEvent::Drop)
        return QObject::eventFilter(watched, event);
    auto *drop = static_cast<QDropEvent *>(event);
    const QString path = draggedFile(*drop->mimeData());
    if (path.isEmpty())
        return QObject::eventFilter(watched, event);
    drop->setDropAction(Qt::CopyAction);
    drop->accept();
    if (event->type() == QEvent::Drop) {
        Q_EMIT panelWanted();
        m_panel().openFile(path);
    }
    return true;
}

} // namespace widgets
