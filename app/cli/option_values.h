// What the options of a command are, and their values as they were typed.
#pragma once

#include "output.h"

#include <QCommandLineParser>

#include <optional>

namespace cli {

struct OptionText {
    const char *names = ""; ///< without dashes, separated by commas
    const char *value = ""; ///< what stands for it in the help; empty: it has none
    const char *help = "";
};

void addOption(QCommandLineParser &parser, const OptionText &option);

/// What was typed behind a command's name.
class Given {
public:
    explicit Given(const QCommandLineParser &parser)
        : m_parser(parser)
    {
    }

    QStringList words() const { return m_parser.positionalArguments(); }
    /// By that name. False, too, if the command has no such option.
    bool has(const char *option) const;
    bool hasValue(const char *option) const; ///< also an empty one; by whichever of its names
    QString value(const char *option) const; ///< empty if it was not given
    QStringList list(const char *option) const; ///< separated by commas

private:
    const QCommandLineParser &m_parser;
};

inline auto usage(const QString &sentence) { return failure(kUsage, sentence); }

/// A number with a point, no more and no less than the whole word; empty if it is none, or not finite.
std::optional<double> plainNumber(const QString &text);
Outcome<int> wholeNumber(const QString &text, int least, int most, const QString &what);

/// An option that takes a whole number.
struct NumberOption {
    const char *name = "";
    int *value = nullptr; ///< stays as it is where the option was not given
    int least = 0, most = 0;
};
Outcome<bool> readNumbers(const Given &given, std::initializer_list<NumberOption> options);

} // namespace cli
