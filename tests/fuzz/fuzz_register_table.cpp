// Any text as a register table: rows or one error, and every row that is accepted can be found again.
#include "catalog/catalog.h"
#include "fuzz/script.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char *>(data), size);
    auto table = catalog::readTable(text, "standard", 0x060400);
    if (!table)
        return 0;
    const catalog::Catalog made(std::move(*table), 1, {});
    for (const auto &info : made.registers())
        fuzz::require(made.find(made.withMotor(info, 1)) != nullptr);
    return 0;
}
