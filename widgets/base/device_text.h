// Text that came from a device or from a file, made fit to be shown: bounded, in one line, without characters that
// hide or reorder others. It is plain text still: labels that show it are set to Qt::PlainText, tool tips escape it.
#pragma once

#include <QString>

#include <string>
#include <string_view>
#include <vector>

class QLabel;
class QWidget;

namespace widgets {

/// Shows at most so many characters of a device's text.
inline constexpr int kDeviceTextLength = 64;

/// `text` as one line: invalid UTF-8 replaced, control and direction-changing characters written as \uXXXX (a tab as a
/// space), cut with an ellipsis after kDeviceTextLength characters.
QString deviceText(std::string_view text);
QString deviceText(const QString &text);

/// Names that a device has for several things, in one line with commas between.
QString deviceNames(const std::vector<std::string> &names);

/// The name of a file, without its folder.
QString fileNameText(const QString &path);

/// deviceText() for a place that takes rich text (tool tips guess): escaped.
QString deviceToolTip(std::string_view text);

/// Plain text as a tool tip, which would guess whether it is rich text.
QString plainToolTip(const QString &text);

/// A label that takes no text for HTML, in as many lines as it needs.
QLabel *wrappedLabel(const char *objectName, QWidget *parent);

} // namespace widgets
