// LinkNews: which sentence the banner shows: what was done, what went wrong, or what the link does, and which of them
// gives way to which. Each happening of the link is told once: a message that was closed is not told again.
#pragma once

#include "widgets/base/banner.h"

#include <QObject>

#include <functional>

namespace widgets {

class Device;

class LinkNews : public QObject {
    Q_OBJECT
public:
    /// @param connecting  a connection is open or looked for
    /// @param wereAtRest  all motors, when they were last heard
    LinkNews(const Device &device, std::function<bool()> connecting,
        std::function<bool()> wereAtRest, Banner &banner, QObject *parent = nullptr);

    /// Contact was lost: told until there is contact again.
    bool tellsLoss() const { return m_told == Told::Loss; }
    /// What an experiment has left on the board; empty: nothing any more. It comes back from behind what the link says,
    /// and whenever the board is armed. @param act  the button that gives it back; nullptr: there is none
    void setLeft(const QString &sentence, QWidget *act);
    void givenBack(const QString &sentence); ///< with what is left all the same

public Q_SLOTS:
    void say(widgets::Banner::Kind kind, const QString &sentence);
    void warn(const QString &sentence) { say(Banner::Kind::Warning, sentence); }
    void linkChanged();
    void follow(); ///< what else is known of the link or the board has changed
    void armedChanged(bool armed); ///< a reset is known then
    void portChanged(); ///< what was done before a connection is no news beside what comes now

private:
    enum class Told : std::uint8_t {
        Other,
        Done, ///< goes when the next connection or replay begins
        Link, ///< goes when the link changes
        Loss, ///< stays until the board answers again
        Left, ///< stays until it is given back
    };
    struct Message {
        Banner::Kind kind = Banner::Kind::Note;
        QString sentence; ///< empty: nothing to say
        Told told = Told::Other;
    };
    Message message() const;
    bool alive() const;
    void sayLeft(const QString &first = {});
    void clear();

    const Device &m_device;
    std::function<bool()> m_connecting;
    std::function<bool()> m_wereAtRest;
    Banner &m_banner;
    Told m_told = Told::Other;
    QString m_said; ///< of the link, in this happening
    QString m_left; ///< by an experiment
    QWidget *m_giveBack = nullptr;
    bool m_reset = false; ///< the board was, and has not been armed since
};

} // namespace widgets
