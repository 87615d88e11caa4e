// Every recorded session, read by the trace decoder: what it says must be what the recorder wrote down.
#include "catalog/catalog.h"
#include "mcp/trace_decoder.h"
#include "support/places.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

using namespace mcp;

class TestTranscripts : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theDecoderReproducesWhatWasExpected_data();
    void theDecoderReproducesWhatWasExpected();

private:
    catalog::Catalog m_catalog;
};

namespace {

struct Session {
    QJsonArray expect;
    QList<QJsonObject> lines;
};

Session readSession(const QString &path)
{
    QFile file(path);
    Session session;
    if (!file.open(QIODevice::ReadOnly))
        return session;
    session.expect = QJsonDocument::fromJson(file.readLine()).object().value("expect").toArray();
    while (!file.atEnd()) {
        const QByteArray line = file.readLine().trimmed();
        if (!line.isEmpty())
            session.lines.append(QJsonDocument::fromJson(line).object());
    }
    return session;
}

Bytes unhexed(const QString &hex)
{
    const QByteArray bytes = QByteArray::fromHex(hex.toLatin1());
    return {bytes.begin(), bytes.end()};
}

TraceDirection directionOf(const QString &text)
{
    return text == "C>P" ? TraceDirection::FromController
        : text == "P>C"  ? TraceDirection::FromPerformer
                         : TraceDirection::Event;
}

unsigned idOf(const QJsonValue &value) { return value.toString().toUInt(nullptr, 16); }

/// Collects what differs between one line's expectation and the decoder's item.
class Comparison {
public:
    Comparison(QJsonObject want, const catalog::Catalog &catalog)
        : m_want(std::move(want))
        , m_catalog(catalog)
    {
    }
    QStringList differences() const { return m_differences; }

