// Words of tables and files, and what each stands for.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string_view>

template <class T>
struct Word {
    std::string_view text;
    T meaning;
};

/// What the word stands for; nullptr if it is not in the table.
template <class T, std::size_t N>
const T *findWord(const Word<T> (&words)[N], std::string_view text)
{
    const auto at = std::find_if(
        std::begin(words), std::end(words), [=](const Word<T> &one) { return one.text == text; });
    return at == std::end(words) ? nullptr : &at->meaning;
}
