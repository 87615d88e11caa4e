// The upper halves of the processor's 256-bit registers. What is left in them makes each SSE instruction wait for the
// one that wrote its register before, and plain code is made of those: it runs two to four times slower (measured on an
// AMD EPYC) until they are cleared. Qt 6.4 leaves something there whenever it fills pixels (QPixmap::fill(), lines,
// rectangles; seen with XGETBV), so long computations in a thread that paints begin with this.
#pragma once

namespace widgets {

/// Clears them: one instruction. Nothing where the processor or the compiler has none.
void clearWideRegisters();

} // namespace widgets
