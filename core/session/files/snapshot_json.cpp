#include "session/files/snapshot_json.h"

#include "base/text.h"
#include "catalog/limits.h"
#include "mcp/structure_fields.h"
#include "session/files/json_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <set>

namespace session {

namespace {

using catalog::Value;
using catalog::ValueType;
using snapshots::Entry;
using snapshots::Snapshot;

constexpr int kSnapshotVersion = 1;
constexpr qsizetype kMostRegisters = 10'000;
constexpr char kSnapshotFormat[] = "rotorscope-snapshot";
constexpr std::array kTypeWords{"u8", "s8", "u16", "s16", "u32", "s32", "f32", "text", "raw"};

QString spelt(ByteView bytes) { return QString::fromStdString(hexOf(bytes, " ", kLowerHex)); }

/// JSON has no word for NaN.
QJsonValue finite(double number)
{
    return std::isfinite(number) ? QJsonValue(number) : QJsonValue();
}

QJsonObject fieldsJson(const Entry &entry, const Bytes &bytes)
{
    QJsonObject object;
    for (const mcp::Field &field : mcp::fieldsOf({static_cast<std::uint16_t>(entry.id)}, bytes)) {
        const auto put = [&](const QJsonValue &value) {
            object[QString::fromStdString(field.name)] = value;
        };
        if (const auto *whole = std::get_if<std::int64_t>(&field.value))
            put(static_cast<qint64>(*whole));
        else if (const auto *number = std::get_if<double>(&field.value))
            put(finite(*number));
        else
            put(QString::fromStdString(std::get<std::string>(field.value)));
    }
    return object;
}

void putValue(QJsonObject &object, const Entry &entry)
{
    const QString raw = keyOf("raw");
    if (const auto *whole = std::get_if<std::int64_t>(&entry.value)) {
        object[raw] = static_cast<qint64>(*whole);
    } else if (const auto *number = std::get_if<double>(&entry.value)) {
        object[raw] = finite(*number);
        const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(*number));
        object[keyOf("bits")] = QStringLiteral("%1").arg(bits, 8, 16, QLatin1Char('0')).toUpper();
    } else if (const auto *text = std::get_if<std::string>(&entry.value)) {
        object[raw] = QString::fromStdString(*text);
        if (QString::fromStdString(*text).toStdString() != *text)
            object[keyOf("bytes")] =
                spelt({reinterpret_cast<const std::uint8_t *>(text->data()), text->size()});
    } else {
        const auto &bytes = std::get<Bytes>(entry.value);
        object[raw] = spelt(bytes);
        if (const QJsonObject fields = fieldsJson(entry, bytes); !fields.isEmpty())
            object[keyOf("fields")] = fields;
    }
}

QJsonObject jsonOf(const Entry &entry)
{
    QJsonObject object{{keyOf("name"), QString::fromStdString(entry.name)},
        {keyOf("motor"), entry.motor},
        {keyOf("id"),
            QStringLiteral("0x")
                + QString::number(entry.id, 16).toUpper().rightJustified(4, QLatin1Char('0'))},
        {keyOf("group"), QString::fromStdString(entry.group)},
        {keyOf("type"), keyOf(kTypeWords[static_cast<std::size_t>(entry.type)])},
        {keyOf("tunable"), entry.tunable}};
    putValue(object, entry);
    if (entry.shown) {
        object[keyOf("value")] = finite(*entry.shown);
        object[keyOf("unit")] = QString::fromStdString(entry.unit);
    }
    return object;
}

QJsonArray listOf(const std::vector<std::string> &texts)
{
    QJsonArray list;
    for (const std::string &text : texts)
        list.append(QString::fromStdString(text));
    return list;
}

QJsonObject jsonOf(const drive::Identity &board)
{
    return {{keyOf("protocol"), QString::fromStdString(board.protocol)},
        {keyOf("firmware"), QString::fromStdString(board.firmware)},
        {keyOf("version"), QString::fromStdString(board.version)},
        {keyOf("control_board"), QString::fromStdString(board.controlBoard)},
        {keyOf("power_boards"), listOf(board.powerBoards)},
        {keyOf("motor_names"), listOf(board.motorNames)}, {keyOf("motors"), board.motors}};
}

QByteArray compact(const QJsonObject &object)
{
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

// ---- reading ----

using Problem = SnapshotProblem;
using Read = Result<Value, Problem>;

Read wholeOf(const QJsonValue &raw, ValueType type)
{
    const double number = raw.toDouble(std::numeric_limits<double>::quiet_NaN());
    if (!catalog::typeLimits(type).holds(number) || number != std::nearbyint(number))
        return fail(Problem::NumberDoesNotFit);
    return Value(static_cast<std::int64_t>(number));
}

Read floatOf(const QJsonObject &object)
{
    bool ok = false;
    const QString bits = object[keyOf("bits")].toString();
    const std::uint32_t number = bits.toUInt(&ok, 16);
    if (ok && bits.size() == 8)
        return Value(static_cast<double>(std::bit_cast<float>(number)));
    if (!object[keyOf("raw")].isDouble())
        return fail(Problem::NoNumber);
    return Value(static_cast<double>(static_cast<float>(object[keyOf("raw")].toDouble())));
}

Read valueOf(const QJsonObject &object, ValueType type)
{
    const QJsonValue raw = object[keyOf("raw")];
    if (type == ValueType::F32)
        return floatOf(object);
    if (catalog::isInteger(type))
        return wholeOf(raw, type);
    if (!raw.isString())
        return fail(Problem::NoText);
    if (type == ValueType::Text && !object.contains(keyOf("bytes")))
        return Value(raw.toString().toStdString());
    const QJsonValue hex = type == ValueType::Text ? object[keyOf("bytes")] : raw;
    const auto bytes = bytesIn(hex.toString().toStdString());
    if (!bytes)
        return fail(Problem::NotBytes);
    if (type == ValueType::Text)
        return Value(std::string(bytes->begin(), bytes->end()));
    return Value(*bytes);
}

Result<Entry, Problem> entryOf(const QJsonObject &object)
{
    Entry entry;
    entry.name = object[keyOf("name")].toString().toStdString();
    if (entry.name.empty())
        return fail(Problem::NoName);
    entry.motor = object[keyOf("motor")].toInt(-1);
    if (entry.motor < 0 || entry.motor > 7)
        return fail(Problem::NoMotor);
    bool ok = false;
    entry.id = object[keyOf("id")].toString().toUInt(&ok, 16);
    if (!ok || entry.id > 0xFFFF)
        return fail(Problem::NoId);
    entry.group = object[keyOf("group")].toString().toStdString();
    const QByteArray type = object[keyOf("type")].toString().toLatin1();
    const auto at = std::ranges::find(kTypeWords, std::string_view(type.constData()));
    if (at == kTypeWords.end())
        return fail(Problem::NoType);
    entry.type = static_cast<ValueType>(at - kTypeWords.begin());
    entry.tunable = object[keyOf("tunable")].toBool();
    auto value = valueOf(object, entry.type);
    if (!value)
        return fail(value.error());
    entry.value = std::move(*value);
    if (object.contains(keyOf("value")))
        entry.shown = object[keyOf("value")].toDouble(std::numeric_limits<double>::quiet_NaN());
    entry.unit = object[keyOf("unit")].toString().toStdString();
    return entry;
}

std::vector<std::string> textsOf(const QJsonValue &list)
{
    std::vector<std::string> texts;
    const QJsonArray array = list.toArray();
    for (const auto &text : array)
        texts.push_back(text.toString().toStdString());
    return texts;
}

drive::Identity identityOf(const QJsonObject &object)
{
    const auto text = [&](const char *name) {
        return object[keyOf(name)].toString().toStdString();
    };
    drive::Identity board;
    board.protocol = text("protocol");
    board.firmware = text("firmware");
    board.version = text("version");
    board.controlBoard = text("control_board");
    board.powerBoards = textsOf(object[keyOf("power_boards")]);
    board.motorNames = textsOf(object[keyOf("motor_names")]);
    board.motors = object[keyOf("motors")].toInt(1);
    return board;
}

int lineAt(const QByteArray &text, qsizetype offset)
{
    return 1 + static_cast<int>(text.left(offset).count('\n'));
}

/// Where the n-th object of the list of registers begins. The text is JSON, so brackets pair up outside of strings.
int lineOfRegister(const QByteArray &text, qsizetype number)
{
    const qsizetype list = text.indexOf('[', text.indexOf("\"registers\""));
    int depth = 0;
    bool quoted = false;
    for (qsizetype i = list + 1; list >= 0 && i < text.size(); ++i) {
        const char c = text[i];
        if (quoted)
            c == '\\' ? void(++i) : void(quoted = c != '"');
        else if (c == '"')
            quoted = true;
        else if ((c == '{' || c == '[') && ++depth == 1 && number-- == 0)
            return lineAt(text, i);
        else if (c == '}' || c == ']')
            --depth;
    }
    return 0;
}

} // namespace

QByteArray snapshotJson(const Snapshot &snapshot)
{
    QByteArray text = "{\"format\":\"" + QByteArray(kSnapshotFormat)
        + "\",\"version\":" + QByteArray::number(kSnapshotVersion)
        + ",\n\"board\":" + compact(jsonOf(snapshot.board)) + ",\n\"registers\":[";
    const char *separator = "\n";
    for (const Entry &entry : snapshot.entries) {
        text += separator + compact(jsonOf(entry));
        separator = ",\n";
    }
    return text + "\n]}\n";
}

Result<Snapshot, SnapshotFileError> readSnapshotJson(const QByteArray &text)
{
    const auto wrong = [](Problem problem) {
        return fail(SnapshotFileError{problem, 0, 0, {}, {}});
    };
    QJsonParseError error;
    const QJsonObject root = QJsonDocument::fromJson(text, &error).object();
    if (error.error != QJsonParseError::NoError)
        return fail(SnapshotFileError{.problem = Problem::NotJson,
            .line = lineAt(text, error.offset),
            .number = 0,
            .name = {},
            .parserText = error.errorString()});
    if (root[keyOf("format")].toString() != keyOf(kSnapshotFormat))
        return wrong(Problem::NotASnapshot);
    if (root[keyOf("version")].toInt() != kSnapshotVersion)
        return wrong(Problem::NewerVersion);
    if (!root[keyOf("registers")].isArray())
        return wrong(Problem::NoRegisters);
    const QJsonArray registers = root[keyOf("registers")].toArray();
    if (registers.size() > kMostRegisters)
        return wrong(Problem::TooManyRegisters);
    Snapshot snapshot;
    snapshot.board = identityOf(root[keyOf("board")].toObject());
    std::set<std::pair<std::string, int>> seen;
    for (qsizetype i = 0; i < registers.size(); ++i) {
        const QJsonObject object = registers[i].toObject();
        auto entry = entryOf(object);
        if (entry && !seen.emplace(entry->name, entry->motor).second)
            entry = fail(Problem::Twice);
        if (!entry)
            return fail(SnapshotFileError{.problem = entry.error(),
                .line = lineOfRegister(text, i),
                .number = static_cast<int>(i + 1),
                .name = object[keyOf("name")].toString(),
                .parserText = {}});
        snapshot.entries.push_back(std::move(*entry));
    }
    return snapshot;
}

} // namespace session
