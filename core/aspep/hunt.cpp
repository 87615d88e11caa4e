#include "aspep/hunt.h"

#include <algorithm>
#include <utility>

namespace aspep {

void Hunt::learn(const Data &data, ByteView payload)
{
    m_tailSize = std::min(payload.size(), kTail);
    std::copy(
        payload.end() - static_cast<std::ptrdiff_t>(m_tailSize), payload.end(), m_tail.begin());
    if (data.response || payload.size() < std::tuple_size_v<End>)
        return;
    const Look look{data.length, {payload[payload.size() - 2], payload.back()}};
    if (m_last == look)
        m_stream = look;
    m_last = look;
}

void Hunt::begin(ByteView wrong)
{
    m_bytes.assign(m_tail.begin(), m_tail.begin() + static_cast<std::ptrdiff_t>(m_tailSize));
    m_old = m_tailSize;
    m_bytes.insert(m_bytes.end(), wrong.begin(), wrong.end());
    m_tailSize = 0;
}

bool Hunt::fits(ByteView payload) const
{
    return payload[payload.size() - 2] == m_stream->end[0] && payload.back() == m_stream->end[1];
}

/// Whether packets begin here: one of the stream, and behind it another, whatever the board answered between them.
Hunt::Verdict Hunt::judge(std::size_t at, std::size_t longestResponse, std::size_t crcSize) const
{
    for (int found = 0; at + kHeaderSize <= m_bytes.size();) {
        HeaderBytes head{};
        std::copy_n(m_bytes.begin() + static_cast<std::ptrdiff_t>(at), kHeaderSize, head.begin());
        at += kHeaderSize;
        const auto header = decodeHeader(head);
        if (!header)
            return Verdict::No;
        const auto *data = std::get_if<Data>(&*header);
        const bool stream = data != nullptr && !data->response;
        if (found == 0 && !stream)
            return Verdict::No;
        if (data == nullptr)
            continue;
        if (stream ? data->length != m_stream->length : data->length > longestResponse)
            return Verdict::No;
        const std::size_t size = data->length > 0 ? data->length + crcSize : 0;
        if (at + size > m_bytes.size())
            return Verdict::Open;
        if (stream && !fits(ByteView(m_bytes).subspan(at, data->length)))
            return Verdict::No;
        if (stream && ++found == 2)
            return Verdict::Proved;
        at += size;
    }
    return Verdict::Open;
}

bool Hunt::proves(ByteView bytes, std::size_t longestResponse, std::size_t crcSize)
{
    if (!m_stream)
        return false;
    m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end());
    // A packet of the stream begins with this and nothing else: most bytes are passed over by it.
    const std::uint8_t first = encodeHeader(Data{false, m_stream->length}).front();
    std::optional<std::size_t> beginning;
    bool proved = false;
    for (std::size_t at = 0; at < m_bytes.size() && !proved; ++at) {
        if (m_bytes[at] != first)
            continue;
        const Verdict verdict = judge(at, longestResponse, crcSize);
        proved = verdict == Verdict::Proved;
        if (proved || (verdict == Verdict::Open && !beginning))
            beginning = at;
    }
    const std::size_t from = beginning.value_or(m_bytes.size());
    m_bytes.erase(m_bytes.begin(), m_bytes.begin() + static_cast<std::ptrdiff_t>(from));
    m_old -= std::min(m_old, from);
    m_reused = m_old;
    if (!proved && m_bytes.size() > kMost)
        end();
    return proved;
}

Bytes Hunt::take()
{
    m_old = 0;
    return std::exchange(m_bytes, {});
}

} // namespace aspep
