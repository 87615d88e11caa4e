// RecordingTap: takes what a session does for a recording, before anything is dropped for display. It stands in the
// session's thread and never waits: entries are told to the recorder, and while more than the bound wait there, because
// the disk is slow, further ones are dropped, counted, and told as Lost.
// The session tells it as it tells each SessionTap, and knows nothing of recordings.
#pragma once

#include "recorded/drive_entries.h"
#include "session/recording/session_tap.h"

#include <QMetaType>
#include <QObject>

#include <atomic>
#include <memory>

namespace session {

/// Entries of one moment; immutable, so that they may cross threads.
struct Told {
    unsigned recording = 0; ///< number of the recording they are for
    recorded::Nanos at = 0;
    std::vector<recorded::Entry> entries;
    std::size_t bytes = 0; ///< about what they hold in memory
};
using ToldPtr = std::shared_ptr<const Told>;

class RecordingTap : public QObject, public SessionTap {
    Q_OBJECT
public:
    enum class Content : std::uint8_t { Samples, SamplesAndLink };

    explicit RecordingTap(std::size_t mostWaiting = std::size_t{64} << 20)
        : m_mostWaiting(mostWaiting)
    {
    }

    // In any thread.
    /// From now on entries go to this recording; what holds already is told first, with the next thing that happens.
    void switchOn(unsigned recording, Content content);
    void switchOff() { m_recording = 0; }
    /// So much has been written or thrown away.
    void release(std::size_t bytes) { m_waiting -= bytes; }
    std::size_t waiting() const { return m_waiting; } ///< bytes
    /// The session's, before anything else.
    void setClock(Clock clock) { m_clock = std::move(clock); }
    /// In a thread that may read the session's clock: UTC of the session's 0 s, whole seconds. Asked for when something
    /// begins to be kept, because that clock stands still while the computer sleeps, and UTC may be set.
    std::int64_t startSeconds() const;

    // In the session's thread.
    void onEvent(const drive::Event &event, TimePoint now) override;
    void onWish(const drive::Wish &wish, TimePoint now) override;
    void onStop(TimePoint now) override { tell({recorded::DriveEntries::stop()}, now); }
    void onLink(recorded::LinkBytes::Direction direction, ByteView bytes, TimePoint now) override;

Q_SIGNALS:
    /// Connect it queued, or to what may be called in the session's thread.
    void told(const session::ToldPtr &told);
    /// What was told is to be taken now: a quarter of what may wait does, or the recording ended meanwhile, so that
    /// nothing else would take it. Connect it queued.
    void dueNow();

private:
    bool isOn() const { return m_recording != 0; }
    void tell(std::vector<recorded::Entry> entries, TimePoint now);
    void send(std::vector<recorded::Entry> entries, std::size_t bytes, TimePoint now);
    void drop(const std::vector<recorded::Entry> &entries);
    void addUntold(std::vector<recorded::Entry> &entries);

    const std::size_t m_mostWaiting;
    std::atomic<unsigned> m_recording = 0; ///< 0: off
    std::atomic<Content> m_content = Content::Samples;
    std::atomic<std::size_t> m_waiting = 0;
    Clock m_clock;

    // Of the session's thread:
    recorded::DriveEntries m_entries;
    unsigned m_toldState = 0; ///< the recording that was told what held when it began
    recorded::Lost m_lost; ///< not told yet
    std::vector<recorded::Entry> m_untold; ///< descriptions that got lost; what follows needs them
    std::int64_t m_streamEnd = 0; ///< tick behind the last block handed on
    std::uint32_t m_step = 1;
    bool m_dropping = false;
};

/// Parts whose session tells the tap, too, which takes their clock.
Parts tapped(const Parts &parts, const std::shared_ptr<RecordingTap> &tap);

} // namespace session

Q_DECLARE_METATYPE(session::ToldPtr)
