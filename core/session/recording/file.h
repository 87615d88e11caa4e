// RecordingFile: a recording on a disk. It hands each block to the system with one write and counts it only then; it
// has no thread and no clock. What it does when the disk takes no more is its purpose: the recording ends with a mark
// that needs no room, and everything counted before stays.
//
// Call order: open(), then add(), flush() and sync() as long as they succeed, end() if they did.
#pragma once

#include "recorded/encoder.h"

#include <QLockFile>
#include <QString>

#include <memory>

namespace session {

/// Where blocks go. Tests bring disks that are full or slow.
class BlockSink {
public:
    BlockSink() = default;
    BlockSink(const BlockSink &) = delete;
    BlockSink &operator=(const BlockSink &) = delete;
    virtual ~BlockSink() = default;

    /// All of it behind what is there, or false; then nothing of it stays.
    virtual bool append(ByteView bytes) = 0;
    /// Over what is there already.
    virtual bool overwrite(std::size_t offset, ByteView bytes) = 0;
    virtual bool sync() = 0; ///< what was appended survives a loss of power
    virtual qint64 freeBytes() const = 0; ///< on the disk; negative: unknown
    virtual bool isFull() const = 0; ///< the last failure was for want of room
    virtual QString systemText() const = 0; ///< the system's words for the last failure
};

/// A new file; one that is there already is left alone. nullptr, and the system's words, if it cannot be made.
std::unique_ptr<BlockSink> makeDiskSink(const QString &path, QString &systemText);

class RecordingFile {
public:
    struct Counts {
        std::uint64_t blocks = 0; ///< handed to the system: no crash of this program loses them
        std::uint64_t bytes = 0; ///< of the file
        std::uint64_t samples = 0; ///< in these blocks
        /// Of the file, when it was last synced: no loss of power loses them.
        std::uint64_t safeBytes = 0;
    };

    RecordingFile(std::unique_ptr<BlockSink> sink, recorded::Begin begin);

    /// Writes the head. False: see failure().
    bool open() { return write(m_encoder.head()); }
    /// True unless the recording is over now. An entry that fits no block is left out and counted.
    bool add(recorded::Nanos at, const recorded::Entry &entry);
    /// Writes what was gathered long enough at `now`.
    bool flush(recorded::Nanos now);
    bool flushAll();
    bool sync();
    /// The last block, and a last sync.
    bool end();

    bool isOver() const { return m_over; }
    const std::optional<recorded::End> &failure() const { return m_failure; }
    const Counts &counts() const { return m_counts; }
    std::uint64_t leftOut() const { return m_leftOut; } ///< entries that fit no block
    std::optional<recorded::Nanos> due() const { return m_encoder.due(); }
    qint64 freeBytes() const { return m_sink->freeBytes(); }
    /// Ends it, because there is hardly any room left: later there would be none for anything else either.
    void endForWantOfRoom();

private:
    bool writeBlocks();
    bool write(const recorded::Block &block);
    void fail();
    void markEnd(recorded::End end);

    std::unique_ptr<BlockSink> m_sink;
    recorded::Encoder m_encoder;
    Counts m_counts;
    std::uint64_t m_leftOut = 0;
    recorded::Nanos m_last = 0; ///< time of the newest entry
    bool m_over = false;
    std::optional<recorded::End> m_failure;
};

/// The sign that a recording is being written: a lock file beside it, "name.lock". It goes with the recorder, also
/// where a crash left it behind: then its process is no longer there. Where none can be made, nothing is known.
/// @param path  of a recording that is there, by whatever name
std::unique_ptr<QLockFile> recordingLock(const QString &path);

} // namespace session
