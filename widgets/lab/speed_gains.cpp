#include "widgets/lab/speed_gains.h"

#include "drive/motor_view.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/si_text.h"
#include "widgets/forms/gain_texts.h"
#include "widgets/lab/live_gain.h"

#include <QGridLayout>
#include <QLabel>

namespace widgets {

using motor::GainId;

namespace {

/// Kp and Ki, in the order of StepKind. What the digits of a position come to nothing tells.
constexpr std::pair<std::optional<GainId>, std::optional<GainId>> kLoops[kStepKinds] = {
    {GainId::SpeedKp, GainId::SpeedKi}, {GainId::TorqueKp, GainId::TorqueKi},
    {GainId::FluxKp, GainId::FluxKi}, {}};

} // namespace

SpeedGains::SpeedGains(
    Device &device, RegisterModel &model, RegisterEdits &edits, StepKind kind, QWidget *parent)
    : QWidget(parent)
    , m_kind(kind)
    , m_kpId(kLoops[std::size_t(kind)].first)
    , m_kiId(kLoops[std::size_t(kind)].second)
    , m_wanted(kind == StepKind::Speed)
    , m_model(model)
    , m_edits(edits)
    , m_facts(device, model)
    , m_kpText(named(new QLabel(this), "stepKpText"))
    , m_kiText(named(new QLabel(this), "stepKiText"))
{
    setObjectName(QStringLiteral("speedGains"));
    auto *grid = bare(new QGridLayout(this), kGrid, kFineGrid);
    m_kp = addGain(grid, 0, tr("&Kp"), m_kpId ? gainRegister(*m_kpId) : "POSITION_KP");
    m_ki = addGain(grid, 1, tr("K&i"), m_kiId ? gainRegister(*m_kiId) : "POSITION_KI");
    for (QLabel *text : {m_kpText, m_kiText})
        text->setTextFormat(Qt::PlainText);
    grid->addWidget(m_kpText, 0, 2);
    grid->addWidget(m_kiText, 1, 2);
    grid->setColumnStretch(2, 1);
    connect(&model, &RegisterModel::catalogSet, this, &SpeedGains::adoptFacts);
    for (const LiveGain *gain : {m_kp, m_ki})
        connect(gain, &LiveGain::changed, this, &SpeedGains::updateTexts);
    adoptFacts();
}

LiveGain *SpeedGains::addGain(QGridLayout *grid, int row, const QString &text, const char *name)
{
    auto *gain = new LiveGain(m_model, m_edits, name, this);
    auto *label = new QLabel(text, this);
    label->setBuddy(gain);
    const QString of = m_kind == StepKind::Torque ? tr("%1 of the torque loop", "Kp or Ki")
        : m_kind == StepKind::Flux                ? tr("%1 of the flux loop", "Kp or Ki")
        : m_kind == StepKind::Position            ? tr("%1 of the position loop", "Kp or Ki")
                                                  : tr("%1 of the speed loop", "Kp or Ki");
    gain->setAccessibleName(of.arg(QString(text).remove(QLatin1Char('&'))));
    gain->setFixedWidth(gain->fontMetrics().horizontalAdvance(QStringLiteral("-0000000")));
    grid->addWidget(label, row, 0);
    grid->addWidget(gain, row, 1);
    return gain;
}

std::vector<catalog::RegisterId> SpeedGains::watchedRegisters() const
{
    std::vector<catalog::RegisterId> ids;
    for (const LiveGain *gain : {m_kp, m_ki})
        for (const auto id : {gain->id(), gain->divisor()})
            if (id)
                ids.push_back(*id);
    ids.insert(ids.end(), m_facts.watched().begin(), m_facts.watched().end());
    return ids;
}

void SpeedGains::setWanted(bool wanted)
{
    m_wanted = wanted;
    updateTexts();
}

bool SpeedGains::refresh()
{
    const bool news = m_facts.refresh();
    if (news)
        updateTexts();
    return news;
}

void SpeedGains::adoptFacts()
{
    m_facts.begin();
    updateTexts();
}

bool SpeedGains::there() const { return m_kp->id() && m_ki->id(); }

bool SpeedGains::known() const
{
    const auto told = [](const LiveGain &gain) {
        return gain.digits() && (!gain.divisor() || gain.exponent());
    };
    return told(*m_kp) && told(*m_ki) && (!m_kpId || m_facts.known());
}

bool SpeedGains::settled() const { return m_kp->settled() && m_ki->settled(); }

SpeedGains::Values SpeedGains::values() const { return {m_kp->gain(), m_ki->gain()}; }

QString SpeedGains::kpText(std::optional<double> value) const { return textOf(value, m_kpId); }

QString SpeedGains::kiText(std::optional<double> value) const { return textOf(value, m_kiId); }

QString SpeedGains::textOf(std::optional<double> value, std::optional<GainId> id) const
{
    if (!value)
        return {};
    const auto physical = id ? motor::physicalGain(*id, *value, drive::gainPlant(m_facts.facts()))
                             : std::optional<double>();
    if (physical)
        return gainWithUnit(*physical, gainUnit(*id));
    return tr("%1 digits", "a gain whose unit is not known").arg(significantText(*value));
}

double SpeedGains::jumpPerRpm(const lab::Subject &subject) const
{
    if (m_kind != StepKind::Speed || !m_kp->digits())
        return 0.0;
    return lab::jumpPerRpm(subject, static_cast<double>(*m_kp->digits()),
        static_cast<double>(m_kp->exponent().value_or(-1)));
}

void SpeedGains::updateTexts()
{
    setVisible(m_wanted && (there() || !m_model.catalog()));
    m_kpText->setText(kpText(m_kp->gain()));
    m_kiText->setText(kiText(m_ki->gain()));
    Q_EMIT changed();
}

} // namespace widgets
