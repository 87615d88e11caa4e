#include "csv_output.h"

#include "session/csv_file.h"

#include <QFileInfo>
#include <QTemporaryFile>

namespace cli {

using session::CsvError;

Outcome<int> checkCsvTarget(const QString &path)
{
    const QFileInfo target(path);
    const auto refused = [&path](const QString &why) {
        return failure(kFileError,
            QStringLiteral("%1 cannot be written: %2; choose another place with -o.")
                .arg(path, why));
    };
    if (target.exists() && !target.isFile())
        return refused(QStringLiteral("it is no file"));
    QTemporaryFile probe(target.absolutePath() + QStringLiteral("/.rotorscope-XXXXXX"));
    if (!probe.open())
        return refused(probe.errorString());
    return kDone;
}

Outcome<std::uint64_t> writeCsv(const capture::Capture &capture,
    std::span<const capture::ChannelId> channels, const QString &path)
{
    capture::CsvWriter writer(capture.snapshot(channels));
    const session::CsvResult result = session::writeCsvFile(path, writer);
    if (result.error == CsvError::None)
        return result.rows;
    const QString why =
        result.systemText.isEmpty() ? QStringLiteral("it is no file") : result.systemText;
    return failure(kFileError,
        QStringLiteral("%1 was not written: %2; make room or choose another place with -o.")
            .arg(path, why));
}

} // namespace cli
