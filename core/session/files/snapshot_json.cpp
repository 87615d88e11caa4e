#include "session/files/snapshot_json.h"

#include "catalog/limits.h"
#include "mcp/structure_fields.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

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

constexpr int kVersion = 1;
constexpr qsizetype kMostRegisters = 10'000;
constexpr char kFormat[] = "rotorscope-snapshot";
constexpr std::array kTypes{"u8", "s8", "u16", "s16", "u32", "s32", "f32", "text", "raw"};

QString key(const char *name) { return QString::fromLatin1(name); }

QString textOf(const std::string &text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString hexOf(const char *data, std::size_t size)
{
    return QString::fromLatin1(QByteArray(data, static_cast<qsizetype>(size)).toHex(' '));
}

/// JSON has no word for NaN.
QJsonValue finite(double number)
{
    return std::isfinite(number) ? QJsonValue(number) : QJsonValue();
}

QJsonObject fieldsJson(const Entry &entry, const Bytes &bytes)
{
    QJsonObject object;
    for (const mcp::Field &field : mcp::fieldsOf({static_cast<std::uint16_t>(entry.id)}, bytes)) {
        const auto put = [&](const QJsonValue &value) { object[textOf(field.name)] = value; };
        if (const auto *whole = std::get_if<std::int64_t>(&field.value))
            put(static_cast<qint64>(*whole));
        else if (const auto *number = std::get_if<double>(&field.value))
            put(finite(*number));
        else
            put(textOf(std::get<std::string>(field.value)));
    }
    return object;
}

void putValue(QJsonObject &object, const Entry &entry)
{
    const QString raw = key("raw");
    if (const auto *whole = std::get_if<std::int64_t>(&entry.value)) {
        object[raw] = static_cast<qint64>(*whole);
    } else if (const auto *number = std::get_if<double>(&entry.value)) {
        object[raw] = finite(*number);
        const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(*number));
        object[key("bits")] = QStringLiteral("%1").arg(bits, 8, 16, QLatin1Char('0')).toUpper();
    } else if (const auto *text = std::get_if<std::string>(&entry.value)) {
        object[raw] = textOf(*text);
        if (textOf(*text).toStdString() != *text)
            object[key("bytes")] = hexOf(text->data(), text->size());
    } else {
        const auto &bytes = std::get<Bytes>(entry.value);
        object[raw] = hexOf(reinterpret_cast<const char *>(bytes.data()), bytes.size());
        if (const QJsonObject fields = fieldsJson(entry, bytes); !fields.isEmpty())
            object[key("fields")] = fields;
    }
}

QJsonObject jsonOf(const Entry &entry)
{
    QJsonObject object{{key("name"), textOf(entry.name)}, {key("motor"), entry.motor},
        {key("id"),
            QStringLiteral("0x")
                + QString::number(entry.id, 16).toUpper().rightJustified(4, QLatin1Char('0'))},
        {key("group"), textOf(entry.group)},
        {key("type"), key(kTypes[static_cast<std::size_t>(entry.type)])},
        {key("tunable"), entry.tunable}};
    putValue(object, entry);
    if (entry.shown) {
        object[key("value")] = finite(*entry.shown);
        object[key("unit")] = textOf(entry.unit);
    }
    return object;
}

QJsonArray listOf(const std::vector<std::string> &texts)
{
    QJsonArray list;
    for (const std::string &text : texts)
        list.append(textOf(text));
    return list;
}

QJsonObject jsonOf(const drive::Identity &board)
{
    return {{key("protocol"), textOf(board.protocol)}, {key("firmware"), textOf(board.firmware)},
        {key("version"), textOf(board.version)}, {key("control_board"), textOf(board.controlBoard)},
        {key("power_boards"), listOf(board.powerBoards)},
        {key("motor_names"), listOf(board.motorNames)}, {key("motors"), board.motors}};
}

