#include "drive/mcb/mcb_set_points.h"

#include "drive/mcb/mcb_protocol.h"

namespace drive {

std::vector<mcb::MappedRegister> McbSetPoints::entries() const
{
    std::vector<mcb::MappedRegister> entries;
    for (const std::uint16_t address : {mcbreg::kVelocity, mcbreg::kIq, mcbreg::kId}) {
        const mcb::Info *info = m_board.infoOf(address);
        // Readable, because what goes out is read back.
        if (info != nullptr && info->cyclic == mcb::Cyclic::Rx && m_board.readable(address)
            && m_board.writable(address))
            entries.push_back({address, info->size});
    }
    return entries;
}

mcb::Words McbSetPoints::output(const std::vector<mcb::MappedRegister> &rx) const
{
    mcb::Words output;
    for (const mcb::MappedRegister &entry : rx) {
        mcb::Words words = of(entry.address);
        words.resize(mcb::wordsOf(entry.size));
        output.insert(output.end(), words.begin(), words.end());
    }
    return output;
}

} // namespace drive
