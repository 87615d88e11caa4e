// Whether a recording holds the samples that the board sent while it ran: as many as arrived between its beginning and its end,
// give or take what was on its way, and of the registers that were sent. Asked when the file is whole.
#pragma once

#include "capture/capture.h"
#include "session/recording/recording_reader.h"
#include "support/screen/screen_moment.h"

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
        // The samples of half a second may have been on their way at each end.
        const double seconds = toSeconds(m_moment.world().now() - m_begun);
        const auto slack =
            static_cast<std::uint64_t>(double(later - m_before) / std::max(seconds, 0.1));
        const std::string said = "the recording " + m_path.toStdString() + " holds "
            + std::to_string(held) + " samples, and the board sent "
            + std::to_string(m_after - m_before);
        return held > later - m_before + slack || held + slack < m_after - m_before ? said : "";
    }

private:
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
