#include "base/text.h"

#include <limits>
#include <locale>
#include <sstream>

namespace {

bool isDigit(char one) { return one >= '0' && one <= '9'; }

/// @param word  in small letters
bool beginsWith(std::string_view text, std::string_view word)
{
    return text.size() >= word.size()
        && std::equal(word.begin(), word.end(), text.begin(),
            [](char small, char one) { return one == small || one == small - 'a' + 'A'; });
}

const char *digitsEnd(const char *first, const char *last)
{
    return std::find_if_not(first, last, isDigit);
}

/// The end of the longest number without a sign that begins here; `first` if there is none.
const char *endOfNumber(const char *first, const char *last)
{
    const char *end = digitsEnd(first, last);
    bool any = end != first;
    if (end != last && *end == '.') {
        const char *const behind = digitsEnd(end + 1, last);
        any = any || behind != end + 1;
        end = behind;
    }
    if (!any)
        return first;
    if (end == last || (*end != 'e' && *end != 'E'))
        return end;
    const char *power = end + 1;
    if (power != last && (*power == '+' || *power == '-'))
        ++power;
    const char *const behind = digitsEnd(power, last);
    return behind != power ? behind : end;
}

} // namespace

std::from_chars_result decimalOfStream(const char *first, const char *last, double &value)
{
    using Limits = std::numeric_limits<double>;
    const char *const begin = first != last && *first == '-' ? first + 1 : first;
    constexpr Word<double> kWords[] = {{"infinity", Limits::infinity()},
        {"inf", Limits::infinity()}, {"nan", Limits::quiet_NaN()}};
    for (const auto &[word, meaning] : kWords) {
        if (beginsWith({begin, last}, word)) {
            value = begin == first ? meaning : -meaning;
            return {begin + word.size(), std::errc{}};
        }
    }
    const char *const end = endOfNumber(begin, last);
    if (end == begin)
        return {first, std::errc::invalid_argument};
    std::istringstream in(std::string(first, end));
    in.imbue(std::locale::classic());
    double read = 0.0;
    if (!(in >> read))
        return {end, std::errc::result_out_of_range};
    value = read;
    return {end, std::errc{}};
}
