// Light and dark: Fusion with a palette of our own, so that every desktop shows the same window.
#pragma once

#include <QPalette>

#include <cstdint>

namespace widgets {

enum class Theme : std::uint8_t { System, Light, Dark };

QPalette lightPalette();
QPalette darkPalette();

/// Applies a theme to the application. System: dark if the desktop's own palette was dark when the program began.
void applyTheme(Theme theme);

} // namespace widgets
