// What a register is, the group it stands in and the names of its values, in the user's language. The catalogue's own
// texts are English and serve as keys; names of registers, states and faults stay as the documents print them.
#pragma once

#include "catalog/names.h"
#include "catalog/register_info.h"

#include <QStringList>

#include <optional>

namespace widgets {

/// Mime type of registers that are dragged: a list of ids as JSON numbers.
inline constexpr char kRegisterMimeType[] = "application/x-rotorscope-registers";

/// A group that is not known keeps its name.
QString registerGroupText(const std::string &group);

/// One line, as long as it is; in English where there is no translation.
QString registerHelpText(const catalog::RegisterInfo &info);

/// Of an enumeration, a flag or a field of a structure; the name itself where there is no translation.
QString valueNameText(std::string_view name);
QStringList valueNameTexts(const std::vector<std::string> &names);

/// The value that the user means by `word`, in their language or in English; capitals do not matter.
std::optional<std::int64_t> valueNamed(
    std::span<const catalog::NamedValue> values, const QString &word);

} // namespace widgets
