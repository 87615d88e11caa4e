#include "widgets/files/import_csv.h"

#include "widgets/base/device_text.h"
#include "widgets/files/file_job.h"
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
        imported.wrong = csvImportErrorText(*import.error());
}

} // namespace

QString csvImportErrorText(const capture::CsvError &error)
{
    using What = capture::CsvError::What;
    const QString field = deviceText(error.field);
    QString what;
    switch (error.what) {
    case What::NoHeading:
        what = Imports::tr("there is no heading with the names of signals");
        break;
    case What::NoSignals:
        what = Imports::tr("there is one column only");
        break;
    case What::TooManyColumns:
        what = Imports::tr("there are too many columns");
        break;
    case What::LineTooLong:
        what = Imports::tr("the line is too long for a line of numbers");
        break;
    case What::OtherNumberOfFields:
        what = Imports::tr("the line has another number of fields than the heading");
        break;
    case What::NoNumber:
        what = Imports::tr("\"%1\" is no number").arg(field);
        break;
    case What::NoTime:
        what = Imports::tr("\"%1\" is no time").arg(field);
        break;
    case What::TimeRunsBack:
        what = Imports::tr("the time %1 is before the one above it").arg(field);
        break;
    case What::NoRows:
        what = Imports::tr("there is a heading and nothing else");
        break;
    }
    const QString line = QString::number(error.line);
    return error.column == 0
        ? Imports::tr("line %1: %2").arg(line, what)
        : Imports::tr("line %1, column %2: %3").arg(line, QString::number(error.column), what);
}

FileJob *importCsv(const QString &path, QWidget *window,
    std::function<void(capture::Capture &)> take, std::function<void(const QString &)> fail,
    capture::Capture::Config config)
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
            return [imported, take] { take(imported->capture); };
        },
        window);
}

} // namespace widgets
