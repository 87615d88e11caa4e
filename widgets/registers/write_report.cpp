#include "widgets/registers/write_report.h"

#include "widgets/base/device_text.h"
#include "widgets/base/messages.h"

#include <QCoreApplication>

#include <algorithm>

namespace widgets {
namespace {

constexpr qsizetype kMostNames = 8;

struct WriteReportText {
    Q_DECLARE_TR_FUNCTIONS(WriteReport)
};

QString listed(const QStringList &names, const QString &separator)
{
    QString text = names.mid(0, kMostNames).join(separator);
    if (names.size() > kMostNames)
        text += separator
            + WriteReportText::tr(
                "and %n more", nullptr, static_cast<int>(names.size() - kMostNames));
    return text;
}

QString reasonOf(const drive::WriteResult &result)
{
    return result.reason.empty() ? outcomeText(result.outcome) : deviceText(result.reason);
}

QString sentenceOf(const WriteReport &report, WriteSense sense)
{
    QStringList sentences;
    const int written = static_cast<int>(report.written.size());
    if (written > 0)
        sentences.append(sense == WriteSense::Back
                ? WriteReportText::tr("%n register(s) restored and verified.", nullptr, written)
                : WriteReportText::tr("%n register(s) written and verified.", nullptr, written));
    if (!report.unproved.isEmpty())
        sentences.append(
            WriteReportText::tr("Written, not verified: %1.", "list of registers with reasons")
                .arg(listed(report.unproved, QStringLiteral("; "))));
    if (!report.different.isEmpty())
        sentences.append(
            WriteReportText::tr("The board made another value of: %1.", "list of registers")
                .arg(listed(report.different, QStringLiteral(", "))));
    if (!report.unknown.isEmpty())
        sentences.append(WriteReportText::tr("Sent, outcome unknown: %1.", "list of registers")
                             .arg(listed(report.unknown, QStringLiteral(", "))));
    if (!report.notWritten.isEmpty())
        sentences.append(WriteReportText::tr("Not written: %1", "list of registers with reasons")
                             .arg(listed(report.notWritten, QStringLiteral("; "))));
    return sentences.join(QLatin1Char(' '));
}

} // namespace

WriteReport writeReport(const drive::Ended &ended, const std::vector<drive::RegisterWrite> &asked,
    const catalog::Catalog *catalog, WriteSense sense)
{
    WriteReport report;
    const auto put = [&](const drive::WriteResult &result) {
        const QString name = catalog != nullptr ? deviceText(catalog->nameOf(result.id))
                                                : QString::number(result.id);
        const auto withReason = [&] {
            return WriteReportText::tr("%1: %2", "register: reason").arg(name, reasonOf(result));
        };
        switch (result.outcome) {
        case drive::Outcome::Ok:
            if (result.verified)
                (*result.verified ? report.written : report.different).append(name);
            else
                report.unproved.append(result.reason.empty() ? name : withReason());
            break;
        case drive::Outcome::Unknown:
            report.unknown.append(name);
            break;
        case drive::Outcome::Refused:
        case drive::Outcome::NotSent:
            report.notWritten.append(withReason());
            break;
        }
    };
    for (const drive::WriteResult &result : ended.writes)
        put(result);
    for (const drive::RegisterWrite &write : asked) {
        const bool named = std::any_of(ended.writes.begin(), ended.writes.end(),
            [&](const drive::WriteResult &result) { return result.id == write.id; });
        if (named)
            continue;
        drive::WriteResult silent;
        silent.id = write.id;
        silent.outcome =
            ended.outcome == drive::Outcome::Ok ? drive::Outcome::Unknown : ended.outcome;
        silent.reason = ended.reason;
        put(silent);
    }
    report.sentence = ended.writes.empty() ? failureText(WriteReportText::tr("Write"), ended)
                                           : sentenceOf(report, sense);
    return report;
}

} // namespace widgets
