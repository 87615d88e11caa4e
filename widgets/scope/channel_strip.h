// ChannelStrip: the recorded signals as chips, how each gets here, and what that costs of the link. Signals dropped
// on it are added.
#pragma once

#include "widgets/scope/polled_rates.h"
#include "widgets/scope/signal_selection.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QToolButton;

namespace widgets {

class FlowLayout;

class ChannelStrip : public QWidget {
    Q_OBJECT
public:
    ChannelStrip(SignalSelection &selection, Device &device, QWidget *parent = nullptr);

public Q_SLOTS:
    /// Some times a second: what the link really carries, beside what was planned.
    void measure(widgets::Milliseconds now);

protected:
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void rebuild();
    void updateBudget();
    void fillRates();
    QWidget *makeChip(const PlannedSignal &planned);
    void showRates(); ///< of what is read one by one, on its chips
    QString pollingText(int polled) const;

    SignalSelection &m_selection;
    Device &m_device;
    QWidget *m_chips;
    FlowLayout *m_flow;
    QLabel *m_empty;
    QComboBox *m_rate;
    QLabel *m_budget;
    std::optional<double> m_measured; ///< bytes a second
    PolledRates m_rates;
    std::map<quint32, QToolButton *> m_polledTags; ///< by signal, of the chips that are shown
    std::uint64_t m_bytesBefore = 0;
    Milliseconds m_measuredAt{};
};

} // namespace widgets