    void number(const char *key, double got)
    {
        const QJsonValue value = m_want.value(QLatin1String(key));
        if (!value.isUndefined() && value.toDouble() != got)
            differ(key, QString::number(got), value);
    }
    void operator()(const TraceEvent &) { type("event"); }
    void operator()(const TraceInvalid &)
    {
        static const QStringList valid{
            "BEACON", "PING", "ERROR", "REQUEST", "RESPONSE", "ASYNC", "event"};
        if (valid.contains(m_want.value("type").toString()))
            differ("type", "invalid", m_want.value("type"));
    }
    void operator()(const TraceBeacon &item)
    {
        type("BEACON");
        number("version", item.version);
        number("crc", item.crc);
        number("rxs_max", item.rxsMax);
        number("txs_max", item.txsMax);
        number("txa_max", item.txaMax);
    }
    void operator()(const TracePing &item)
    {
        type("PING");
        number("c", item.c);
        number("c2", item.c2);
        number("n", item.n);
        number("n2", item.n2);
        number("liid", item.liid);
        number("number", item.number);
    }
    void operator()(const TraceError &item)
    {
        type("ERROR");
        number("code", item.code);
        number("code2", item.code2);
    }
    void operator()(const TraceRequest &item)
    {
        type("REQUEST");
        number("length", static_cast<double>(item.length));
        if (item.hasCommand != m_want.contains("command"))
            differ("command", "there", m_want.value("command"));
        number("command", item.command);
        number("motor", item.motor);
        if (!m_want.contains("registers"))
            return;
        const QJsonArray registers = m_want.value("registers").toArray();
        if (registers.size() != static_cast<qsizetype>(item.registers.size()))
            return differ("registers", QString::number(item.registers.size()), registers);
        for (qsizetype i = 0; i < registers.size(); ++i)
            if (idOf(registers[i]) != item.registers[static_cast<std::size_t>(i)].id.bits)
                differ("registers", QString::number(i), registers[i]);
    }
    void operator()(const TraceResponse &item)
    {
        type("RESPONSE");
        number("length", static_cast<double>(item.length));
        number("status", item.status);
        if (unhexed(m_want.value("data").toString()) != item.data)
            differ("data", "other bytes", m_want.value("data"));
        if (m_want.contains("version"))
            number("version", item.version.value_or(0));
        if (m_want.contains("values"))
            values(
                m_want.value("values").toArray(), item.values.value_or(std::vector<TraceValue>{}));
        const QJsonArray statuses = m_want.value("register_status").toArray();
        const auto got = item.registerStatus.value_or(std::vector<std::uint8_t>{});
        if (statuses.size() != static_cast<qsizetype>(got.size()))
            return differ("register_status", QString::number(got.size()), statuses);
        for (qsizetype i = 0; i < statuses.size(); ++i)
            status(statuses[i].toString(), got[static_cast<std::size_t>(i)]);
    }
    void operator()(const TraceAsync &item)
    {
        type("ASYNC");
        number("length", static_cast<double>(item.length));
        number("timestamp", item.timestamp);
        number("mark", item.mark);
        number("async_id", item.asyncId);
        number("hf_blocks", static_cast<double>(item.fastBlocks));
        if (m_want.contains("lost_ticks"))
            number("lost_ticks", item.lostTicks ? *item.lostTicks : -1.0);
        if (m_want.value("partial").toBool() != item.partial)
            differ("partial", item.partial ? "true" : "false", m_want.value("partial"));
        fastSamples(m_want.value("hf").toObject(), item);
        slowGroups(m_want.value("mf").toArray(), item);
    }

private:
    void differ(const char *key, const QString &got, const QJsonValue &want)
    {
        const QByteArray text = QJsonDocument(QJsonArray{want}).toJson(QJsonDocument::Compact);
        m_differences << QStringLiteral("%1: %2, expected %3")
                             .arg(QLatin1String(key), got, QString::fromUtf8(text));
    }
    void type(const char *got)
    {
        if (m_want.value("type").toString() != QLatin1String(got))
            differ("type", QLatin1String(got), m_want.value("type"));
    }
    void status(const QString &want, std::uint8_t got)
    {
        const QString name =
            want == "WRONG_STRUCT_FORMAT" ? QStringLiteral("BAD_RAW_FORMAT") : want;
        if (QString::fromLatin1(
                statusName(got).data(), static_cast<qsizetype>(statusName(got).size()))
            != name)
            differ("register_status", QString::number(got), want);
    }
    void values(const QJsonArray &want, const std::vector<TraceValue> &got)
    {
        if (want.size() != static_cast<qsizetype>(got.size()))
            return differ("values", QString::number(got.size()), want);
        for (qsizetype i = 0; i < want.size(); ++i)
            value(want[i].toObject(), got[static_cast<std::size_t>(i)]);
    }
    void value(const QJsonObject &want, const TraceValue &got)
    {
        if (idOf(want.value("register")) != got.reg.id.bits)
            differ("register", QString::number(got.reg.id.bits), want);
        if (want.contains("raw")) {
            if (std::get<Bytes>(got.value) != unhexed(want.value("raw").toString()))
                differ("raw", "other bytes", want);
            QList<QJsonValue> leaves;
            collectLeaves(want.value("fields"), leaves);
            if (leaves.size() != static_cast<qsizetype>(got.fields.size()))
                return differ("fields", QString::number(got.fields.size()), want);
            for (qsizetype i = 0; i < leaves.size(); ++i)
                field(leaves[i], got.fields[static_cast<std::size_t>(i)].value, want);
        } else if (const auto *integer = std::get_if<std::int64_t>(&got.value)) {
            field(want.value("value"), *integer, want);
        } else if (const auto *real = std::get_if<double>(&got.value)) {
            field(want.value("value"), *real, want);
        } else {
            field(want.value("value"), std::get<std::string>(got.value), want);
        }
    }
    void field(const QJsonValue &want, const std::variant<std::int64_t, double, std::string> &got,
        const QJsonObject &all)
    {
        bool same = false;
        if (const auto *text = std::get_if<std::string>(&got))
            same = want.toString() == QString::fromStdString(*text);
        else if (const auto *integer = std::get_if<std::int64_t>(&got))
            same = want.isDouble() && want.toDouble() == static_cast<double>(*integer);
        else
            same = want.isDouble()
                && std::abs(want.toDouble() - std::get<double>(got))
                    <= 1e-9 + 2e-6 * std::abs(want.toDouble());
        if (!same)
            differ("value", QStringLiteral("another"), all);
    }
    static void collectLeaves(const QJsonValue &value, QList<QJsonValue> &leaves)
    {
        // A JSON object of Qt is sorted by key; the transcripts' order is only that of the wire for lists.
        static const QStringList order{"SDKVersion", "MotorNumber", "MCP_Flag", "MCPA_UARTA_LOG",
            "MCPA_UARTB_LOG", "MCPA_STLNK_LOG", "PolePairs", "RatedFlux", "Rs", "RsSkinFactor",
            "Ls", "Ld", "MaxCurrent", "CopperMass", "CoolingTau", "Name", "MaxMechSpeed",
            "MaxReadableCurrent", "nominalCurrent", "nominalVoltage", "DriveType",
            "PrimSpeedPosSensingType", "AuxSpeedPosSensingType", "CurrentSensingTopology",
            "FOCRate", "PWMFrequency", "MediumFrequencyTaskFreq", "ConfigurationFlags1",
            "ConfigurationFlags2", "voltage", "current", "frequency", "FinalSpeed_rpm",
            "FinalTorque", "Duration_ms", "Iq", "Id", "phases"};
        if (value.isObject()) {
            for (const QString &key : order)
                if (value.toObject().contains(key))
                    collectLeaves(value.toObject().value(key), leaves);
        } else if (value.isArray()) {
            for (const QJsonValue &item : value.toArray())
                collectLeaves(item, leaves);
        } else {
            leaves.append(value);
        }
    }
    /// Transcripts use the names of the printed documents, and hexadecimal ids for what these do not have.
    bool isNamed(const TraceRegister &reg, const QString &name) const
    {
        const catalog::RegisterInfo *info = m_catalog.find(name.toStdString());
        return info ? m_catalog.find(reg.id.bits) == info : name.toUInt(nullptr, 16) == reg.id.bits;
    }
    void fastSamples(const QJsonObject &want, const TraceAsync &item)
    {
        for (auto it = want.begin(); it != want.end(); ++it) {
            const auto found = std::find_if(item.fast.begin(), item.fast.end(),
                [&](const TraceRegister &reg) { return isNamed(reg, it.key()); });
            if (found == item.fast.end()) {
                differ("hf", "no such signal", it.key());
                continue;
            }
            const auto &samples =
                item.fastSamples[static_cast<std::size_t>(found - item.fast.begin())];
            const QJsonArray list = it.value().toArray();
            const bool known = m_catalog.find(found->id.bits) && found->id.type() == 2;
            bool same = list.size() == static_cast<qsizetype>(samples.size());
            for (qsizetype i = 0; same && i < list.size(); ++i) {
                const int distance = list[i].toInt() - samples[static_cast<std::size_t>(i)];
                same = known ? distance == 0 : distance % 65536 == 0;
            }
            if (!same)
                differ("hf", "other samples", it.key());
        }
    }
    void slowGroups(const QJsonArray &want, const TraceAsync &item)
    {
        if (want.size() != static_cast<qsizetype>(item.slowGroups.size()))
            return differ("mf", QString::number(item.slowGroups.size()), want);
        for (qsizetype k = 0; k < want.size(); ++k) {
            const TraceSlowGroup &group = item.slowGroups[static_cast<std::size_t>(k)];
            const QJsonObject values = want[k].toObject().value("values").toObject();
            // With rate 254 the recorder counts the group as after one block more.
            const bool atEnd = group.block + 1 == item.fastBlocks && want.size() == 1;
            const int block = want[k].toObject().value("block").toInt();
            if (block != static_cast<int>(group.block) + (atEnd ? 1 : 0))
                differ("mf block", QString::number(group.block), want[k]);
            for (auto it = values.begin(); it != values.end(); ++it) {
                for (std::size_t s = 0; s < group.values.size(); ++s) {
                    if (isNamed(item.slow[s], it.key())
                        && it.value().toInteger() != group.values[s])
                        differ("mf value", QString::number(group.values[s]), want[k]);
                }
            }
        }
    }

