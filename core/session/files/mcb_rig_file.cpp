#include "session/files/mcb_rig_file.h"

#include "base/text.h"
#include "mcb/fragments.h"
#include "session/files/json_text.h"
#include "session/files/whole_file.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace session {

namespace {

using catalog::Access;
using simulation::McbRegister;
using simulation::McbRig;

constexpr int kMostDelay = 1000; ///< frames

constexpr Word<mcb::Type> kTypes[] = {{"INT16", mcb::Type::Int16}, {"UINT16", mcb::Type::UInt16},
    {"INT32", mcb::Type::Int32}, {"UINT32", mcb::Type::UInt32}, {"FLOAT", mcb::Type::Float},
    {"STRING", mcb::Type::Text}};
constexpr Word<mcb::Cyclic> kCyclic[] = {
    {"config", mcb::Cyclic::ConfigOnly}, {"tx", mcb::Cyclic::Tx}, {"rx", mcb::Cyclic::Rx}};
constexpr Word<Access> kAccesses[] = {
    {"r", Access::Read}, {"w", Access::Write}, {"rw", Access::ReadWrite}};

std::optional<unsigned> hexIn(const QString &digits, unsigned most)
{
    bool read = false;
    const unsigned value = digits.toUInt(&read, 16);
    return read && value <= most ? std::optional(value) : std::nullopt;
}

/// As many words as the size asks for; those that are not named are 0.
std::optional<mcb::Words> wordsIn(const QJsonValue &value, std::size_t size)
{
    const QJsonArray list = value.toArray();
    mcb::Words words;
    for (const auto &one : list) {
        const auto word = hexIn(one.toString(), 0xFFFF);
        if (!word)
            return std::nullopt;
        words.push_back(static_cast<std::uint16_t>(*word));
    }
    const std::size_t room = mcb::wordsOf(size);
    if (!value.isArray() || words.size() > room)
        return std::nullopt;
    words.resize(room);
    return words;
}

Result<McbRegister, QString> registerIn(const QString &name, const QJsonObject &object)
{
    const auto wrong = [&name](const char *what) {
        return fail(QStringLiteral("registers.%1: %2").arg(name, QLatin1String(what)));
    };
    const auto *type = findWord(kTypes, object[keyOf("type")].toString().toStdString());
    const auto size = wholeIn<std::uint8_t>(object[keyOf("size")].toDouble(), 1, UINT8_MAX);
    const auto *cyclic = findWord(kCyclic, object[keyOf("cyclic")].toString().toStdString());
    const auto *access = findWord(kAccesses, object[keyOf("access")].toString().toStdString());
    if (type == nullptr)
        return wrong("type is one of INT16, UINT16, INT32, UINT32, FLOAT, STRING");
    if (!size)
        return wrong("size is a number of bytes, 1 to 255");
    if (cyclic == nullptr)
        return wrong("cyclic is one of config, tx, rx");
    if (access == nullptr)
        return wrong("access is one of r, w, rw");
    auto words = wordsIn(object[keyOf("words")], *size);
    if (!words)
        return wrong("words is a list of words in hexadecimal digits, one for two bytes");
    return McbRegister{{*size, *type, *cyclic, *access}, std::move(*words)};
}

} // namespace

Result<McbRig, QString> readMcbRig(const QByteArray &json)
{
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (error.error != QJsonParseError::NoError)
        return fail(QStringLiteral("it is no JSON: %1").arg(error.errorString()));
    const QJsonObject root = document.object();
    if (root[keyOf("protocol")] != QJsonValue(keyOf("mcb")))
        return fail(QStringLiteral("protocol is not \"mcb\""));
    McbRig rig;
    const auto delay = wholeIn<int>(root[keyOf("reply_delay")].toDouble(), 0, kMostDelay);
    if (!delay)
        return fail(QStringLiteral("reply_delay is a number of frames, 0 to %1").arg(kMostDelay));
    rig.replyDelay = *delay;
    if (!root[keyOf("registers")].isObject())
        return fail(QStringLiteral("registers is missing"));
    const QJsonObject registers = root[keyOf("registers")].toObject();
    for (auto it = registers.begin(); it != registers.end(); ++it) {
        const auto address = it.key().startsWith(QLatin1String("0x"))
            ? hexIn(it.key().mid(2), mcb::kMostAddress)
            : std::nullopt;
        if (!address)
            return fail(
                QStringLiteral("registers: \"%1\" is no address, 0x000 to 0x7FF").arg(it.key()));
        auto content = registerIn(it.key(), it.value().toObject());
        if (!content)
            return fail(content.error());
        rig.registers[static_cast<std::uint16_t>(*address)] = std::move(*content);
    }
    return rig;
}

Result<McbRig, QString> readMcbRigFile(const QString &path)
{
    const auto content = readWholeFile(path, kMostText);
    if (!content)
        return fail(content.error());
    return readMcbRig(*content);
}

} // namespace session
