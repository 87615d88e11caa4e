// Coverage: from when to when a recording has the samples of each signal, told from its entries as they are written.
// With it a capture can be asked whether all of it is in the file, without reading the file. It knows no file and no
// clock.
#pragma once

#include "capture/capture.h"
#include "recorded/entry.h"

#include <map>
#include <utility>

namespace recorded {

class Coverage {
public:
    /// An entry that was written. Costs a look-up a signal and block.
    void accept(const Entry &entry);
    /// True if every sample of a board in it lies within what was written of its signal. What was computed from such
    /// samples does not count. A capture whose clock was moved, because a board began to count anew, is never held.
    bool holds(const capture::Capture &capture) const;

private:
    struct Span {
        Nanos first = 0;
        Nanos last = 0;
    };
    void extend(RegisterId id, capture::ChannelInfo::Kind kind, Nanos first, Nanos last);
    void accept(const capture::SampleBlock &block);

    capture::StreamLayout m_layout;
    std::map<std::pair<RegisterId, capture::ChannelInfo::Kind>, Span> m_spans;
};

} // namespace recorded
