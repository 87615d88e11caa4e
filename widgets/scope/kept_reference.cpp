#include "widgets/scope/kept_reference.h"

#include <QDataStream>
#include <QIODevice>
#include <QJsonObject>
#include <QtEndian>

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace widgets {
namespace {

using capture::Nanos;

constexpr qsizetype kMostTraces = 64;
constexpr Nanos kFarthestSample = 1'000'000'000'000'000; ///< from 0 s: eleven days
constexpr std::size_t kSampleBytes = sizeof(qint64) + sizeof(double);

/// Samples without a gap between them.
struct Stretch {
    std::vector<Nanos> times;
    std::vector<double> values;
    Nanos holdUntil = 0;
};

std::vector<Stretch> stretchesOf(
    const capture::Channel &channel, capture::TimeSpan picture, double zero)
{
    std::vector<Stretch> all;
    const auto nanosOf = [zero](double seconds) { return capture::toNanos(seconds - zero); };
    for (const capture::Sample &sample :
        channel.samples(picture.from, picture.to, kMostReferenceSamples + 1)) {
        if (all.empty() || sample.first)
            all.emplace_back();
        all.back().times.push_back(nanosOf(sample.time));
        all.back().values.push_back(sample.value);
        all.back().holdUntil = nanosOf(sample.holdUntil);
    }
    return all;
}

/// Compressed, big-endian: for each stretch how many samples it has, until when its last one holds, the distance of
/// each from the one before (the first from 0 s), and the values. Times are whole nanoseconds.
QByteArray packed(const std::vector<Stretch> &stretches)
{
    QByteArray bytes;
    QDataStream out(&bytes, QIODevice::WriteOnly);
    for (const Stretch &stretch : stretches) {
        out << static_cast<quint32>(stretch.times.size()) << static_cast<qint64>(stretch.holdUntil);
        Nanos before = 0;
        for (const Nanos time : stretch.times)
            out << static_cast<qint64>(time - std::exchange(before, time));
        for (const double value : stretch.values)
            out << value;
    }
    return qCompress(bytes);
}

/// What qCompress() packed; empty if it says that it is more than there is room for, or is not as long as it says:
/// qUncompress() would go on until no memory is left.
QByteArray bytesOf(const QByteArray &packed)
{
    constexpr std::size_t kMostBytes = 2 * kSampleBytes * kMostReferenceSamples;
    constexpr qsizetype kSizeBytes = sizeof(quint32);
    if (packed.size() <= kSizeBytes || qFromBigEndian<quint32>(packed.constData()) > kMostBytes)
        return {};
    QByteArray bytes(qFromBigEndian<quint32>(packed.constData()), Qt::Uninitialized);
    auto size = static_cast<uLongf>(bytes.size());
    const bool whole = uncompress(reinterpret_cast<Bytef *>(bytes.data()), &size,
                           reinterpret_cast<const Bytef *>(packed.constData()) + kSizeBytes,
                           static_cast<uLong>(packed.size() - kSizeBytes))
        == Z_OK;
    return whole && size == static_cast<uLongf>(bytes.size()) ? bytes : QByteArray();
}

bool readStretch(QDataStream &in, std::size_t room, Nanos after, Stretch &stretch)
{
    quint32 count = 0;
    qint64 holdUntil = 0;
    in >> count >> holdUntil;
    if (in.status() != QDataStream::Ok || count == 0 || count > room)
        return false;
    Nanos time = 0;
    for (quint32 i = 0; i < count; ++i) {
        qint64 distance = 0;
        in >> distance;
        if (distance < -kFarthestSample || distance > kFarthestSample)
            return false;
        time += distance;
        if (time <= after || time > kFarthestSample)
            return false;
        stretch.times.push_back(after = time);
    }
    for (quint32 i = 0; i < count; ++i) {
        double value = 0.0;
        in >> value;
        if (!std::isfinite(value))
            return false;
        stretch.values.push_back(value);
    }
    stretch.holdUntil = holdUntil;
    return in.status() == QDataStream::Ok && holdUntil >= time && holdUntil <= kFarthestSample;
}

/// Empty if anything in it makes no sense.
std::vector<Stretch> unpacked(const QByteArray &packed)
{
    const QByteArray bytes = bytesOf(packed);
    QDataStream in(bytes);
    std::vector<Stretch> all;
    std::size_t room = kMostReferenceSamples;
    Nanos after = -kFarthestSample;
    while (!in.atEnd()) {
        all.emplace_back();
        if (!readStretch(in, room, after, all.back()))
            return {};
        room -= all.back().times.size();
        after = all.back().times.back();
    }
    return all;
}

std::size_t countOf(const std::vector<Stretch> &stretches)
{
    std::size_t count = 0;
    for (const Stretch &stretch : stretches)
        count += stretch.times.size();
    return count;
}

} // namespace

std::vector<KeptTrace> keptTraces(
    const capture::Snapshot &kept, capture::TimeSpan picture, double zero, std::size_t most)
{
    std::vector<KeptTrace> traces;
    for (const capture::Channel &channel : *kept) {
        const capture::ChannelInfo &info = channel.info();
        const std::vector<Stretch> stretches = stretchesOf(channel, picture, zero);
        const std::size_t count = countOf(stretches);
        if (count > most)
            return {};
        if (count > 0)
            traces.push_back({info.registerId, QString::fromStdString(info.name),
                QString::fromStdString(info.unit), packed(stretches), count});
        most -= count;
    }
    return traces;
}

capture::Snapshot snapshotOf(const std::vector<KeptTrace> &traces)
{
    std::vector<capture::Channel> channels;
    for (const KeptTrace &trace : traces) {
        capture::ChannelInfo info;
        info.registerId = trace.registerId;
        info.name = trace.name.toStdString();
        info.unit = trace.unit.toStdString();
        info.kind = capture::ChannelInfo::Kind::Slow;
        capture::Channel channel(std::move(info));
        for (const Stretch &stretch : unpacked(trace.samples)) {
            channel.values()->breakHere();
            channel.values()->append(stretch.times, stretch.values, stretch.holdUntil);
        }
        if (!channel.empty())
            channels.push_back(std::move(channel));
    }
    return std::make_shared<const std::vector<capture::Channel>>(std::move(channels));
}

QJsonArray referencesJson(const std::vector<KeptReference> &references)
{
    QJsonArray array;
    for (const KeptReference &reference : references) {
        QJsonArray traces;
        for (const KeptTrace &trace : reference.traces)
            traces.append(QJsonObject{{QStringLiteral("signal"), trace.name},
                {QStringLiteral("register"), double(trace.registerId)},
                {QStringLiteral("unit"), trace.unit},
                {QStringLiteral("samples"), QString::fromLatin1(trace.samples.toBase64())}});
        array.append(QJsonObject{
            {QStringLiteral("reference"),
                reference.which == Reference::A ? QStringLiteral("A") : QStringLiteral("B")},
            {QStringLiteral("trigger"), reference.trigger},
            {QStringLiteral("moment"), reference.moment}, {QStringLiteral("traces"), traces}});
    }
    return array;
}

std::vector<KeptReference> referencesOf(const QJsonArray &array)
{
    constexpr qsizetype kLongestText = 1000;
    std::vector<KeptReference> references;
    std::size_t room = kMostReferenceSamples;
    for (qsizetype i = 0; i < std::min<qsizetype>(array.size(), 2); ++i) {
        const QJsonObject object = array[i].toObject();
        KeptReference reference;
        if (object[QStringLiteral("reference")].toString() == QLatin1String("B"))
            reference.which = Reference::B;
        reference.trigger = object[QStringLiteral("trigger")].toBool();
        reference.moment = object[QStringLiteral("moment")].toString().left(kLongestText);
        const QJsonArray traces = object[QStringLiteral("traces")].toArray();
        for (qsizetype k = 0; k < std::min(traces.size(), kMostTraces); ++k) {
            const QJsonObject trace = traces[k].toObject();
            const double id = trace[QStringLiteral("register")].toDouble(-1.0);
            const QByteArray samples =
                QByteArray::fromBase64(trace[QStringLiteral("samples")].toString().toLatin1());
            const std::size_t count = countOf(unpacked(samples));
            if (count == 0 || count > room || id < 0.0
                || id > std::numeric_limits<catalog::RegisterId>::max())
                continue;
            room -= count;
            reference.traces.push_back({static_cast<catalog::RegisterId>(id),
                trace[QStringLiteral("signal")].toString().left(kLongestText),
                trace[QStringLiteral("unit")].toString().left(kLongestText), samples, count});
        }
        references.push_back(std::move(reference));
    }
    return references;
}

} // namespace widgets
