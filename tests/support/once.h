// A condition that holds from the first time it was true: QTRY_VERIFY asks again after it has seen what it waits for,
// when another thread may have gone on.
#pragma once

namespace support {

template <class Condition>
auto once(Condition condition)
{
    return [condition, seen = false]() mutable { return seen = seen || condition(); };
}

} // namespace support
