// What a wish says for the motion log, and which requests belong into it.
#pragma once

#include "drive/mcp_board.h"
#include "drive/motion_record.h"

#include <optional>

namespace drive {

/// The record that a wish begins; empty for wishes that move nothing and can harm nothing.
std::optional<MotionRecord> motionOf(const Wish &wish, const McpBoard &board, TimePoint now);

/// Notes a request that leaves for the act; those that only read are passed over.
void noteSent(MotionRecord &record, ByteView request);

} // namespace drive
