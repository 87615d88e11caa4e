#include "mcb/mapping.h"

namespace mcb {
namespace {

void addEntries(std::vector<MappingStep> &steps, std::uint16_t count,
    const std::vector<MappedRegister> &registers)
{
    std::uint16_t place = count;
    for (const MappedRegister &one : registers)
        steps.push_back({++place, {one.address, one.size}});
}

void addCounts(std::vector<MappingStep> &steps, std::size_t rx, std::size_t tx)
{
    steps.push_back({kRxCountRegister, {static_cast<std::uint16_t>(rx)}});
    steps.push_back({kTxCountRegister, {static_cast<std::uint16_t>(tx)}});
}

} // namespace

std::vector<MappingStep> stepsOf(const Mapping &mapping, bool clearCounts)
{
    std::vector<MappingStep> steps{{kStateRegister, {kConfigState}}};
    if (clearCounts)
        addCounts(steps, 0, 0);
    addEntries(steps, kRxCountRegister, mapping.rx);
    addEntries(steps, kTxCountRegister, mapping.tx);
    addCounts(steps, mapping.rx.size(), mapping.tx.size());
    steps.push_back({kStateRegister, {kCyclicState}});
    return steps;
}

} // namespace mcb
