// What a board of the older serial protocol gives for its registers when it is asked, by the text of the protocol
// alone. It sees the line at the board's end; what was lost on the way is not taken. Registers are numbered as number
// << 3 | motor. Frames and answers: mcp-legacy, sections 1 to 4.
#pragma once

#include "base/bytes.h"
#include "support/wire/given_values.h"

#include <optional>
#include <string_view>

namespace judge {

/// A register by the protocol's table.
struct FcpRegister {
    std::string_view name;
    std::uint8_t number = 0;
    bool isSigned = true;
    bool plain = true; ///< a digit is one of what it is in; else of the board's own scale
};
const FcpRegister *findFcpRegister(std::string_view name); ///< nullptr: not known to the judge

class FcpBoard {
public:
    void reset(); ///< the board began anew
    /// @param arrives  false: lost on the way
    void asks(ByteView bytes, bool arrives);
    void says(ByteView bytes, TimePoint at, bool arrives);

    const GivenValues &given() const { return m_given; }

private:
    /// Of one direction: code, length, so many bytes, check.
    struct Frame {
        Bytes bytes;
        bool arrives = true;
        /// True if it is whole with this byte.
        bool accept(std::uint8_t byte, bool arrived);
        void clear() { *this = {}; }
    };

    Frame m_asked, m_said;
    std::optional<std::uint16_t> m_due; ///< register that the next answer is about
    GivenValues m_given;
};

} // namespace judge