QByteArray compact(const QJsonObject &object)
{
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

// ---- reading ----

using Problem = SnapshotProblem;
using Read = Result<Value, Problem>;

std::optional<Bytes> bytesOfHex(const QString &text)
{
    QByteArray digits = text.toLatin1();
    digits.replace(' ', "");
    const QByteArray bytes = QByteArray::fromHex(digits);
    if (bytes.size() * 2 != digits.size())
        return std::nullopt;
    return Bytes(bytes.begin(), bytes.end());
}

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
    const QString bits = object[key("bits")].toString();
    const std::uint32_t number = bits.toUInt(&ok, 16);
    if (ok && bits.size() == 8)
        return Value(static_cast<double>(std::bit_cast<float>(number)));
    if (!object[key("raw")].isDouble())
        return fail(Problem::NoNumber);
    return Value(static_cast<double>(static_cast<float>(object[key("raw")].toDouble())));
}

Read valueOf(const QJsonObject &object, ValueType type)
{
    const QJsonValue raw = object[key("raw")];
    if (type == ValueType::F32)
        return floatOf(object);
    if (catalog::isInteger(type))
        return wholeOf(raw, type);
    if (!raw.isString())
        return fail(Problem::NoText);
    if (type == ValueType::Text && !object.contains(key("bytes")))
        return Value(raw.toString().toStdString());
    const auto bytes =
        bytesOfHex(type == ValueType::Text ? object[key("bytes")].toString() : raw.toString());
    if (!bytes)
        return fail(Problem::NotBytes);
    if (type == ValueType::Text)
        return Value(std::string(bytes->begin(), bytes->end()));
    return Value(*bytes);
}

Result<Entry, Problem> entryOf(const QJsonObject &object)
{
    Entry entry;
    entry.name = object[key("name")].toString().toStdString();
    if (entry.name.empty())
        return fail(Problem::NoName);
    entry.motor = object[key("motor")].toInt(-1);
    if (entry.motor < 0 || entry.motor > 7)
        return fail(Problem::NoMotor);
    bool ok = false;
    entry.id = object[key("id")].toString().toUInt(&ok, 16);
    if (!ok || entry.id > 0xFFFF)
        return fail(Problem::NoId);
    entry.group = object[key("group")].toString().toStdString();
    const QByteArray type = object[key("type")].toString().toLatin1();
    const auto at = std::find(kTypes.begin(), kTypes.end(), std::string_view(type.constData()));
    if (at == kTypes.end())
        return fail(Problem::NoType);
    entry.type = static_cast<ValueType>(at - kTypes.begin());
    entry.tunable = object[key("tunable")].toBool();
    auto value = valueOf(object, entry.type);
    if (!value)
        return fail(value.error());
    entry.value = std::move(*value);
    if (object.contains(key("value")))
        entry.shown = object[key("value")].toDouble(std::numeric_limits<double>::quiet_NaN());
    entry.unit = object[key("unit")].toString().toStdString();
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
    const auto text = [&](const char *name) { return object[key(name)].toString().toStdString(); };
    drive::Identity board;
    board.protocol = text("protocol");
    board.firmware = text("firmware");
    board.version = text("version");
    board.controlBoard = text("control_board");
    board.powerBoards = textsOf(object[key("power_boards")]);
    board.motorNames = textsOf(object[key("motor_names")]);
    board.motors = object[key("motors")].toInt(1);
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
    QByteArray text = "{\"format\":\"" + QByteArray(kFormat)
        + "\",\"version\":" + QByteArray::number(kVersion)
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
        SnapshotFileError error;
        error.problem = problem;
        return fail(error);
    };
    QJsonParseError error;
    const QJsonObject root = QJsonDocument::fromJson(text, &error).object();
    if (error.error != QJsonParseError::NoError)
        return fail(SnapshotFileError{.problem = Problem::NotJson,
            .line = lineAt(text, error.offset),
            .number = 0,
            .name = {},
            .parserText = error.errorString()});
    if (root[key("format")].toString() != key(kFormat))
        return wrong(Problem::NotASnapshot);
    if (root[key("version")].toInt() != kVersion)
        return wrong(Problem::NewerVersion);
    if (!root[key("registers")].isArray())
        return wrong(Problem::NoRegisters);
    const QJsonArray registers = root[key("registers")].toArray();
    if (registers.size() > kMostRegisters)
        return wrong(Problem::TooManyRegisters);
    Snapshot snapshot;
    snapshot.board = identityOf(root[key("board")].toObject());
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
                .name = object[key("name")].toString(),
                .parserText = {}});
        snapshot.entries.push_back(std::move(*entry));
    }
    return snapshot;
}

} // namespace session
