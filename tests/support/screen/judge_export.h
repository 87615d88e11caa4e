// Whether a CSV of what the scope showed holds what the board sent: every stretch of rows of a signal at the rate of
// the rows is a stretch of its samples, digit for digit, and what was read in turn is what the board gave. The newest
// rows are looked at.
#pragma once

#include "support/screen/judged_register.h"
#include "support/screen/screen_moment.h"
#include "widgets/scope/view.h"

#include <QFile>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace support {

class ExportJudge {
public:
    static constexpr int kRows = 16'000; ///< that are looked at
    static constexpr std::size_t kStretch = 32; ///< rows that tell a stretch of samples
    static constexpr Duration kCalm = 3s; ///< without a loss or a change of the link

    explicit ExportJudge(ScreenMoment &moment)
        : m_moment(moment)
    {
    }

    /// Whether what is shown now can be judged when it is written: it follows, nothing was lost lately, and all of it
    /// is of this connection, of the board as it is since its reset, and not forgotten.
    bool canJudge() const
    {
        const auto *view = m_moment.find<widgets::ScopeView>("scope");
        const TimePoint now = m_moment.world().now();
        if (view == nullptr || !view->isVisible() || !view->running() || !view->time().following()
            || !m_moment.heard || !m_moment.answers() || m_moment.more > Duration{})
            return false;
        const auto range = view->visibleRange();
        const Duration calm = kCalm
            + std::chrono::duration_cast<Duration>(
                std::chrono::duration<double>(range.to - range.from));
        const bool lost =
            m_moment.world().mcp() && m_moment.world().ofBoard([&](const judge::McpBoard &board) {
                return !board.lost().empty() && board.lost().back().first + calm > now;
            });
        return !lost && calm + kCalm < judge::GivenValues::kKept
            && std::max(m_moment.world().linkChanged(), m_moment.world().resetAt()) + calm < now;
    }

    /// @return  what is not so
    std::string asSent(const QString &path)
    {
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly))
            return {}; // it was refused, and the message says so
        QList<QByteArray> lines = file.readAll().split('\n');
        lines.removeAll({});
        if (lines.size() < 2)
            return {};
        const QList<QByteArray> heads = lines.first().split(',');
        m_rows.clear();
        for (qsizetype i = std::max<qsizetype>(1, lines.size() - kRows); i < lines.size(); ++i)
            m_rows.push_back(lines[i].split(','));
        double step = 1e9; // seconds from row to row
        for (std::size_t i = 1; i < m_rows.size(); ++i)
            step = std::min(step, at(i, 0) - at(i - 1, 0));
        for (qsizetype column = 1; column < heads.size(); ++column) {
            const QString name =
                QString::fromUtf8(heads[column]).section(QLatin1String(" ["), 0, 0);
            const QString motor = name.section(QLatin1Char('@'), 1);
            const auto known =
                judgedRegister(m_moment.world(), name.section(QLatin1Char('@'), 0, 0).toStdString(),
                    motor.isEmpty() ? 1 : motor.toInt(), false);
            if (!known)
                continue;
            std::vector<std::int64_t> digits, ticks; // that were sent of it
            if (m_moment.world().mcp())
                m_moment.world().ofBoard([&](const judge::McpBoard &board) {
                    for (const auto &sample : board.samplesOf(known->id)) {
                        digits.push_back(sample.digits);
                        ticks.push_back(sample.tick);
                    }
                });
            const std::string wrong = digits.empty()
                ? givenIs(column, *known)
                : streamIs(column, *known, step, digits, ticks);
            if (!wrong.empty())
                return path.toStdString() + ", " + name.toStdString() + ": " + wrong;
        }
        return {};
    }

private:
    double at(std::size_t row, qsizetype column) const
    {
        return m_rows[row].value(column).toDouble();
    }
    std::string streamIs(qsizetype column, const JudgedRegister &known, double step,
        const std::vector<std::int64_t> &digits, const std::vector<std::int64_t> &ticks)
    {
        const double hz = m_moment.world().options().hfHz * m_moment.world().options().motors;
        const auto apart = std::llround(step * hz);
        if (ticks.size() < 2 || ticks.back() - ticks[ticks.size() - 2] != apart)
            return {}; // a slower one
        std::vector<std::int64_t> stretch;
        for (std::size_t row = 0; row <= m_rows.size(); ++row) {
            const bool goesOn = row < m_rows.size() && !m_rows[row].value(column).isEmpty()
                && (stretch.empty() || at(row, 0) - at(row - 1, 0) < 1.5 * step);
            if (goesOn) {
                stretch.push_back(std::llround(at(row, column) / known.factor));
                continue;
            }
            if (stretch.size() >= kStretch && !isAmong(stretch, digits, ticks, apart))
                return std::to_string(stretch.size()) + " rows before row " + std::to_string(row)
                    + " were never sent so";
            stretch.clear();
        }
        ++m_moment.statements;
        return {};
    }
    static bool isAmong(const std::vector<std::int64_t> &stretch,
        const std::vector<std::int64_t> &digits, const std::vector<std::int64_t> &ticks,
        std::int64_t apart)
    {
        const std::boyer_moore_searcher searcher(stretch.begin(), stretch.end());
        const auto length = static_cast<std::int64_t>(stretch.size()) - 1;
        for (auto found = std::search(digits.begin(), digits.end(), searcher);
             found != digits.end(); found = std::search(found + 1, digits.end(), searcher)) {
            const auto first = static_cast<std::size_t>(found - digits.begin());
            if (ticks[first + stretch.size() - 1] - ticks[first] == length * apart)
                return true;
        }
        return false;
    }

    std::string givenIs(qsizetype column, const JudgedRegister &known)
    {
        const auto given = m_moment.world().given(known.id);
        QByteArray last;
        for (const QList<QByteArray> &row : m_rows) {
            const QByteArray text = row.value(column);
            if (text.isEmpty() || text == last || given.empty())
                continue;
            last = text;
            ++m_moment.statements;
            const double value = text.toDouble();
            const bool was = std::any_of(given.begin(), given.end(), [&](const auto &one) {
                const double gave = one.number * known.factor;
                return std::abs(gave - value) <= 1e-5 * std::max(1.0, std::abs(gave));
            });
            if (!was)
                return text.toStdString() + " was never given, " + std::to_string(given.size())
                    + " others were, the last "
                    + std::to_string(toSeconds(m_moment.world().now() - given.back().at))
                    + " s ago";
        }
        return {};
    }

    ScreenMoment &m_moment;
    std::vector<QList<QByteArray>> m_rows;
};

} // namespace support
