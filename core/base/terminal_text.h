// Text from elsewhere (a board, a file, another program) made harmless for a terminal: no byte of it can move the
// cursor, change a title or colour, reorder a line or begin another one. It changes nothing that the user can see.
#pragma once

#include <string>
#include <string_view>

/// One line: control characters become spaces; characters that only format (directions, zero widths), line separators
/// and bytes that are no UTF-8 become U+FFFD. Everything else stays byte for byte. Cost: O(bytes).
std::string terminalText(std::string_view utf8);

/// The same for finished JSON, which stays the same JSON: what JSON lets stand within a text and a terminal obeys is
/// written as \uXXXX.
std::string terminalJson(std::string_view json);
