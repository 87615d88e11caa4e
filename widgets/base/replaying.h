// Whether what is connected is a recording: nothing of it can turn, be written or be armed.
#pragma once

#include "widgets/base/device.h"

namespace widgets {

inline bool replaying(const Device &device)
{
    return device.endpoint().kind == session::Endpoint::Kind::Trace;
}

} // namespace widgets
