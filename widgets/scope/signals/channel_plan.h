// Which of the wanted signals the board can record, at what rate, and which have to be read one by one: a plan made
// from the limits of board and link before anything is sent. Pure: values in, values out.
#pragma once

#include "catalog/catalog.h"
#include "drive/event.h"
#include "drive/wish.h"

#include <span>
#include <string>
#include <vector>

namespace widgets {

enum class Route : std::uint8_t {
    Fast, ///< recorded by the board, one sample a control period (or every n-th)
    Slow, ///< recorded by the board, once for many fast samples
    Polled, ///< read one by one, as often as the link allows
};

struct WantedSignal {
    catalog::RegisterId id = 0;
    Route route = Route::Fast; ///< wished for
    int plot = 0; ///< where the scope shows it
};

/// The same by name, before a board is there that has it.
struct NamedSignal {
    std::string name; ///< as Catalog::resolve() takes it
    Route route = Route::Fast;
    int plot = 0;
    bool operator==(const NamedSignal &) const = default;
};

/// Why a signal does not go the way that was wished for.
enum class Detour : std::uint8_t { None, NotStreamable, TooManySignals, LinkFull };

struct PlannedSignal {
    catalog::RegisterId id = 0;
    Route route = Route::Fast;
    Detour detour = Detour::None;
};

struct ChannelPlan {
    drive::Stream stream;
    std::vector<catalog::RegisterId> polled;
    std::vector<PlannedSignal> signalList; ///< in the order wanted
    bool rateLowered = false; ///< the rate wished for does not fit the link
    double fastHz = 0.0; ///< samples a second of each fast signal
    double bytesPerSecond = 0.0; ///< of the stream, framing included
    double share = 0.0; ///< of the link, 0 to 1
    double fullRateBytes = 0.0; ///< a second, of the signals wanted at the rate wished for
    double packetSeconds = 0.0; ///< from one packet to the next; 0: nothing is streamed
    unsigned fitAtFullRate = 0; ///< fast signals that the link carries at every control period
};

/// Slow signals are recorded once for so many fast samples.
inline constexpr unsigned kSlowEvery = 16;
/// Part of the link that a stream may take; the rest is for stopping, states and values.
inline constexpr double kStreamShare = 0.92;

/// @param fastEvery  control periods a fast sample, 1..256; raised to the next power of two that fits the link
ChannelPlan planChannels(std::span<const WantedSignal> wanted, const catalog::Catalog &catalog,
    const drive::StreamLimits &limits, unsigned fastEvery);

/// Bytes a second that a stream takes, framing included.
double streamBytesPerSecond(const drive::Stream &stream, const catalog::Catalog &catalog,
    const drive::StreamLimits &limits);

} // namespace widgets
