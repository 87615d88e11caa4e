#include "widgets/lab/give_back.h"

#include "widgets/base/device_text.h"
#include "widgets/lab/experiments.h"
#include "widgets/registers/edits.h"

#include <algorithm>

namespace widgets {

GiveBack::GiveBack(Device &device, RegisterEdits &edits, Experiments &experiments, QWidget *parent)
    : QPushButton(tr("Give back"), parent)
    , m_device(device)
    , m_edits(edits)
    , m_experiments(experiments)
    , m_step(tr("As before the experiment", "name of a step of the list of edits"))
{
    setObjectName(QStringLiteral("giveBackButton"));
    hide();
    connect(this, &QPushButton::clicked, this, [this] {
        if (hint().isEmpty())
            m_edits.write(m_step, m_back);
    });
    connect(&edits, &RegisterEdits::changed, this, &GiveBack::follow);
    connect(&device, &Device::statusChanged, this, &GiveBack::follow);
    connect(&experiments, &Experiments::began, this, &GiveBack::follow);
    connect(&experiments, &Experiments::ended, this, &GiveBack::follow);
    connect(&edits, &RegisterEdits::reported, this, [this](const WriteReport &report) {
        if (report.text == m_step)
            Q_EMIT told(report.sentence);
    });
}

void GiveBack::offer(const std::vector<drive::RegisterWrite> &back)
{
    m_back = back;
    follow();
}

QString GiveBack::hint() const
{
    if (m_experiments.running())
        return tr("An experiment is running.");
    if (const QString why = m_edits.writeHint(); !why.isEmpty())
        return why;
    const auto catalog = m_device.catalog();
    const bool rest = std::ranges::all_of(m_back, [&](const drive::RegisterWrite &one) {
        const int motor = catalog->motorOf(one.id);
        return motor > 0 ? drive::rests(m_device.status(motor).state) : m_device.allIdle();
    });
    return rest ? QString() : tr("The motor has to rest: stop it first.");
}

void GiveBack::follow()
{
    if (m_back.empty())
        return;
    const QString why = hint();
    setEnabled(why.isEmpty());
    setToolTip(plainToolTip(why.isEmpty()
            ? tr("Writes what the registers held before the experiment, and reads it back")
            : why));
}

} // namespace widgets
