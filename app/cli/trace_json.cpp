#include "trace_json.h"

#include "base/text.h"
#include "session/files/json_text.h"
#include "values.h"

namespace cli {

using namespace mcp;
using session::JsonText;

namespace {

QString nameOf(const TraceRegister &reg)
{
    return reg.name.empty() ? idText(reg.id.bits) : utf8Text(reg.name);
}

class ItemWriter {
public:
    explicit ItemWriter(JsonText &json)
        : m_json(json)
    {
    }

    void operator()(const TraceEvent &) { m_json.member("type", "event"); }
    void operator()(const TraceInvalid &item)
    {
        m_json.member("type", "invalid");
        m_json.member("reason", item.reason);
    }
    void operator()(const TraceBeacon &item)
    {
        m_json.member("type", "BEACON");
        m_json.member("version", item.version);
        m_json.member("crc", item.crc);
        m_json.member("rxs_max", item.rxsMax);
        m_json.member("txs_max", item.txsMax);
        m_json.member("txa_max", item.txaMax);
    }
    void operator()(const TracePing &item)
    {
        m_json.member("type", "PING");
        m_json.member("c", item.c);
        m_json.member("c2", item.c2);
        m_json.member("n", item.n);
        m_json.member("n2", item.n2);
        m_json.member("liid", item.liid);
        m_json.member("number", item.number);
    }
    void operator()(const TraceError &item)
    {
        m_json.member("type", "ERROR");
        m_json.member("code", item.code);
        m_json.member("code2", item.code2);
    }
    void operator()(const TraceRequest &item);
    void operator()(const TraceResponse &item);
    void operator()(const TraceAsync &item);

private:
    void registers(const std::vector<TraceRegister> &list, const char *idKey, const char *nameKey);
    void values(const char *key, const std::vector<TraceValue> &list);
    void value(const TraceValue &entry);
    void configuration(const DatalogConfig &config);
    void ids(const char *key, const std::vector<RegisterId> &list);

    JsonText &m_json;
};

void ItemWriter::operator()(const TraceRequest &item)
{
    m_json.member("type", "REQUEST");
    m_json.member("length", item.length);
    if (!item.hasCommand)
        return;
    m_json.member("command", item.command);
    m_json.member("command_name", item.commandName);
    m_json.member("motor", item.motor);
    if (item.command == static_cast<std::uint16_t>(mcp::CommandId::GetRegister))
        registers(item.registers, "registers", "names");
    if (!item.writes.empty())
        values("writes", item.writes);
    if (item.datalog)
        configuration(*item.datalog);
}

void ItemWriter::operator()(const TraceResponse &item)
{
    m_json.member("type", "RESPONSE");
    m_json.member("length", item.length);
    m_json.member("status", item.status);
    m_json.member("status_name", item.statusName);
    m_json.member("data", hexOf(item.data, "", kLowerHex));
    if (item.values)
        values("values", *item.values);
    if (item.registerStatus) {
        m_json.beginArray("register_status");
        for (const std::uint8_t status : *item.registerStatus) {
            const std::string_view name = statusName(status);
            if (name.empty())
                m_json.value(status);
            else
                m_json.value(name);
        }
        m_json.endArray();
    }
    if (item.version)
        m_json.member("version", *item.version);
}

void ItemWriter::operator()(const TraceAsync &item)
{
    m_json.member("type", "ASYNC");
    m_json.member("length", item.length);
    m_json.member("timestamp", item.timestamp);
    m_json.member("mark", item.mark);
    m_json.member("async_id", item.asyncId);
    m_json.member("decoded", item.decoded);
    if (!item.decoded)
        return;
    m_json.member("partial", item.partial);
    registers(item.fast, "hf_ids", "hf_names");
    m_json.beginArray("hf");
    for (const std::vector<std::int32_t> &samples : item.fastSamples) {
        m_json.beginArray();
        for (const std::int32_t sample : samples)
            m_json.value(qint64{sample});
        m_json.endArray();
    }
    m_json.endArray();
    if (!item.slow.empty())
        registers(item.slow, "mf_ids", "mf_names");
    m_json.beginArray("mf");
    for (const TraceSlowGroup &group : item.slowGroups) {
        m_json.beginObject();
        m_json.member("block", group.block);
        m_json.beginArray("values");
        for (const std::int64_t number : group.values)
            m_json.value(qint64{number});
        m_json.endArray();
        m_json.endObject();
    }
    m_json.endArray();
    m_json.member("hf_blocks", item.fastBlocks);
    if (item.lostTicks)
        m_json.member("lost_ticks", *item.lostTicks);
}

void ItemWriter::registers(
    const std::vector<TraceRegister> &list, const char *idKey, const char *nameKey)
{
    m_json.beginArray(idKey);
    for (const TraceRegister &reg : list)
        m_json.value(idText(reg.id.bits));
    m_json.endArray();
    m_json.beginArray(nameKey);
    for (const TraceRegister &reg : list)
        m_json.value(nameOf(reg));
    m_json.endArray();
}

void ItemWriter::ids(const char *key, const std::vector<RegisterId> &list)
{
    m_json.beginArray(key);
    for (const RegisterId id : list)
        m_json.value(idText(id.bits));
    m_json.endArray();
}

void ItemWriter::configuration(const DatalogConfig &config)
{
    m_json.beginObject("datalog");
    m_json.member("buffer_size", config.bufferSize);
    m_json.member("hf_rate", config.fastRate);
    m_json.member("mf_rate", config.slowRate);
    ids("hf_ids", config.fast);
    ids("mf_ids", config.slow);
    m_json.member("mark", config.mark);
    m_json.endObject();
}

void ItemWriter::values(const char *key, const std::vector<TraceValue> &list)
{
    m_json.beginArray(key);
    for (const TraceValue &entry : list)
        value(entry);
    m_json.endArray();
}

void ItemWriter::value(const TraceValue &entry)
{
    m_json.beginObject();
    m_json.member("register", idText(entry.reg.id.bits));
    m_json.member("name", nameOf(entry.reg));
    if (const auto *integer = std::get_if<std::int64_t>(&entry.value))
        m_json.member("value", qint64{*integer});
    else if (const auto *real = std::get_if<double>(&entry.value))
        m_json.member("value", *real);
    else if (const auto *string = std::get_if<std::string>(&entry.value))
        m_json.member("value", *string);
    else
        m_json.member("raw", hexOf(std::get<Bytes>(entry.value), "", kLowerHex));
    if (!entry.fields.empty()) {
        m_json.beginObject("fields");
        for (const Field &field : entry.fields) {
            m_json.key(utf8Text(field.name));
            if (const auto *integer = std::get_if<std::int64_t>(&field.value))
                m_json.value(qint64{*integer});
            else if (const auto *real = std::get_if<double>(&field.value))
                m_json.value(*real);
            else
                m_json.value(std::get<std::string>(field.value));
        }
        m_json.endObject();
    }
    m_json.endObject();
}

} // namespace

QByteArray traceJson(const TraceItem &item, qint64 packet, double time_ms, const QString &direction)
{
    JsonText json;
    json.beginObject();
    json.member("packet", packet);
    json.member("t_ms", time_ms);
    json.member("dir", direction);
    std::visit(ItemWriter(json), item);
    json.endObject();
    return json.text();
}

} // namespace cli
