#include "widgets/scope/drawing/wide_registers.h"

#if (defined(__x86_64__) || defined(__i386__)) && (defined(__GNUC__) || defined(__clang__))
#define ROTORSCOPE_WIDE_REGISTERS
#include <immintrin.h>
#endif

namespace widgets {

#ifdef ROTORSCOPE_WIDE_REGISTERS
namespace {
__attribute__((target("avx"))) void clear() { _mm256_zeroupper(); }
} // namespace

void clearWideRegisters()
{
    static const bool there = __builtin_cpu_supports("avx") != 0;
    if (there)
        clear();
}
#else
void clearWideRegisters() { }
#endif

} // namespace widgets