    QJsonObject m_want;
    const catalog::Catalog &m_catalog;
    QStringList m_differences;
};

} // namespace

void TestTranscripts::theDecoderReproducesWhatWasExpected_data()
{
    auto table = catalog::readTable(catalog::builtInTable("mcp"), "std", 0x060400);
    QVERIFY(table.has_value());
    m_catalog = catalog::Catalog(std::move(*table), 1, {});
    QTest::addColumn<QString>("path");
    QStringList folders{support::dataFile(QStringLiteral("transcripts"))};
    if (const QString captures = support::capturesFolder(); !captures.isEmpty())
        folders << captures;
    for (const QString &folder : folders) {
        const auto files = QDir(folder).entryInfoList({"*.jsonl"}, QDir::Files, QDir::Name);
        QVERIFY(!files.isEmpty());
        for (const QFileInfo &file : files)
            QTest::newRow(qPrintable(file.baseName())) << file.filePath();
    }
}

void TestTranscripts::theDecoderReproducesWhatWasExpected()
{
    QFETCH(QString, path);
    const Session session = readSession(path);
    QVERIFY(!session.expect.isEmpty());
    QCOMPARE(session.lines.size(), session.expect.size());
    TraceDecoder decoder([this](RegisterId id) -> std::optional<TraceNote> {
        const catalog::RegisterInfo *info = m_catalog.find(id.bits);
        return info ? std::optional(TraceNote{info->name, info->type}) : std::nullopt;
    });
    for (qsizetype i = 0; i < session.lines.size(); ++i) {
        const QJsonObject &line = session.lines[i];
        const Bytes bytes = unhexed(line.value("hex").toString());
        const TraceItem item = decoder.next(directionOf(line.value("dir").toString()), bytes);
        Comparison comparison(session.expect[i].toObject(), m_catalog);
        std::visit(comparison, item);
        QVERIFY2(comparison.differences().isEmpty(),
            qPrintable(QStringLiteral("packet %1: %2")
                           .arg(QString::number(i), comparison.differences().join("; "))));
    }
}

QTEST_APPLESS_MAIN(TestTranscripts)
#include "tst_transcripts.moc"
