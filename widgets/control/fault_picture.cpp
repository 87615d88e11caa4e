#include "widgets/control/fault_picture.h"

#include "widgets/base/device_text.h"
#include "widgets/base/look/named.h"
#include "widgets/base/si_text.h"
#include "widgets/base/value_text.h"
#include "widgets/scope/view.h"

#include <QComboBox>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace widgets {
namespace {

constexpr int kMostPlots = 3;

QString titleOf(const FaultRecord &record)
{
    return FaultPicture::tr("%1, motor %2: %3", "time, number, faults")
        .arg(QLocale().toString(record.when.time(), QStringLiteral("HH:mm:ss")),
            QString::number(record.motor), record.faults);
}

/// What the signals were when the fault was told.
QString valuesOf(const FaultRecord &record)
{
    QStringList values;
    for (const capture::ChannelInfo &info : record.samples->channels())
        if (const auto value = record.samples->valueAt(info.id, record.seconds))
            values.append(QStringLiteral("%1 %2").arg(
                deviceText(info.name), siText(*value, unitText(info.unit))));
    return values.join(QStringLiteral(", "));
}

} // namespace

FaultPicture::FaultPicture(const FaultRecords &records, QWidget *parent)
    : QWidget(parent)
    , m_records(records)
    , m_choice(named(new QComboBox(this), "faultRecord", tr("Recorded fault")))
    , m_says(wrappedLabel("faultRecordSays", this))
    , m_layout(new QVBoxLayout(this))
{
    m_says->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->addWidget(m_choice);
    m_layout->addWidget(m_says);
    connect(m_choice, &QComboBox::activated, this,
        [this](int row) { showRecord(m_choice->itemData(row).toUInt()); });
    connect(&records, &FaultRecords::changed, this, &FaultPicture::follow);
    follow();
}

void FaultPicture::showNewestOf(int motor)
{
    const auto &all = m_records.records();
    const auto newest = std::find_if(
        all.rbegin(), all.rend(), [motor](const FaultRecord &one) { return one.motor == motor; });
    if (newest != all.rend())
        showRecord(newest->id);
}

/// The choice; and what is shown once its samples have come.
void FaultPicture::follow()
{
    const auto &all = m_records.records();
    setVisible(!all.empty());
    m_choice->clear();
    for (auto record = all.rbegin(); record != all.rend(); ++record)
        m_choice->addItem(titleOf(*record), record->id);
    if (all.empty())
        return;
    if (m_records.find(m_shown.id) == nullptr)
        showRecord(all.back().id);
    else if (m_shown.samples == nullptr)
        showRecord(m_shown.id);
    m_choice->setCurrentIndex(m_choice->findData(m_shown.id));
}

void FaultPicture::showRecord(quint32 id)
{
    const FaultRecord *record = m_records.find(id);
    if (record == nullptr)
        return;
    delete std::exchange(m_scope, nullptr); // before the samples it draws
    m_shown = *record;
    m_choice->setCurrentIndex(m_choice->findData(id));
    if (m_shown.samples == nullptr) {
        m_says->setText(tr("Recording what follows\u2026"));
        return;
    }
    const auto channels = m_shown.samples->channels();
    if (channels.empty()) {
        m_says->setText(tr("No signal was recorded when this fault came. Drag signals onto the "
                           "scope: then the next one has a picture."));
        return;
    }
    m_says->setText(tr("When it was told (0 s): %1", "values of signals").arg(valuesOf(m_shown)));
    m_events.clear();
    m_events.add(EventKind::Fault, m_shown.seconds, m_shown.faults);
    m_scope = new ScopeView(*m_shown.samples, m_events, this);
    m_scope->setAccessibleName(tr("Signals around the fault"));
    QStringList units; // a plot each, while there is room
    for (const capture::ChannelInfo &info : channels) {
        const QString unit = QString::fromStdString(info.unit);
        if (!units.contains(unit))
            units.append(unit);
        m_scope->addChannel(info.id, std::min(int(units.indexOf(unit)), kMostPlots - 1));
    }
    m_layout->addWidget(m_scope, 1);
    m_scope->time().setOrigin(m_shown.seconds);
    m_scope->setVisibleRange(
        m_shown.seconds - FaultRecords::kBefore, m_shown.seconds + FaultRecords::kAfter);
    m_scope->fitValues();
}

} // namespace widgets
