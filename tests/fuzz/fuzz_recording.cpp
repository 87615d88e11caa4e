// Any bytes as a recording, into a capture. An even first byte: the rest is the file. An odd one: the rest is cut into
// payloads, each in a sound block, because no fuzzer guesses checksums. The whole is an overview's payload, too.
#include "fuzz/script.h"
#include "recorded/decoder.h"
#include "recorded/gain_stretches.h"
#include "recorded/overview.h"
#include "recorded/restore.h"

namespace {

Bytes soundBlocks(ByteView script)
{
    Bytes file = recorded::fileHead(0, "fuzz");
    ByteReader reader(script);
    std::uint32_t number = 0;
    while (reader.left() > 0) {
        const std::uint16_t head = reader.u16(); // what it is in the two highest bits, length below
        const ByteView data = reader.take(std::min<std::size_t>(head & 0x3FFFU, reader.left()));
        const auto interface =
            head >> 15 != 0 ? recorded::Interface::Link : recorded::Interface::Entries;
        number += (head & 0x4000U) != 0 ? 3 : 1;
        const Bytes block =
            recorded::packetBlock({interface, capture::Nanos{number} * 1000, 1, number, 0},
                Bytes(data.begin(), data.end()));
        file.insert(file.end(), block.begin(), block.end());
    }
    return file;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size == 0)
        return 0;
    const ByteView script(data + 1, size - 1);
    const Bytes file = data[0] % 2 == 0 ? Bytes(script.begin(), script.end()) : soundBlocks(script);
    if (const auto overview = recorded::decodeOverview(script)) {
        capture::Capture picture({.maxBytes = 10'000'000});
        recorded::restore(*overview, picture);
        if (const auto span = picture.timeSpan())
            for (const capture::ChannelInfo &info : picture.channels())
                fuzz::require(picture.columns(info.id, span->from, span->to, 10).size() == 10);
    }
    recorded::Decoder decoder;
    capture::Capture capture({.maxBytes = 10'000'000});
    recorded::Restorer restorer(capture);
    recorded::GainStretches stretches;
    std::uint64_t last = 0;
    const auto drain = [&] {
        while (const auto step = decoder.next()) {
            if (const auto *item = std::get_if<recorded::Item>(&*step)) {
                fuzz::require(item->offset >= last && item->offset < file.size());
                last = item->offset;
                restorer.accept(item->entry);
                stretches.accept(item->at, item->entry);
            } else {
                const auto &damage = std::get<recorded::Damage>(*step);
                fuzz::require(damage.offset + damage.bytes <= file.size());
            }
        }
    };
    const std::size_t piece = 1 + data[0] * 16;
    for (std::size_t at = 0; at < file.size(); at += piece) {
        decoder.feed(ByteView(file).subspan(at, std::min(piece, file.size() - at)));
        drain();
    }
    decoder.finish();
    drain();
    for (std::size_t i = 0; i < stretches.all().size(); ++i) {
        const recorded::GainStretch &one = stretches.all()[i];
        fuzz::require(one.from <= one.to && (i == 0 || one.from == stretches.all()[i - 1].to));
    }
    if (const auto span = capture.timeSpan()) {
        for (const capture::ChannelInfo &info : capture.channels())
            fuzz::require(capture.columns(info.id, span->from, span->to, 10).size() == 10);
    }
    return 0;
}
