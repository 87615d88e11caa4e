// A value or the reason why there is none. The one place to change when std::expected is everywhere.
#pragma once

#include <tl/expected.hpp>

template <class T, class E>
using Result = tl::expected<T, E>;

template <class E>
constexpr auto fail(E error)
{
    return tl::unexpected<E>(error);
}
