// What the user's input at the real window means to the judge of the wire: every key, press, turn of the wheel and drop
// is an act before anything of the window sees it, and what the window says is told on. It reads widgets by their names
// and their words, never the models behind.
#pragma once

#include "support/act_sink.h"
#include "widgets/base/device.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QKeyEvent>
#include <QPointer>
#include <QWidget>

#include <algorithm>
#include <array>
#include <utility>

namespace support {

class WindowActs : public QObject {
public:
    using Kind = judge::Act::Kind;

    /// @param sink  outlives it, as do the others
    WindowActs(ActSink &sink, QWidget &window, widgets::Device &device)
        : m_sink(sink)
        , m_window(window)
    {
        qApp->installEventFilter(this);
        connect(&device, &widgets::Device::stopAdvanced, this,
            [this](const drive::StopProgress &progress) {
                if (progress.word == drive::StopWord::NotConfirmed)
                    m_sink.said(judge::Word::NotConfirmed, progress.motor);
            });
        connect(&device, &widgets::Device::linkStateChanged, this,
            [this, &device] { m_sink.said(linkOf(device.link().state)); });
        connect(&device, &widgets::Device::identityChanged, this, [this, &device] {
            m_sink.saidIdentified(device.identified() ? device.identified()->identity.motors : 0);
        });
    }

    /// Arming is read off the window: any input may have done it.
    void noteArming()
    {
        if (!m_arm)
            m_arm = m_window.findChild<QCheckBox *>(QStringLiteral("arm"));
        const bool armed = m_arm && m_arm->isChecked();
        if (armed && !m_armed)
            m_sink.act(Kind::Arm);
        m_armed = armed;
    }

private:
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        auto *widget = qobject_cast<QWidget *>(watched);
        switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
            if (widget != nullptr && isNew(*static_cast<QMouseEvent *>(event)))
                press(*widget);
            break;
        case QEvent::ShortcutOverride:
        case QEvent::KeyPress:
            if (widget != nullptr && isNew(*static_cast<QKeyEvent *>(event)))
                key(*widget, static_cast<QKeyEvent *>(event)->key(),
                    static_cast<QKeyEvent *>(event)->modifiers());
            break;
        case QEvent::KeyRelease:
            m_key = {QEvent::None, 0};
            break;
        case QEvent::Wheel:
        case QEvent::Drop:
            if (widget != nullptr)
                input(Kind::Input);
            break;
        default:
            break;
        }
        return false;
    }

    /// What no widget takes is shown to the parents of its widget, too.
    bool isNew(const QMouseEvent &event)
    {
        const quint64 before = std::exchange(m_pressedAt, event.timestamp());
        return event.timestamp() == 0 || event.timestamp() != before;
    }
    /// A key asks first whether it is a shortcut.
    bool isNew(const QKeyEvent &event)
    {
        const auto before = std::exchange(m_key, {event.type(), event.key()});
        return before.second != event.key()
            || (before.first == QEvent::KeyPress && event.type() == QEvent::ShortcutOverride);
    }

    /// What moves a motor by itself, and what ends that with a Stop.
    struct LabRun {
        const char *name;
        int inARow; ///< experiments that it begins, one after the other
    };
    static constexpr std::array kLabRuns{LabRun{"stepRun", 1}, LabRun{"electricalRun", 2},
        LabRun{"mechanicalRun", 1}, LabRun{"speedResponseRun", 1}, LabRun{"currentResponseRun", 1},
        LabRun{"proveRun", 2}, LabRun{"tourRun", 4}, LabRun{"tourProveRun", 2}};
    static constexpr std::array kLabCancels{
        "stepCancel", "identifyCancel", "responseCancel", "tourCancel"};
    static bool cancelsInLab(const QString &name)
    {
        return std::any_of(kLabCancels.begin(), kLabCancels.end(),
            [&](const char *one) { return name == QLatin1String(one); });
    }
    void begin(int experiments)
    {
        for (int i = 0; i < experiments; ++i)
            m_sink.act(Kind::Series);
    }

    void input(Kind kind)
    {
        noteArming();
        m_sink.act(kind);
    }
    static Kind inputOn(const QWidget &widget)
    {
        return widget.objectName().startsWith(QLatin1String("jog")) ? Kind::Hold : Kind::Input;
    }
    void press(const QWidget &widget)
    {
        QString name = widget.objectName();
        name.remove(QLatin1String("OnTop")); // a Stop over a dialog is the one below it
        m_restores = name == QLatin1String("snapshotRestore")
            || (m_restores && name == QLatin1String("writeAnyway"));
        input(m_restores ? Kind::Restore : inputOn(widget));
        answer(widget);
        const bool stops = name == QLatin1String("stop") || name == QLatin1String("stopMotors")
            || name == QLatin1String("faultHelpStop") || cancelsInLab(name)
            || name.endsWith(QLatin1String("DockStop"));
        if (stops && widget.isEnabled())
            m_sink.act(Kind::Stop);
    }
    void key(const QWidget &widget, int which, Qt::KeyboardModifiers modifiers)
    {
        if (which == Qt::Key_Escape)
            return input(Kind::Stop);
        input(inputOn(widget));
        answer(widget);
        if (which == Qt::Key_T && modifiers == (Qt::ControlModifier | Qt::ShiftModifier))
            begin(m_inARow = 1);
    }
    static bool isJog(const QAbstractButton &yes)
    {
        return yes.text().remove(QLatin1Char('&')) == QLatin1String("Jog"); // with its mnemonic
    }
    /// A yes; the one to a jog moves nothing.
    void answer(const QWidget &widget)
    {
        const auto *button = qobject_cast<const QAbstractButton *>(&widget);
        if (button == nullptr)
            return;
        if (button->objectName() == QLatin1String("motionConfirm"))
            m_sink.act(isJog(*button) ? Kind::AgreeToHold : Kind::Confirm);
        if (button->objectName() == QLatin1String("experimentConfirm")) {
            m_sink.act(Kind::AgreeToSeries);
            begin(m_inARow - 1);
        }
        for (const LabRun &run : kLabRuns)
            if (button->objectName() == QLatin1String(run.name))
                begin(m_inARow = run.inARow);
        for (const char *words : {"all the same", "eave running", "without"})
            if (button->text().contains(QLatin1String(words)))
                m_sink.act(Kind::Leave);
    }
    static judge::LinkState linkOf(drive::LinkState state)
    {
        switch (state) {
        case drive::LinkState::Closed:
            return judge::LinkState::Closed;
        case drive::LinkState::Connecting:
            return judge::LinkState::Connecting;
        case drive::LinkState::Connected:
            return judge::LinkState::Connected;
        case drive::LinkState::Suspect:
            return judge::LinkState::Suspect;
        case drive::LinkState::Recovering:
            return judge::LinkState::Recovering;
        case drive::LinkState::Lost:
            return judge::LinkState::Lost;
        }
        return judge::LinkState::Closed;
    }

    ActSink &m_sink;
    QWidget &m_window;
    QPointer<QCheckBox> m_arm;
    bool m_armed = false;
    quint64 m_pressedAt = 0;
    std::pair<QEvent::Type, int> m_key{QEvent::None, 0};
    int m_inARow = 1; ///< experiments of the button that was pressed last
    bool m_restores = false; ///< what a file holds is being written
};

} // namespace support
