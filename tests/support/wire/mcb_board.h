// What a drive on the Motion Control Bus gives for its registers, by the text of the protocol alone: in answers to
// questions for a value, and in the words that travel with every frame by the mapping that was switched on. It sees the
// line at the drive's end; what was lost on the way is not taken. Registers are numbered as address << 3 | 1: there is
// one motor.
#pragma once

#include "base/bytes.h"
#include "support/wire/given_values.h"

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

namespace judge {

/// A register by the names of newer dictionaries: 16 bits, 32 with a sign, or a real number.
struct McbRegister {
    enum class Type : std::uint8_t { Word, Whole, Real };
    std::string_view name;
    std::uint16_t address = 0;
    double factor = 1.0; ///< of its unit to the shown one
    Type type = Type::Real;
};
const McbRegister *findMcbRegister(std::string_view name); ///< nullptr: not known to the judge

class McbBoard {
public:
    void reset(); ///< the drive began anew
    /// A frame. @param arrives  false: lost on the way
    void asks(ByteView bytes, bool arrives);
    /// In pieces. @param arrives  false: lost on the way
    void says(ByteView bytes, TimePoint at, bool arrives);

    const GivenValues &given() const { return m_given; }

private:
    struct Entry {
        unsigned address = 0, words = 0;
    };
    std::vector<Entry> mapped() const;
    void accept(ByteView bytes, TimePoint at);
    void keep(unsigned address, unsigned low, unsigned high, TimePoint at);

    std::map<unsigned, unsigned> m_list; ///< of the mapping, as it was written
    std::map<unsigned, bool> m_due; ///< a question for its value has no answer yet
    std::size_t m_length = 0; ///< of the frame that left last, and so of the answer
    bool m_arrives = true;
    Bytes m_said;
    GivenValues m_given;
};

} // namespace judge
