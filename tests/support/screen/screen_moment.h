// What a judge of the screen has to know of the moment at which it looks, and the words that judges share: how old a
// statement may be, what was found first, and how a number is read out of what is shown.
#pragma once

#include "support/judged_line.h"

#include <QComboBox>
#include <QLabel>
#include <QRegularExpression>
#include <QWidget>

#include <map>
#include <optional>
#include <string>

namespace support {

class ScreenMoment {
public:
    static constexpr Duration kLongestTrouble = std::chrono::seconds(6); ///< clocks jump so far

    ScreenMoment(const QWidget &window, JudgedWorld &world)
        : m_window(window)
        , m_world(world)
    {
    }

    Duration more{}; ///< that a statement may be older, because nothing newer was known
    bool heard = false; ///< the board was, lately
    Duration calm{}; ///< since a thread stood still, or time jumped
    int statements = 0; ///< that were compared

    const QWidget &window() const { return m_window; }
    JudgedWorld &world() const { return m_world; }

    const std::string &found() const { return m_found; }
    void begin() { m_found.clear(); }
    void finds(const QString &where, const QString &text, const std::string &truth)
    {
        if (m_found.empty())
            m_found = where.toStdString() + " says \"" + text.toStdString() + "\", " + truth;
    }

    template <class T>
    const T *find(const char *name) const
    {
        return m_window.findChild<T *>(QLatin1String(name));
    }
    /// A number in the legend is of lately, and a dash in its place is not: what is drawn counts for 2 s.
    /// @param came  when its newest value did
    void ages(const QString &where, const QString &text, bool isNumber, TimePoint came)
    {
        using namespace std::chrono_literals;
        if (calm < 4s)
            return; // the window measures by another clock
        const Duration age = m_world.now() - came;
        ++statements;
        if (isNumber && age > 4s)
            finds(
                where, text, "its newest value came " + std::to_string(toSeconds(age)) + " s ago");
        if (isNumber || !text.contains(QChar(0x2013)) || age >= 1s)
            return;
        if (m_world.linkChanged() + 6s > m_world.now())
            return; // read to find out what is there, and not yet recorded
        // The legend is brought up to date five times a second: a dash may stand a moment longer than its silence.
        Dash &dash = m_dashes[text];
        if (m_world.now() - dash.last > 1s)
            dash.first = m_world.now();
        dash.last = m_world.now();
        if (dash.last - dash.first > 500ms)
            finds(where, text, "a value came " + std::to_string(toSeconds(age)) + " s ago");
    }
    /// That a value may be older of which `mostOld` is asked: it may be of before a thread stood still, or time jumped.
    Duration moreFor(Duration mostOld) const
    {
        return calm < mostOld ? kLongestTrouble : Duration();
    }
    bool answers() const { return said("boardLamp").contains(QLatin1String("answering")); }
    /// The text of a label, or of the label within; what is greyed or hidden says nothing.
    QString said(const char *name) const
    {
        const auto *widget = find<QWidget>(name);
        if (widget == nullptr || !widget->isVisible() || !widget->isEnabled())
            return {};
        if (const auto *label = qobject_cast<const QLabel *>(widget))
            return label->text();
        const auto labels = widget->findChildren<QLabel *>();
        return labels.isEmpty() ? QString() : labels.last()->text();
    }
    int chosenMotor() const
    {
        const auto *box = find<QComboBox>("motor");
        return box != nullptr && box->isVisible() && box->currentIndex() >= 0
            ? box->currentIndex() + 1
            : 1;
    }

    /// A number at the beginning of a text, and how many decimals it has (below 0: so many digits are left out).
    struct Number {
        double value = 0.0;
        int decimals = 0;
        /// Whether it is this one, rounded as it is written.
        bool is(double truth) const
        {
            return std::abs(truth - value) <= 0.5001 * std::pow(10.0, -decimals);
        }
    };
    static std::optional<Number> number(QString text)
    {
        static const QRegularExpression first(
            QStringLiteral("^[\\s\u2007]*([-\u2212]?[0-9]+(?:\\.([0-9]+))?)(?:e([-+]?[0-9]+))?"));
        const auto match = first.match(text);
        if (!match.hasMatch())
            return {};
        QString digits = match.captured(1);
        digits.replace(QChar(0x2212), QLatin1Char('-'));
        const int power = match.captured(3).toInt();
        return Number{digits.toDouble() * std::pow(10.0, power),
            static_cast<int>(match.captured(2).size()) - power};
    }

private:
    const QWidget &m_window;
    JudgedWorld &m_world;
    std::string m_found;
    struct Dash {
        TimePoint first{}, last{}; ///< of looks that saw it beside a value of lately
    };
    std::map<QString, Dash> m_dashes; ///< by the text
};

} // namespace support
