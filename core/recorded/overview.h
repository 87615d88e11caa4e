// Overview: the extremes of a stream's fast signals over equal stretches of time, for the whole picture of a recording
// before its samples are read. The recorder writes it before the end; a reader that does not know it skips it. Slow and
// polled values are not in it.
#pragma once

#include "capture/capture.h"
#include "capture/min_max_kernel.h"
#include "recorded/entry_codec.h"

namespace recorded {

/// Of the time under one layout.
struct Overview {
    capture::StreamLayout layout;
    capture::Tick first = 0;
    capture::Tick binTicks = 2; ///< of a stretch; even
    /// In the layout's order, as many bins each; nothing() in gaps.
    std::vector<std::vector<capture::CodeRange>> columns;

    std::size_t bins() const { return columns.empty() ? 0 : columns.front().size(); }
};

/// The payload of a block. As with encodeEntry(), it fails with TooLong only.
Result<Bytes, PayloadError> encodeOverview(const Overview &overview);
/// UnknownKind: something else.
Result<Overview, PayloadError> decodeOverview(ByteView payload);

/// Two samples a bin, its least and its greatest, so that a picture of all of it has every peak. Their names say that
/// they are no samples of the board's.
void restore(const Overview &overview, capture::Capture &capture);

/// Gathers overviews from the entries of a recording, in a bounded room.
class OverviewMaker {
public:
    void begin(const capture::StreamLayout &layout);
    void add(const capture::SampleBlock &block);
    /// @param mostBytes  all of them together; none where they would not say much in so few
    std::vector<Overview> take(std::size_t mostBytes);

private:
    std::vector<Overview> m_all;
    bool m_tooMany = false;
};

} // namespace recorded
