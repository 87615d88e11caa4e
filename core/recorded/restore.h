// From the entries of a recording to a capture, by the same calls that live samples take.
#pragma once

#include "capture/capture.h"
#include "recorded/entry.h"

#include <map>

namespace recorded {

class Restorer {
public:
    explicit Restorer(capture::Capture &capture)
        : m_capture(capture)
    {
    }

    /// Layouts, samples and polled values go into the capture; everything else is passed over.
    void accept(const Entry &entry);

private:
    capture::Capture &m_capture;
    std::map<RegisterId, PolledRegister> m_polled;
};

} // namespace recorded
