// What a wish says for the motion log.
#pragma once

#include "catalog/catalog.h"
#include "drive/motion_record.h"
#include "drive/wish.h"

#include <optional>

namespace drive {

/// The record that a wish begins; empty for wishes that move nothing and can harm nothing.
std::optional<MotionRecord> motionOf(
    const Wish &wish, const catalog::Catalog &catalog, TimePoint now);

/// Notes a request that leaves for the act and can change something.
void noteSent(MotionRecord &record, ByteView request);

} // namespace drive
