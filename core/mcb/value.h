// Register values as words, and what GET INFO says of a register. Numbers go low word first; a slave or master that has
// words to spare fills them with anything, so only those that the size asks for are looked at.
#pragma once

#include "base/result.h"
#include "catalog/register_info.h"
#include "mcb/frame.h"

#include <optional>

namespace mcb {

enum class Type : std::uint8_t { Int16, UInt16, Int32, UInt32, Float, Text };
enum class Cyclic : std::uint8_t {
    ConfigOnly,
    Tx, ///< from the drive to the master
    Rx, ///< from the master to the drive
    Undefined
};

/// The answer to GET INFO: bits 0..7 size in bytes, 8..13 type, 14..15 cyclic, 16..18 access, the rest is masked.
struct Info {
    std::uint8_t size = 0; ///< bytes
    std::optional<Type> type; ///< empty: a number that the text does not name; its words stay words
    Cyclic cyclic = Cyclic::ConfigOnly;
    catalog::Access access = catalog::Access::None; ///< also for codes that the text does not name
    bool operator==(const Info &) const = default;
};

Info infoOf(const ConfigWords &config);
ConfigWords configOf(const Info &info);

/// The type as every protocol has it; Raw where the text does not name it.
catalog::ValueType valueTypeOf(const Info &info);

/// How many words a value of so many bytes takes.
constexpr std::size_t wordsOf(std::size_t bytes) { return (bytes + 1) / 2; }

enum class ValueError : std::uint8_t {
    TooShort, ///< fewer words than the size asks for
    WrongKind, ///< a number where a text is due, or the like
    WrongSize, ///< a type of a size that it cannot have
    OutOfRange, ///< does not fit
};

/// Which byte of a word has the first character of a text: drives differ.
enum class TextOrder : std::uint8_t { HighByteFirst, LowByteFirst };

/// A whole number, a float as double, a text up to its zero, or the bytes of an unknown type in the order of the line.
Result<catalog::Value, ValueError> decodeValue(
    const Info &info, WordView words, TextOrder order = TextOrder::HighByteFirst);

/// As many words as the register has. Texts are filled up with zeros and may fill it entirely; a double goes into a
/// float only, and must be finite.
Result<Words, ValueError> encodeValue(
    const Info &info, const catalog::Value &value, TextOrder order = TextOrder::HighByteFirst);

/// The words of the low `bytes` of a number, lowest first; up to 8 bytes.
Words wordsOfNumber(std::uint64_t number, std::size_t bytes);
/// The number of so many bytes; up to 8. @return  nothing if there are fewer words
std::optional<std::uint64_t> numberOf(WordView words, std::size_t bytes);

} // namespace mcb
