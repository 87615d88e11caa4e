// Opens a recording: its samples into a capture, by the calls that live samples take, and a report of everything else
// in it and of what is missing. Reads piece by piece: a file of any size takes the memory of its samples only.
#pragma once

#include "base/result.h"
#include "capture/capture.h"
#include "recorded/decoder.h"

#include <QString>

#include <functional>
#include <utility>

namespace session {

struct RecordingReport {
    /// When, and what.
    template <class T>
    using At = std::pair<recorded::Nanos, T>;
    recorded::Begin begin;
    std::vector<At<recorded::Happening>> happenings;
    std::vector<At<recorded::RegisterSnapshot>> snapshots;
    /// As they were said last, by their time; without those taken back.
    std::vector<recorded::Note> notes;
    recorded::Lost lost; ///< in all: what the disk was too slow for
    std::uint64_t linkBytes = 0;
    std::uint64_t samples = 0;
    std::uint64_t blocks = 0; ///< sound ones
    qint64 bytes = 0; ///< of the file that were read
    std::vector<recorded::Damage> damage; ///< the first kMostDamage places
    std::uint64_t damagedPlaces = 0; ///< all of them
    std::optional<recorded::End> ending; ///< empty: the recorder was interrupted
    std::uint64_t leftOut = 0; ///< happenings, snapshots and notes that there was no room for

    static constexpr std::size_t kMostDamage = 1000;
    /// Memory for happenings, snapshots and notes together. A recording of a long day has a few mebibytes of them; the
    /// count alone is no bound, for one may hold a mebibyte.
    static constexpr std::size_t kMostKeptBytes = std::size_t{64} << 20;
};

/// Reads the whole file. The capture should be empty; what cannot be read is left out of it, never guessed.
/// @param proceed  called with 0..1 about every mebibyte; false cancels
/// @return  the report, or in the system's or our own words why there is nothing to read
Result<RecordingReport, QString> readRecording(const QString &path, capture::Capture &capture,
    const std::function<bool(double)> &proceed = {});

/// The same, with the entries themselves, in the file's order.
Result<RecordingReport, QString> readRecording(const QString &path,
    const std::function<void(recorded::Item &&)> &take,
    const std::function<bool(double)> &proceed = {});

/// What its recorder summed up at its end into the capture, which should be empty: the picture of all of it, with its
/// peaks, of its fast signals. False: there is no such thing, or it is damaged. Reads what it needs and no samples.
bool readOverview(const QString &path, capture::Capture &capture);

/// One place of damage in English, e.g. "bytes 4096 to 8191 are unreadable, 2 blocks are missing".
QString damageText(const recorded::Damage &damage);

} // namespace session
