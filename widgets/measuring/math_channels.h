// The math channels: each computes a formula over recorded signals as they grow, into a channel of the
// capture, so that it is drawn, measured, triggered on and exported like any other. A channel whose signals are not
// there waits for them; one whose signals were recorded anew begins anew.
//
// A formula may use what was recorded and the math channels before it in the list, so none can depend on itself.
#pragma once

#include "capture/capture.h"
#include "scope/math_channel.h"
#include "widgets/measuring/math_formula.h"

#include <QObject>
#include <QTimer>

#include <functional>

namespace widgets {

class MathChannels : public QObject {
    Q_OBJECT
public:
    /// Values kept, of all math channels together: about 540 MB.
    static constexpr std::uint64_t kMostValues = 30'000'000;
    /// Values that advance() computes, of all of them together: some milliseconds. The rest follows when others had a
    /// turn.
    static constexpr std::size_t kInstantsAtOnce = 20'000;

    struct Entry {
        MathFormula formula;
        capture::ChannelId channel = 0; ///< 0: its signals are not there yet
        QString unit;
    };
    /// What is to be said about a formula while it is typed.
    struct Check {
        std::optional<scope::FormulaFault> fault;
        bool noSignal = false; ///< it is right, but a number and no signal
        QString unit; ///< empty: a plain number, or it does not follow
        bool fine() const { return !fault && !noSignal; }
    };

    /// @param capture  outlives it
    explicit MathChannels(capture::Capture &capture, QObject *parent = nullptr);
    ~MathChannels() override;

    /// Tells which registers are still asked for one by one. Others do not hold a channel back.
    void setPolled(std::function<std::vector<catalog::RegisterId>()> polled);

    /// The names that the formula of the channel `of`, or of a new one, may use now; each once.
    std::vector<scope::FormulaName> names(const QString &of = {}) const;
    Check check(const QString &text, const QString &of = {}) const;
    /// A name that formulas can use, and that no other channel has.
    bool isFree(const QString &name) const;
    QString freeName() const; ///< M1, M2 and so on

    std::vector<Entry> entries() const;
    QList<MathFormula> formulas() const; ///< to be kept
    /// Takes over what was kept; formulas whose signals are not there wait for them.
    void setFormulas(const QList<MathFormula> &formulas);
    /// Adds a channel, or changes the formula of the one of that name. False: nothing was changed, because one of them
    /// is not right or there are kMostMathFormulas.
    bool set(const QString &name, const QString &text);
    void remove(const QString &name);
    void setShown(const QString &name, bool shown);

public Q_SLOTS:
    void advance(); ///< computes what has become known, in pieces too small to be noticed

Q_SIGNALS:
    void changed(); ///< entries()
    /// The entry of this name has a channel now, in the place of the one that it had and that is still there (0: none).
    void made(const QString &name, quint32 before);
    void goes(quint32 channel); ///< it is still there
    void advanced(); ///< without being asked: the rest of what was too much for once

private:
    struct Computed;
    using List = std::vector<std::unique_ptr<Computed>>;
    Computed *find(const QString &name) const;
    void add(const MathFormula &formula);
    bool isMine(capture::ChannelId channel) const;
    std::vector<scope::FormulaName> namesFor(std::size_t count) const;
    bool prepare(std::size_t index);
    bool compile(std::size_t index);
    bool inputsAreThere(const Computed &computed) const;
    void makeChannel(Computed &computed, const std::string &unit);
    void dropChannel(Computed &computed);
    bool step(std::size_t index);
    std::optional<scope::Nanos> until(std::span<const capture::Channel *const> inputs) const;

    capture::Capture &m_capture;
    std::function<std::vector<catalog::RegisterId>()> m_polled;
    List m_computed;
    catalog::RegisterId m_nextRegister = capture::kFirstOwnRegister;
    QTimer m_rest; ///< for what is too much for once
    bool m_advancing = false;
};

} // namespace widgets
