// Fast channels as a 16-bit WAV file, for listening to torque ripple and for audio tools: a channel a signal, the codes
// as the board sent them, at the rate of the samples. Made piece by piece from a snapshot.
//
// WAV knows no gap and no unit. Where samples are missing the next ones follow at once, with a cue point that says how
// long the gap was; nothing is filled in. Names, units and factors stand in the INFO list as a comment. Only instants
// at which every channel has a sample are written. Source of the layout: RIFF, "Multimedia Programming Interface and
// Data Specifications 1.0" (IBM, Microsoft 1991).
#pragma once

#include "capture/capture.h"

#include <string>
#include <string_view>
#include <vector>

namespace capture {

/// Why signals do not fit a format. Nothing is written then.
enum class ExportProblem : std::uint8_t {
    None,
    NoFastSamples, ///< in the range, at which all fast signals have one
    DifferentRates, ///< in the range, of signals that have to share one
    TooManySignals, ///< in a WAV file more than 64
    TooLong, ///< 4 GiB is the end of a WAV file
};

class WavWriter {
public:
    /// So that the size of the file fits 32 bits, too: ten thousand gaps are marked with 600 KB.
    static constexpr std::uint64_t kMostDataBytes = 0xFFFFFFFFU - (1U << 20);

    /// @param channels  those that are not fast are left out
    explicit WavWriter(const Snapshot &channels, std::optional<TimeSpan> range = {});

    ExportProblem problem() const { return m_problem; }
    /// Shows the next piece, about 1 MiB, good until the following call. False when all is written, or with a problem.
    bool next(std::string_view &bytes);
    double progress() const; ///< 0..1

    std::uint64_t frames() const { return m_frames; } ///< instants in the file
    std::uint32_t rate() const { return m_rate; } ///< frames a second, rounded
    std::size_t gaps() const { return m_gaps.size(); }

private:
    struct Run { ///< instants that follow each other in every channel
        std::vector<Index> first; ///< one a channel
        std::uint64_t count = 0;
    };
    struct Gap {
        std::uint64_t frame = 0; ///< the first one behind it
        Nanos length = 0;
    };

    bool makePiece();
    bool findRate(Nanos from, Nanos to);
    void findRuns(Nanos from, Nanos to);
    void addRun(Nanos start, Run run);
    std::string head() const;
    std::string cues() const;
    std::string comment() const;

    Snapshot m_all;
    std::vector<const Channel *> m_channels;
    std::string m_piece; ///< shown last
    std::vector<Run> m_runs;
    std::vector<Gap> m_gaps;
    ExportProblem m_problem = ExportProblem::None;
    std::uint32_t m_rate = 0;
    std::uint64_t m_frames = 0;
    std::uint64_t m_written = 0; ///< frames
    Nanos m_end = 0; ///< behind the last run found
    std::size_t m_run = 0; ///< being written
    std::uint64_t m_inRun = 0;
    enum class Part : std::uint8_t { Head, Frames, Tail, Over } m_part = Part::Head;
};

} // namespace capture
