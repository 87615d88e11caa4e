// What a reader makes of a recording on the disk.
#pragma once

#include "recorded/decoder.h"
#include "recorded/restore.h"

#include <QFile>

namespace support {

struct RecordingFacts {
    std::vector<recorded::Item> items;
    std::vector<recorded::Damage> damage;
    std::optional<recorded::End> ending;
    capture::Capture capture;

    template <class T>
    std::vector<T> all() const
    {
        std::vector<T> found;
        for (const recorded::Item &item : items) {
            if (const auto *what = std::get_if<T>(&item.entry))
                found.push_back(*what);
        }
        return found;
    }
    std::vector<std::string> happenings() const
    {
        std::vector<std::string> names;
        for (const auto &happening : all<recorded::Happening>())
            names.push_back(happening.name);
        return names;
    }
    std::uint64_t samples() const
    {
        std::uint64_t count = 0;
        for (const auto &block : all<capture::SampleBlock>())
            count += capture::samplesOf(block);
        return count;
    }
};

inline RecordingFacts readRecording(const QString &path)
{
    RecordingFacts facts;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return facts;
    recorded::Decoder decoder;
    recorded::Restorer restorer(facts.capture);
    const auto drain = [&] {
        while (auto step = decoder.next()) {
            if (auto *item = std::get_if<recorded::Item>(&*step)) {
                restorer.accept(item->entry);
                facts.items.push_back(std::move(*item));
            } else {
                facts.damage.push_back(std::get<recorded::Damage>(*step));
            }
        }
    };
    while (!file.atEnd()) {
        const QByteArray piece = file.read(1 << 20);
        decoder.feed({reinterpret_cast<const std::uint8_t *>(piece.constData()),
            static_cast<std::size_t>(piece.size())});
        drain();
    }
    decoder.finish();
    drain();
    facts.ending = decoder.ending();
    return facts;
}

} // namespace support
