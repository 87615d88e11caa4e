// What an opened recording holds of registers, as text: most of it is never looked at.
#pragma once

#include "session/recording/recording_reader.h"

namespace widgets {

struct RecordedSnapshots {
    QString path; ///< of the recording
    std::vector<session::RecordingReport::At<record::RegisterSnapshot>> all;
};

} // namespace widgets
