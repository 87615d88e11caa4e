// Values of JSON files, read as what they should be: files are foreign.
#pragma once

#include <QJsonValue>
#include <QLatin1String>

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace session {

/// A whole number within the range; empty for any other, and for NaN, which stands for a member that is none.
template <class Number>
std::optional<Number> wholeIn(double value, double least, double most)
{
    if (!(value >= least && value <= most) || value != std::nearbyint(value))
        return std::nullopt;
    return static_cast<Number>(value);
}

/// What the word stands for in the table; empty if it is not in it.
template <class T, std::size_t N>
std::optional<T> meaningIn(const std::pair<const char *, T> (&table)[N], const QString &word)
{
    for (const auto &[text, meaning] : table)
        if (word == QLatin1String(text))
            return meaning;
    return std::nullopt;
}

} // namespace session
