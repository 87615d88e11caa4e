#include "recorded/restore.h"

namespace recorded {

void Restorer::accept(const Entry &entry)
{
    if (const auto *layout = std::get_if<capture::StreamLayout>(&entry)) {
        m_capture.begin(*layout);
    } else if (const auto *block = std::get_if<capture::SampleBlock>(&entry)) {
        m_capture.append(*block);
    } else if (const auto *polled = std::get_if<PolledRegister>(&entry)) {
        if (m_polled.size() < kMostRegisters)
            m_polled[polled->id] = *polled;
    } else if (const auto *values = std::get_if<PolledValues>(&entry)) {
        for (const PolledValue &value : values->values) {
            const auto found = m_polled.find(value.id);
            if (found != m_polled.end() && value.at > -kFarthest && value.at < kFarthest)
                m_capture.appendPolled(value.id, found->second.name, found->second.unit,
                    capture::toSeconds(value.at), value.value, capture::Capture::Asked::Aside);
        }
    }
}

} // namespace recorded
