// Whether the message over the scope is true: of the link while the board answers, of a reset that was none, of files
// that are not there or not so large.
#pragma once

#include "support/screen/screen_moment.h"

#include <QDateTime>
#include <QFileInfo>

#include <set>

namespace support {

class BannerJudge {
public:
    explicit BannerJudge(ScreenMoment &moment)
        : m_moment(moment)
    {
    }

    void look()
    {
        const auto *text = m_moment.find<QLabel>("bannerText");
        if (text == nullptr || !text->isVisible() || text->text().isEmpty())
            return;
        const QString sentence = text->text();
        const auto is = [&sentence](
                            const char *words) { return sentence.contains(QLatin1String(words)); };
        const auto untrue = [&](const std::string &truth) {
            m_moment.finds(QStringLiteral("banner"), sentence, truth);
        };
        ++m_moment.statements;
        const bool answers = m_moment.heard && m_moment.more == Duration{}
            && m_moment.said("boardLamp").contains(QLatin1String("answering"));
        for (const char *words : {"no board answers", "went silent", "Link lost", "was unplugged"})
            if (answers && is(words))
                untrue("beside a board that answers");
        if (is("was reset") && !m_moment.world().wasReset())
            untrue("and nobody reset it");
        // Only the user starts these boards: what was at rest when it was last heard is so now.
        if (is("No motor was driven") && m_moment.world().isDriven())
            untrue("and a motor is driven");
        if (m_judged.insert(sentence).second) // what is written there later is another file
            fileIs(sentence);
    }

private:
    void fileIs(const QString &sentence)
    {
        static const QRegularExpression recorded(QStringLiteral("^Recorded to (.+): ([0-9.]+) MB")),
            exported(QStringLiteral("^(?:Exported to|Opened|Imported) (\\S+?)\\.(?: |$)"));
        if (const auto match = recorded.match(sentence); match.hasMatch()) {
            const QFileInfo file(match.captured(1));
            const auto said = ScreenMoment::number(match.captured(2));
            // A message that was covered when it was said may come when another file has long been in its place.
            const bool ofNow = file.lastModified().secsTo(QDateTime::currentDateTime()) < 5;
            if (said && ofNow && !said->is(static_cast<double>(file.size()) / 1e6))
                m_moment.finds(QStringLiteral("banner"), sentence,
                    "and the file has " + std::to_string(file.size()) + " bytes");
        }
        if (const auto match = exported.match(sentence);
            match.hasMatch() && !QFileInfo::exists(match.captured(1)))
            m_moment.finds(QStringLiteral("banner"), sentence, "and there is no such file");
    }

    ScreenMoment &m_moment;
    std::set<QString> m_judged; ///< of files; a message comes back where a newer one is closed
};

} // namespace support
