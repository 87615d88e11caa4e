// ChannelStrip: the recorded signals as chips, how each gets here, and what that costs of the link; after them the
// computed ones, which cost nothing. Signals dropped on it are added. The chips can be folded away, and are while there
// is little room for the plots.
#pragma once

#include "widgets/scope/signals/polled_rates.h"
#include "widgets/scope/signals/selection.h"

#include <QWidget>

#include <functional>

class QComboBox;
class QLabel;
class QMenu;
class QToolButton;

namespace widgets {

class FlowLayout;
class SteadyLabel;

class ChannelStrip : public QWidget {
    Q_OBJECT
public:
    /// A channel that is computed from others and drawn.
    struct Computed {
        QString name;
        QString formula;
        QColor color;
        std::function<void(QMenu &)> fillColors; ///< those to choose from
        bool operator==(const Computed &other) const
        {
            return name == other.name && formula == other.formula && color == other.color;
        }
    };

    ChannelStrip(SignalSelection &selection, Device &device, QWidget *parent = nullptr);

    void setComputed(const QList<Computed> &computed);
    /// From now on the chips fold while there is little room, unless the user unfolds them; `crowded` asks. Those that
    /// the user folded stay so.
    void foldWhen(std::function<bool()> crowded);
    void room(); ///< it may have changed

public Q_SLOTS:
    /// Some times a second: what the link really carries, beside what was planned.
    void measure(widgets::Milliseconds now);

Q_SIGNALS:
    void computedRemoved(const QString &name); ///< off the scope
    void computedChosen(const QString &name); ///< to be changed

protected:
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void rebuild();
    void fold();
    void showFold();
    void updateBudget();
    void fillRates();
    QWidget *makeChip(const PlannedSignal &planned);
    void showRates(); ///< of what is read one by one, on its chips
    QString pollingText(int polled) const;
    QWidget *makeComputedChip(const Computed &computed);

    SignalSelection &m_selection;
    Device &m_device;
    QWidget *m_chips;
    FlowLayout *m_flow;
    SteadyLabel *m_empty;
    QToolButton *m_fold;
    QLabel *m_rateLabel;
    QComboBox *m_rate;
    SteadyLabel *m_budget;
    QList<Computed> m_computed;
    std::optional<double> m_measured; ///< bytes a second
    PolledRates m_rates;
    std::map<quint32, QToolButton *> m_polledTags; ///< by signal, of the chips that are shown
    std::function<bool()> m_isCrowded;
    bool m_crowded = false;
    std::optional<bool> m_foldedByHand;
    bool m_folded = false;
    std::uint64_t m_bytesBefore = 0;
    Milliseconds m_measuredAt{};
};

} // namespace widgets
