// What a drive knows of the board at its other end whatever the protocol: motors, registers, scales, limits, what it
// can do. Plain data; filled by the identification, read by the other parts.
#pragma once

#include "catalog/catalog.h"
#include "drive/event.h"
#include "drive/motion_limits.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace drive {

inline constexpr const char *kNoCurrentScale =
    "The board does not tell its current scale: enter it first.";
inline constexpr const char *kNoCycle =
    "Boards of this protocol take each set-point as a request of its own.";

/// All features, none of which is there.
inline std::vector<Capability> noFeatures(const std::string &reason)
{
    std::vector<Capability> all;
    for (std::size_t i = 0; i < kFeatures; ++i)
        all.push_back({static_cast<Feature>(i), false, reason});
    return all;
}

/// What a round of watched registers has read a moment ago. A parameter is not asked for once more before it is
/// written: only this drive writes it, and firmware leaves parameters alone.
struct LatelyRead {
    static constexpr Duration kHolds = std::chrono::milliseconds(250); ///< from `asked` on
    Value value;
    TimePoint asked; ///< when the question left: the value is no older
};

/// What Identified tells, and more. Its motors and knownFirmware are here until it is told.
struct BoardFacts : Identified {
    BoardFacts() { catalog = std::make_shared<const catalog::Catalog>(); }

    bool identified = false; ///< all the rest is known, as far as the board tells it
    bool knownFirmware = false;
    int motors = 1; ///< known of
    bool motorsCounted = false; ///< the board has told how many: there are no more
    std::vector<catalog::Scales> scales; ///< one a motor
    std::vector<bool> speedMeasured; ///< one a motor: by an encoder or Hall sensors
    std::set<RegisterId> missing; ///< of the catalogue, at one motor: another has it
    std::map<RegisterId, LatelyRead> lately; ///< since anything left that may change registers

    UserLimits user; ///< the user's; outlives the connection
    std::set<int> expert; ///< motors that the user moves without all limits known

    /// Another board may be there now; what the user allows holds for it, too.
    void forget()
    {
        const UserLimits allowed = user;
        *this = BoardFacts();
        user = allowed;
    }

    bool hasMotor(int motor) const { return motor >= 1 && motor <= motors; }

    /// Why this register is not there; empty if it is.
    std::string reasonWithout(RegisterId id) const
    {
        const auto *info = catalog->find(id);
        return info == nullptr                                  ? "no such register"
            : info->perMotor && !hasMotor(catalog->motorOf(id)) ? "no such motor"
            : missing.contains(id)                              ? "this motor does not have it"
                                                                : "";
    }

    MotorLimits limitsOf(int motor) const { return of(motor, limits); }

    MotionBounds boundsOf(int motor) const
    {
        return drive::boundsOf(limitsOf(motor), user, expert.contains(motor));
    }

    /// As in MotorStatus.
    std::optional<bool> measuresSpeed(int motor) const
    {
        return identified ? std::optional(of(motor, speedMeasured)) : std::nullopt;
    }

    double ampsPerDigit(int motor) const { return of(motor, scales).ampsPerDigit; }

    /// Why no current in A can be asked of the motor; empty if its scale is known.
    std::string reasonAgainstAmps(int motor) const
    {
        return ampsPerDigit(motor) > 0.0 ? std::string()
            : reasonAgainst(Feature::CurrentScale).empty()
            ? kNoCurrentScale
            : "the current scale of motor " + std::to_string(motor) + " is not known";
    }

    /// @param reason  why it is not there; empty: it is
    void tell(Feature feature, std::string reason)
    {
        capabilities.push_back({feature, reason.empty(), std::move(reason)});
    }
    /// Why a feature is not there; empty if it is.
    std::string reasonAgainst(Feature feature) const
    {
        const auto at = std::ranges::find(capabilities, feature, &Capability::feature);
        return at == capabilities.end() || at->available ? std::string() : at->reason;
    }

    /// Why these signals cannot be streamed; empty if they can. @param tick  what the fast rate counts
    std::string reasonAgainst(const Stream &stream, const std::string &tick) const
    {
        if (auto why = reasonAgainst(Feature::Stream); !why.empty())
            return why;
        if (stream.fastEvery < 1 || stream.fastEvery > 256)
            return "the fast rate is every 1st to 256th " + tick;
        for (const auto *list : {&stream.fast, &stream.slow}) {
            for (const RegisterId id : *list) {
                if (auto why = reasonWithout(id); !why.empty())
                    return catalog->nameOf(id) + ": " + why;
                if (catalog->find(id)->streaming == catalog::Streaming::Polled)
                    return catalog->nameOf(id) + ": cannot be streamed, only read";
            }
        }
        return {};
    }

private:
    template <class T>
    T of(int motor, const std::vector<T> &all) const
    {
        const auto at = static_cast<std::size_t>(motor - 1);
        return hasMotor(motor) && at < all.size() ? all[at] : T();
    }
};

} // namespace drive
