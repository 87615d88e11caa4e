// The fields of a plan by their names, each said once in its plan's eachField(): how a recording holds it. A file of a
// plan is read more strictly (lab/plan_file.h).
#pragma once

#include "lab/happenings.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

namespace lab {

constexpr int kMostRepeats = 100; ///< of the steps of a plan
constexpr double kLeastMargin_rpm = 120.0; ///< noise of a sensorless speed

/// Puts fields into an entry.
class PutFields {
public:
    explicit PutFields(recorded::Happening &into)
        : m_into(into)
    {
    }
    void operator()(const char *name, double value) { put(name, decimalText(value)); }
    void operator()(const char *name, int value) { put(name, std::to_string(value)); }
    void operator()(const char *name, std::uint32_t value) { put(name, std::to_string(value)); }
    void operator()(const char *name, std::chrono::milliseconds value)
    {
        put(name, std::to_string(value.count()));
    }

private:
    void put(const char *name, std::string text)
    {
        m_into.fields.emplace_back(name, std::move(text));
    }
    recorded::Happening &m_into;
};

template <class Plan>
void putFields(recorded::Happening &into, Plan plan)
{
    PutFields put(into);
    eachField(plan, put);
}

/// Takes fields out of one; what it does not have stays as it is. Whole numbers beyond a million are a million.
class TakeFields {
public:
    explicit TakeFields(const recorded::Happening &from)
        : m_from(from)
    {
    }
    void operator()(const char *name, double &value)
    {
        if (const auto number = numberOf(m_from, name))
            value = *number;
    }
    void operator()(const char *name, int &value)
    {
        constexpr double kMost = 1e6;
        const auto number = numberOf(m_from, name);
        if (number && *number == std::round(*number))
            value = static_cast<int>(std::clamp(*number, -kMost, kMost));
    }
    void operator()(const char *name, std::uint32_t &value)
    {
        int whole = static_cast<int>(value);
        (*this)(name, whole);
        value = static_cast<std::uint32_t>(std::max(0, whole));
    }
    void operator()(const char *name, std::chrono::milliseconds &value)
    {
        int whole = static_cast<int>(value.count());
        (*this)(name, whole);
        value = std::chrono::milliseconds(whole);
    }

private:
    const recorded::Happening &m_from;
};

} // namespace lab
