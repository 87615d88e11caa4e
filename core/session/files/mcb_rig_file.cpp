#include "session/files/mcb_rig_file.h"

#include "mcb/fragments.h"
#include "session/files/whole_file.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <optional>

namespace session {

namespace {

using catalog::Access;
using simulation::McbRegister;
using simulation::McbRig;

constexpr int kMostDelay = 1000; ///< frames

template <class T>
struct Word {
    QLatin1String text;
    T value;
};

constexpr Word<mcb::Type> kTypes[] = {{QLatin1String("INT16"), mcb::Type::Int16},
    {QLatin1String("UINT16"), mcb::Type::UInt16}, {QLatin1String("INT32"), mcb::Type::Int32},
    {QLatin1String("UINT32"), mcb::Type::UInt32}, {QLatin1String("FLOAT"), mcb::Type::Float},
    {QLatin1String("STRING"), mcb::Type::Text}};
constexpr Word<mcb::Cyclic> kCyclic[] = {{QLatin1String("config"), mcb::Cyclic::ConfigOnly},
    {QLatin1String("tx"), mcb::Cyclic::Tx}, {QLatin1String("rx"), mcb::Cyclic::Rx}};
constexpr Word<Access> kAccesses[] = {{QLatin1String("r"), Access::Read},
    {QLatin1String("w"), Access::Write}, {QLatin1String("rw"), Access::ReadWrite}};

template <class T, std::size_t N>
std::optional<T> wordIn(const Word<T> (&table)[N], const QJsonValue &value)
{
    const QString text = value.toString();
    for (const Word<T> &word : table) {
        if (text == word.text)
            return word.value;
    }
    return std::nullopt;
}

std::optional<int> wholeIn(const QJsonValue &value, int least, int most)
{
    const double number = value.toDouble(std::nan(""));
    if (!(number >= least && number <= most) || number != std::nearbyint(number))
        return std::nullopt;
    return static_cast<int>(number);
}

std::optional<unsigned> hexIn(const QString &digits, unsigned most)
{
    bool read = false;
    const unsigned value = digits.toUInt(&read, 16);
    return read && value <= most ? std::optional(value) : std::nullopt;
}

/// As many words as the size asks for; those that are not named are 0.
std::optional<mcb::Words> wordsIn(const QJsonValue &value, int size)
{
    const QJsonArray list = value.toArray();
    mcb::Words words;
    for (const auto &one : list) {
        const auto word = hexIn(one.toString(), 0xFFFF);
        if (!word)
            return std::nullopt;
        words.push_back(static_cast<std::uint16_t>(*word));
    }
    const std::size_t room = mcb::wordsOf(static_cast<std::size_t>(size));
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
    const auto type = wordIn(kTypes, object[QLatin1String("type")]);
    const auto size = wholeIn(object[QLatin1String("size")], 1, UINT8_MAX);
    const auto cyclic = wordIn(kCyclic, object[QLatin1String("cyclic")]);
    const auto access = wordIn(kAccesses, object[QLatin1String("access")]);
    if (!type)
        return wrong("type is one of INT16, UINT16, INT32, UINT32, FLOAT, STRING");
    if (!size)
        return wrong("size is a number of bytes, 1 to 255");
    if (!cyclic)
        return wrong("cyclic is one of config, tx, rx");
    if (!access)
        return wrong("access is one of r, w, rw");
    auto words = wordsIn(object[QLatin1String("words")], *size);
    if (!words)
        return wrong("words is a list of words in hexadecimal digits, one for two bytes");
    return McbRegister{
        {static_cast<std::uint8_t>(*size), *type, *cyclic, *access}, std::move(*words)};
}

} // namespace

Result<McbRig, QString> readMcbRig(const QByteArray &json)
{
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (error.error != QJsonParseError::NoError)
        return fail(QStringLiteral("it is no JSON: %1").arg(error.errorString()));
    const QJsonObject root = document.object();
    if (root[QLatin1String("protocol")] != QJsonValue(QLatin1String("mcb")))
        return fail(QStringLiteral("protocol is not \"mcb\""));
    McbRig rig;
    const auto delay = wholeIn(root[QLatin1String("reply_delay")].toDouble(0), 0, kMostDelay);
    if (!delay)
        return fail(QStringLiteral("reply_delay is a number of frames, 0 to %1").arg(kMostDelay));
    rig.replyDelay = *delay;
    if (!root[QLatin1String("registers")].isObject())
        return fail(QStringLiteral("registers is missing"));
    const QJsonObject registers = root[QLatin1String("registers")].toObject();
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
