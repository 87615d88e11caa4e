#include "widgets/files/import_csv.h"

#include "session/files/problems.h"
#include "widgets/base/device_text.h"
#include "widgets/base/messages.h"
#include "widgets/files/job.h"
#include "widgets/files/open_recording.h"

#include <QCoreApplication>
#include <QFile>

namespace widgets {
namespace {

struct Imports {
    Q_DECLARE_TR_FUNCTIONS(Imports)
};

constexpr qint64 kPiece = 1 << 20;

struct Imported {
    capture::Capture capture;
    QString wrong; ///< empty: nothing
    bool cancelled = false;
    std::uint64_t leftOut = 0; ///< rows
};

void readFile(const QString &path, const FileJob::Proceed &proceed, Imported &imported)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        imported.wrong = file.errorString();
        return;
    }
    capture::CsvImport import(imported.capture);
    const auto size = static_cast<double>(std::max<qint64>(1, file.size()));
    bool goesOn = true;
    while (goesOn && !imported.cancelled) {
        const QByteArray piece = file.read(kPiece);
        if (piece.isEmpty())
            break;
        goesOn = import.feed({piece.constData(), static_cast<std::size_t>(piece.size())});
        imported.cancelled = !proceed(static_cast<double>(file.pos()) / size);
    }
    if (file.error() != QFileDevice::NoError)
        imported.wrong = file.errorString();
    else if (!imported.cancelled && !import.finish())
        imported.wrong = session::csvProblemText(*import.error(), translatedFileProblem);
    imported.leftOut = import.leftOut();
}

} // namespace

FileJob *importCsv(const QString &path, QWidget *window,
    std::function<void(capture::Capture &, std::uint64_t leftOut)> take,
    std::function<void(const QString &)> fail, capture::Capture::Config config)
{
    return new FileJob(
        Imports::tr("Importing %1").arg(fileNameText(path)),
        [path, config = std::move(config), take = std::move(take), fail = std::move(fail)](
            const FileJob::Proceed &proceed) -> FileJob::Finish {
            auto imported =
                std::make_shared<Imported>(Imported{capture::Capture(config), {}, false});
            readFile(path, proceed, *imported);
            if (imported->cancelled)
                return {};
            if (!imported->wrong.isEmpty())
                return [path, fail, why = imported->wrong] {
                    fail(Imports::tr("%1 cannot be imported (%2).")
                             .arg(deviceText(path), deviceText(why)));
                };
            return [imported, take] { take(imported->capture, imported->leftOut); };
        },
        window);
}

} // namespace widgets
