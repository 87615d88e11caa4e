// ReplayDrive: a recording as a drive. Its line carries the bytes of the file: it asks for a piece (four bytes, little-
// endian, how many, and before the first piece of a new start eight more, from which byte on) and is given it; an empty
// piece is the end of the file. What was told then is told again in the pace of the recording, on the axis of now, so
// that everything behind a drive works as with a board: store, scope, trigger, another recording.
//
// Going forward in the file tells what lies between as fast as it is taken; going back begins anew and does the same,
// behind what was told: the axis of now has no way back.
//
// It never writes and moves nothing: it cannot be armed, and what would write or move ends NotSent with the reason.
// Values come in the units of the recording; what it does not hold (access, meaning, limits) is not made up.
#pragma once

#include "drive/drive.h"
#include "recorded/decoder.h"

#include <limits>
#include <map>
#include <utility>

namespace recorded {

struct ReplayPace {
    double speed = 1.0; ///< recorded seconds a second; 0: as fast as it is taken
    bool paused = false;
};

struct ReplayProgress {
    Nanos position = 0; ///< recorded time that has been told
    std::uint64_t bytes = 0; ///< of the file, up to there
    std::uint64_t damagedPlaces = 0;
    bool ended = false;
};

/// The observer of a replay; called in the drive's thread.
class ReplayControl {
public:
    ReplayControl() = default;
    ReplayControl(const ReplayControl &) = delete;
    ReplayControl &operator=(const ReplayControl &) = delete;
    virtual ~ReplayControl() = default;

    virtual ReplayPace pace() const = 0;
    /// What was handed is not taken: nothing more is told for now, and nothing is lost by it.
    virtual bool full() const = 0;
    /// A place of the file to go to, in bytes; asked for once, and then it is on its way.
    virtual std::optional<std::uint64_t> takeSeek() { return std::nullopt; }
    virtual void handed(std::uint64_t values) = 0; ///< so many samples and readings were just told
    /// What no event of a drive says: a happening, a note, the end. `at` is on the axis of now.
    virtual void told(Nanos at, const Entry &entry) = 0;
    virtual void progressed(const ReplayProgress &progress) = 0;
};

class ReplayDrive : public drive::Drive {
public:
    static constexpr std::uint32_t kPiece = 1 << 18; ///< bytes asked for at a time
    /// Of a recording that says nothing for longer.
    static constexpr Nanos kLongestPause = 2'000'000'000;

    /// @param control  outlives it; nullptr: the pace of the recording
    explicit ReplayDrive(ReplayControl *control = nullptr)
        : m_control(control)
    {
    }

    void connect(TimePoint now) override;
    void disconnect(TimePoint now) override;
    void receive(ByteView bytes, TimePoint now) override;
    void handleTimeout(TimePoint now) override { advance(now); }
    void handleSent(TimePoint) override { }
    std::vector<Output> takeOutput() override { return std::exchange(m_output, {}); }
    std::vector<drive::Event> takeEvents() override { return std::exchange(m_events, {}); }
    std::optional<TimePoint> nextTimeout() const override;
    void submit(drive::Wish wish, TimePoint now) override;
    void stop(TimePoint) override { } ///< nothing moves
    bool stopOpen() const override { return false; }
    void remember(const drive::LineMemory &) override { }
    drive::LineMemory memory() const override { return {}; }
    void arm() override { }
    void disarm() override { }
    bool armed() const override { return false; }

private:
    void advance(TimePoint now);
    bool fetch(TimePoint now);
    void ask();
    void seek(std::uint64_t place, TimePoint now);
    bool hurries() const { return m_progress.bytes < m_hurryTo; }
    void keep(Item item);
    bool isDue();
    void play(const Item &item);
    void play(capture::StreamLayout layout);
    void play(capture::SampleBlock block);
    void play(const PolledRegister &polled);
    void play(const PolledValues &values);
    void play(Nanos at, const Happening &happening);
    void playStatus(Nanos at, const Happening &happening);
    void describe(RegisterId id, const std::string &name, const std::string &unit, bool streamed);
    void identify();
    void read(const drive::Read &wish);
    void end(TimePoint now);
    void report(TimePoint now, bool always);
    ReplayPace pace() const { return m_control ? m_control->pace() : ReplayPace{}; }
    TimePoint axis(Nanos recorded) const { return TimePoint(Duration(recorded + m_shift)); }

    ReplayControl *m_control;
    Decoder m_decoder;
    std::vector<Output> m_output;
    std::vector<drive::Event> m_events;
    std::multimap<Nanos, Item> m_pending; ///< decoded and not told, by time
    std::optional<Item> m_last; ///< the end, until all else was told
    capture::StreamLayout m_layout; ///< of the samples that are decoded next
    Nanos m_samplesUntil = std::numeric_limits<Nanos>::min(); ///< of those in m_pending
    bool m_open = false;
    bool m_asked = false; ///< for a piece that has not come
    bool m_met = false; ///< told that it is there
    bool m_anew = false; ///< the next piece is the first of the file
    bool m_dropPiece = false; ///< the one that comes is of before a new start
    std::uint64_t m_hurryTo = 0; ///< bytes of the file up to which no pace is kept
    std::optional<Nanos> m_toldUntil; ///< on the axis of now
    bool m_fed = false; ///< all of the file is in the decoder
    bool m_ended = false; ///< and told
    bool m_identifiable = false; ///< something is in the catalog that the board was not told with
    bool m_limited = false; ///< stopped by a bound, not for want of time
    std::uint64_t m_told = 0; ///< values, in this turn
    TimePoint m_now{};
    std::optional<Nanos> m_first; ///< recorded time of the first entry
    Nanos m_position = 0; ///< recorded time that is due
    Nanos m_shift = 0; ///< from recorded time to the axis of now
    drive::Identity m_identity;
    double m_tickHz = 0.0;
    std::map<RegisterId, catalog::RegisterInfo> m_registers; ///< by id without motor
    std::map<RegisterId, drive::Reading> m_values; ///< the newest of each
    std::map<RegisterId, bool> m_polled; ///< registers that were described as polled
    ReplayProgress m_progress;
    TimePoint m_reported{};
};

} // namespace recorded
