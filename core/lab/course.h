// What an experiment asks of a motor that turns at its first speed: a machine without I/O or bounds, which are the runner's.
#pragma once

#include "drive/wish.h"

#include <memory>
#include <optional>

namespace lab {

/// What can be asked of a drive, without who asked.
using Ask = decltype(drive::Wish::what);

class Course {
public:
    struct Moment {
        TimePoint now;
        std::optional<double> rpm, amps; ///< newest speed, and Iq over the newest packet
        bool answered = true; ///< what was asked for last
    };

    Course() = default;
    Course(const Course &) = delete;
    Course &operator=(const Course &) = delete;
    virtual ~Course() = default;

    /// Looked at with every packet of samples, every answer, and when due() is there.
    /// @return  what is to be asked now, a speed or a torque; nothing: it waits
    virtual std::optional<Ask> next(const Moment &moment) = 0;
    virtual TimePoint due() const = 0;
    virtual bool over() const = 0;
};

} // namespace lab
