#include "session/files/snapshot_folder.h"

#include "session/files/snapshot_json.h"
#include "session/files/whole_file.h"

#include <QDir>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>

namespace session {

namespace {

constexpr int kMostOfASecond = 100;

QString stem(const QDateTime &at)
{
    return QLocale::c().toString(at, QStringLiteral("yyyy-MM-dd_HH-mm-ss"))
        + QStringLiteral("_motor_before-write");
}

/// Names that this folder gives, and no others: oldest first.
QStringList ownNames(const QDir &folder)
{
    static const QRegularExpression own(QRegularExpression::anchoredPattern(
        QStringLiteral(R"(\d{4}-\d\d-\d\d_\d\d-\d\d-\d\d_motor_before-write(_\d\d)?\.json)")));
    QStringList names = folder.entryList(
        {QStringLiteral("*_motor_before-write*.json")}, QDir::Files | QDir::NoSymLinks, QDir::Name);
    names.removeIf([](const QString &name) { return !own.match(name).hasMatch(); });
    // In one second: "x.json", then "x_02.json"; '.' comes before '_' in every locale that Qt sorts by.
    std::ranges::sort(names);
    return names;
}

} // namespace

/// The part that lives in the thread. It gets values and tells values.
class SnapshotWriter : public QObject {
public:
    struct Told {
        QString file, systemText; ///< the text is empty if it went well
    };

    explicit SnapshotWriter(QString path)
        : m_path(std::move(path))
    {
    }

    Told write(const QDateTime &at, const snapshots::Snapshot &snapshot)
    {
        const QByteArray content = snapshotJson(snapshot);
        if (content == m_content && QFile::exists(m_file))
            return {m_file, {}};
        const QDir folder(m_path);
        folder.mkpath(QStringLiteral("."));
        QString file = folder.filePath(keptSnapshotName(at));
        for (int i = 2; QFile::exists(file) && i < kMostOfASecond; ++i)
            file = folder.filePath(QStringLiteral("%1_%2.json")
                                       .arg(stem(at), QString::number(i).rightJustified(2, u'0')));
        const QString why = writeWholeFile(file, content);
        if (!why.isEmpty())
            return {file, why};
        m_content = content;
        m_file = file;
        QStringList names = ownNames(folder);
        while (names.size() > SnapshotFolder::kMostFiles)
            QFile::remove(folder.filePath(names.takeFirst()));
        return {file, {}};
    }

private:
    QString m_path;
    QByteArray m_content; ///< of the newest file
    QString m_file;
};

QString keptSnapshotName(const QDateTime &at) { return stem(at) + QStringLiteral(".json"); }

SnapshotFolder::SnapshotFolder(const QString &path, QObject *parent)
    : QObject(parent)
    , m_path(path)
    , m_writer(new SnapshotWriter(path))
{
    m_writer->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_writer, &QObject::deleteLater);
}

SnapshotFolder::~SnapshotFolder()
{
    if (!m_thread.isRunning()) {
        delete m_writer;
        return;
    }
    // Behind what waits to be written.
    QMetaObject::invokeMethod(
        m_writer, [this] { m_thread.quit(); }, Qt::QueuedConnection);
    m_thread.wait();
}

QStringList SnapshotFolder::files() const
{
    const QDir folder(m_path);
    QStringList files;
    const QStringList names = ownNames(folder);
    for (const QString &name : names)
        files.prepend(folder.filePath(name));
    return files;
}

void SnapshotFolder::save(const QDateTime &at, const snapshots::Snapshot &snapshot)
{
    if (!m_thread.isRunning())
        m_thread.start();
    QMetaObject::invokeMethod(
        m_writer,
        [this, writer = m_writer, at, snapshot] {
            const SnapshotWriter::Told told = writer->write(at, snapshot);
            // The destructor waits for this thread.
            QMetaObject::invokeMethod(
                this,
                [this, told] {
                    told.systemText.isEmpty() ? Q_EMIT saved(told.file)
                                              : Q_EMIT failed(told.file, told.systemText);
                },
                Qt::QueuedConnection);
        },
        Qt::QueuedConnection);
}

} // namespace session
