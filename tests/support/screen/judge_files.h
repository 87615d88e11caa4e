// Whether a recording holds the samples that the board sent while it ran: as many as arrived between its beginning and
// its end, give or take what was on its way, and of the registers that were sent; and whether what was read in turn is
// what the board gave. Asked when the file is whole.
#pragma once

#include "capture/capture.h"
#include "session/recording/reader.h"
#include "support/screen/judged_register.h"
#include "support/screen/screen_moment.h"

#include <QFile>
#include <QFileInfo>

namespace support {

class FilesJudge {
public:
    explicit FilesJudge(ScreenMoment &moment)
        : m_moment(moment)
    {
    }

    void begins(const QString &path)
    {
        m_path = path;
        m_before = arrived();
        m_begun = m_moment.world().now();
    }
    void ends() { m_after = arrived(); }

    std::string asSent()
    {
        if (m_path.isEmpty() || !QFileInfo::exists(m_path))
            return {}; // it was refused, and the message says so
        capture::Capture capture;
        const auto report = session::readRecording(m_path, capture);
        const std::uint64_t later = arrived();
        if (!report)
            return m_path.toStdString() + " cannot be read: " + report.error().toStdString();
        std::uint64_t held = 0;
        for (const capture::ChannelInfo &info : capture.channels())
            if (info.kind == capture::ChannelInfo::Kind::Fast)
                held += capture.size(info.id);
        ++m_moment.statements;
        // The samples of half a second may have been on their way at each end; of a second more, while the board was
        // met anew.
        const double seconds = toSeconds(m_moment.world().now() - m_begun);
        const double onTheWay = m_moment.world().linkChanged() > m_begun ? 2.0 : 1.0;
        const auto slack = std::max(kFew,
            static_cast<std::uint64_t>(
                onTheWay * double(later - m_before) / std::max(seconds, 0.1)));
        const std::string said = "the recording " + m_path.toStdString() + " holds "
            + std::to_string(held) + " samples, and the board sent "
            + std::to_string(m_after - m_before);
        if (m_moment.world().mcp()
            && (held > later - m_before + slack || held + slack < m_after - m_before)) {
            if (const QString folder = qEnvironmentVariable("ROTORSCOPE_PICTURES");
                !folder.isEmpty())
                QFile::copy(m_path, folder + QStringLiteral("/recording.pcapng"));
            return said;
        }
        for (const capture::ChannelInfo &info : capture.channels())
            if (info.kind == capture::ChannelInfo::Kind::Polled)
                if (std::string wrong = asGiven(*capture.channel(info.id)); !wrong.empty())
                    return "the recording " + m_path.toStdString() + " holds " + wrong;
        return {};
    }

private:
    static constexpr std::uint64_t kFew = 2000; ///< samples of a stream that has just begun
    static constexpr Duration kLately = 15s; ///< less than values are kept
    static constexpr std::uint64_t kLast = 10; ///< values that are looked at

    std::string asGiven(const capture::Channel &channel)
    {
        const QString name = QString::fromStdString(channel.info().name);
        const QString motor = name.section(QLatin1Char('@'), 1);
        const auto known =
            judgedRegister(m_moment.world(), name.section(QLatin1Char('@'), 0, 0).toStdString(),
                motor.isEmpty() ? 1 : motor.toInt(), false);
        if (!known)
            return {};
        const auto given = m_moment.world().given(known->id);
        if (given.empty() || given.back().at + kLately < m_moment.world().now())
            return {}; // of earlier than the judge remembers
        const auto count = std::min(channel.size(), kLast);
        for (auto i = channel.end() - count; i < channel.end(); ++i) {
            const double value = channel.at(i);
            ++m_moment.statements;
            const bool was = std::any_of(given.begin(), given.end(), [&](const auto &one) {
                const double gave = one.number * known->factor;
                return std::abs(gave - value) <= 1e-5 * std::max(1.0, std::abs(gave));
            });
            if (!was)
                return channel.info().name + " = " + std::to_string(value)
                    + ", which the board never gave";
        }
        return {};
    }
    std::uint64_t arrived() const
    {
        return m_moment.world().ofBoard(
            [](const judge::McpBoard &board) { return board.samples(); });
    }

    ScreenMoment &m_moment;
    QString m_path;
    std::uint64_t m_before = 0, m_after = 0;
    TimePoint m_begun{};
};

} // namespace support
