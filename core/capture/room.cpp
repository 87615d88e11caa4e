// How a capture keeps within its memory: the oldest samples go to the archive, and where there is none, or no room in
// it, they are let go.
#include "capture/capture.h"

#include <algorithm>

namespace capture {

std::size_t Capture::bytes() const
{
    std::size_t sum = 0;
    for (const Entry &entry : m_entries)
        sum += entry.channel->bytes();
    return sum;
}

std::uint64_t Capture::archivedBytes() const
{
    std::uint64_t sum = 0;
    for (const Entry &entry : m_entries)
        sum += entry.channel->archivedBytes();
    return sum;
}

std::uint64_t Capture::archiveRoom() const
{
    return m_config.archive ? std::min(m_config.archive->budget(), m_archiveMost) : 0;
}

void Capture::keepWithinLimit()
{
    m_sinceCheck = 0;
    adoptArchived();
    fillArchive();
    while (bytes() > m_config.maxBytes) {
        if (m_config.patient && !m_sent.empty()) {
            m_sent.front().deposit->wait();
            adoptArchived();
            fillArchive();
        } else if (!releaseOldest()) {
            return;
        }
    }
}

/// Releases the oldest chunk of the channel that reaches back furthest; false if none has a chunk to spare.
bool Capture::releaseOldest()
{
    Channel *oldest = nullptr;
    for (Entry &entry : m_entries) {
        Channel &channel = *entry.channel;
        if (channel.canRelease() && (!oldest || channel.oldest() < oldest->oldest()))
            oldest = &channel;
    }
    if (!oldest)
        return false;
    const std::uint64_t before = oldest->size();
    oldest->releaseOldest();
    m_released += before - oldest->size();
    return true;
}

/// Hands samples over until memory is three quarters full: the last quarter is for what is on its way.
void Capture::fillArchive()
{
    if (!m_config.archive)
        return;
    const std::uint64_t room = archiveRoom();
    while (archivedBytes() > room && releaseOldest()) { }
    const std::size_t piece = m_config.archive->pieceBytes();
    const std::size_t spare = m_config.maxBytes / 4;
    while (bytes() - m_sentBytes > m_config.maxBytes - spare && piece <= room
        && (m_sent.empty() || m_sentBytes + piece <= spare)) {
        // Full: it goes round, the oldest make room.
        while (archivedBytes() + m_sentBytes + piece > room) {
            if (archivedBytes() == 0 || !releaseOldest())
                return;
        }
        if (!handOver())
            return;
    }
}

/// One piece of the oldest samples that are in memory only; false if there are not enough for one.
bool Capture::handOver()
{
    const std::size_t most = m_config.archive->pieceBytes();
    std::uint64_t there = 0;
    for (const Entry &entry : m_entries)
        there += entry.channel->archivableBytes();
    if (there < most)
        return false;
    Sent sent;
    std::vector<Stretch> stretches;
    for (;;) {
        Channel *oldest = nullptr;
        Nanos since = 0;
        for (const Entry &entry : m_entries) {
            Channel &channel = *entry.channel;
            if (channel.archivableBytes() == 0)
                continue;
            const Nanos start = channel.timeOf(channel.toArchive());
            if (!oldest || start < since) {
                oldest = &channel;
                since = start;
            }
        }
        if (!oldest || sent.bytes + oldest->chunkBytes() > most)
            break;
        const Index first = oldest->toArchive();
        sent.bytes += oldest->chunkBytes();
        const std::size_t count = oldest->handOver(stretches);
        sent.chunks.push_back({oldest->info().id, first, count});
    }
    if (sent.chunks.empty())
        return false;
    m_sentBytes += sent.bytes;
    sent.deposit = m_config.archive->store(std::move(stretches));
    m_sent.push_back(std::move(sent));
    return true;
}

/// From now on what the archive has is read from there.
void Capture::adoptArchived()
{
    while (!m_sent.empty()) {
        const Sent &sent = m_sent.front();
        const Deposit::State state = sent.deposit->state();
        if (state == Deposit::State::Waiting)
            return;
        if (state == Deposit::State::Refused) {
            // It may hold what it holds and goes round in that. What was sent after it is sent again: chunks are
            // archived in order.
            m_archiveMost = archivedBytes();
            forgetDeposits();
            return;
        }
        std::span<const Stretch> rest(sent.deposit->stretches());
        for (const Sent::Chunk &chunk : sent.chunks) {
            if (Channel *channel = mutableChannel(chunk.channel))
                channel->place(chunk.first, rest.first(chunk.stretches));
            rest = rest.subspan(chunk.stretches);
        }
        m_sentBytes -= sent.bytes;
        m_sent.pop_front();
    }
}

void Capture::forgetDeposits()
{
    m_sent.clear();
    m_sentBytes = 0;
    for (const Entry &entry : m_entries)
        entry.channel->takeBack();
}

} // namespace capture
