#include "mcb/fragments.h"

#include <algorithm>

namespace mcb {

std::vector<Frame> fragmentsOf(std::uint16_t address, Command command, WordView words)
{
    std::vector<Frame> frames;
    do {
        const std::size_t count = std::min(words.size(), kConfigWords);
        Frame frame{address, command, count < words.size(), {}, {}};
        std::copy_n(words.begin(), count, frame.config.begin());
        frames.push_back(frame);
        words = words.subspan(count);
    } while (!words.empty());
    return frames;
}

Gatherer::Added Gatherer::add(const Frame &fragment)
{
    if (!m_open || fragment.address != m_address)
        m_words.clear();
    m_address = fragment.address;
    m_open = false;
    if (m_words.size() + kConfigWords > kMostValueWords)
        return Added::TooLong;
    m_words.insert(m_words.end(), fragment.config.begin(), fragment.config.end());
    m_open = fragment.pending;
    return m_open ? Added::More : Added::Whole;
}

void Gatherer::clear()
{
    m_open = false;
    m_words.clear();
}

} // namespace mcb
