#include "widgets/forms/gains_form.h"

#include "widgets/base/device_text.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/si_text.h"
#include "widgets/forms/gain_lab.h"
#include "widgets/forms/gain_table.h"
#include "widgets/forms/gain_texts.h"
#include "widgets/registers/edit_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace widgets {
namespace {

using Writes = std::vector<drive::RegisterWrite>;

bool holds(const Writes &writes, const drive::RegisterWrite &write)
{
    return std::find(writes.begin(), writes.end(), write) != writes.end();
}

bool writesTo(const Writes &writes, catalog::RegisterId id)
{
    return std::any_of(
        writes.begin(), writes.end(), [id](const auto &write) { return write.id == id; });
}

} // namespace

GainsForm::GainsForm(Device &device, RegisterModel &model, RegisterEdits &edits, QAction *apply,
    QAction *revert, const Inertias &inertias, QWidget *parent)
    : Form(parent)
    , m_device(device)
    , m_model(model)
    , m_edits(edits)
    , m_inertias(inertias)
    , m_pages(named(new QTabWidget(this), "gainPages"))
    , m_board(named(new QLabel, "gainBoard"))
    , m_table(new GainTable(model))
    , m_lab(new GainLab(model))
    , m_editBar(new EditBar(edits, model, apply, revert, EditBar::Room::Wide, this))
{
    setObjectName(QStringLiteral("gainsForm"));
    m_pages->tabBar()->setAccessibleName(tr("Pages of the gains"));
    m_pages->setDocumentMode(true);
    m_board->setTextFormat(Qt::PlainText);
    m_board->setForegroundRole(QPalette::PlaceholderText);
    m_pages->setCornerWidget(m_board);
    m_pages->addTab(m_table, tr("&Regulators"));
    m_pages->addTab(m_lab, tr("Gain &lab"));
    auto *layout = edged(new QVBoxLayout(this), {kHalfGrid, 0, kHalfGrid, 0}, kHalfGrid);
    layout->addWidget(m_pages, 1);
    // What a page wishes and what is written stay in view together where the page itself has to scroll.
    m_footer = new QWidget(this);
    auto *footer = bare(new QHBoxLayout(m_footer));
    footer->addWidget(m_lab->buttons());
    footer->addWidget(m_editBar, 1);
    const auto followPage = [this] {
        const bool lab = m_pages->currentWidget() == m_lab;
        m_lab->buttons()->setVisible(lab);
        // See sizeHint().
        m_lab->setSizePolicy(
            QSizePolicy::Preferred, lab ? QSizePolicy::Preferred : QSizePolicy::Ignored);
    };
    connect(m_pages, &QTabWidget::currentChanged, this, followPage);
    followPage();

    connect(m_pages, &QTabWidget::currentChanged, this, &Form::watchedRegistersChanged);
    connect(m_table, &GainTable::entryRefused, this,
        [this](const QString &sentence) { m_editBar->tell(sentence, false); });
    connect(m_lab, &GainLab::previewWished, this, &GainsForm::preview);
    connect(m_lab, &GainLab::planChanged, this, &GainsForm::followPlan);
    connect(m_lab, &GainLab::inertiaTyped, this, [this](double inertia_kgm2) {
        if (m_motorName.isEmpty())
            return;
        m_inertias[m_motorName] = inertia_kgm2;
        Q_EMIT inertiaRemembered(m_motorName, inertia_kgm2);
    });
    connect(&model, &RegisterModel::catalogSet, this, &GainsForm::boardChanged);
    connect(&edits, &RegisterEdits::changed, this, &GainsForm::editsChanged);
    boardChanged();
}

std::vector<catalog::RegisterId> GainsForm::watchedRegisters() const
{
    std::vector<catalog::RegisterId> ids =
        m_pages->currentWidget() == m_lab ? m_lab->registers() : m_table->registers();
    for (const catalog::RegisterId id : m_factRegisters)
        if (m_model.pollable(id))
            ids.push_back(id);
    return ids;
}

void GainsForm::refresh(Milliseconds)
{
    // What a board says of itself does not change: it is asked for until it is known.
    const bool news = std::any_of(m_factRegisters.begin(), m_factRegisters.end(),
        [this](catalog::RegisterId id) { return m_model.known(id) || !m_model.pollable(id); });
    if (news) {
        adoptFacts();
        Q_EMIT watchedRegistersChanged();
    }
    m_lab->refreshPresent();
}

QSize GainsForm::sizeHint() const
{
    const int tabs = m_pages->tabBar()->sizeHint().height() + layout()->spacing();
    return {Form::sizeHint().width(), tabs + m_pages->currentWidget()->sizeHint().height()};
}

void GainsForm::focusFirst()
{
    if (m_pages->currentWidget() == m_lab)
        m_lab->focusFirst();
    else
        m_table->focusFirst();
}

void GainsForm::boardChanged()
{
    const Writes previewed = std::exchange(m_previewed, {}); // of what is shown no more
    m_lab->forgetTyped();
    m_lab->setMeasured(m_measured); // emptied elsewhere if it is of another motor
    adoptFacts();
    m_lab->refreshPresent();
    if (!previewed.empty())
        dropPreview(previewed);
    Q_EMIT watchedRegistersChanged();
}

void GainsForm::setInertias(const Inertias &inertias)
{
    if (inertias == m_inertias)
        return;
    m_inertias = inertias;
    adoptFacts();
}

void GainsForm::setMeasured(const MeasuredMotor &measured)
{
    if (measured == m_measured)
        return;
    m_measured = measured;
    m_lab->setMeasured(measured);
}

void GainsForm::adoptFacts()
{
    drive::MotorFacts facts;
    m_factRegisters.clear();
    if (const auto catalog = m_model.catalog()) {
        facts = drive::motorFacts(*catalog, m_device.motor(),
            [this](catalog::RegisterId id) { return m_model.known(id); });
        for (const catalog::RegisterId id : drive::motorRegisters(*catalog, m_device.motor()))
            if (!m_model.known(id) && m_model.pollable(id))
                m_factRegisters.push_back(id);
    }
    m_motorName = deviceText(facts.name);
    const auto remembered = m_inertias.constFind(m_motorName);
    showBoard(facts);
    m_table->setFacts(facts);
    m_lab->setFacts(
        facts, remembered != m_inertias.constEnd() ? std::optional(*remembered) : std::nullopt);
}

void GainsForm::showBoard(const drive::MotorFacts &facts)
{
    const bool known =
        facts.controlPeriod_s > 0.0 && facts.ampsPerDigit > 0.0 && facts.speedPeriod_s > 0.0;
    m_board->setText(known
            ? tr("Board: %1 V, %2 digits per A, %3 kHz, speed loop %4 kHz")
                  .arg(significantText(facts.bus_v), significantText(1.0 / facts.ampsPerDigit),
                      significantText(1e-3 / facts.controlPeriod_s),
                      significantText(1e-3 / facts.speedPeriod_s))
            : gainsInUnits(m_model)
            ? tr("The gains of this drive are in the units that stand beside them.")
            : m_model.catalog() && m_factRegisters.empty()
            ? tr("This board does not say what its digits are worth.")
            : QString());
}

/// Registers and values; without those that this board has not.
std::vector<drive::RegisterWrite> GainsForm::planned() const
{
    Writes writes;
    for (const motor::PlannedGain &gain : m_lab->plan().gains) {
        const std::string name = gainRegister(gain.id);
        const auto numerator = m_model.idOf(name), divisor = m_model.idOf(name + "_DIV");
        if (!numerator || !divisor)
            continue; // the lab does not offer a preview then
        writes.push_back({*numerator, std::int64_t{gain.quantised.gain.numerator}});
        writes.push_back({*divisor, std::int64_t{gain.quantised.gain.exponent}});
    }
    return writes;
}

/// The form shows other gains now: what waits to be written is never of an older one.
void GainsForm::followPlan()
{
    if (m_edits.underWay())
        return;
    if (!m_previewed.empty())
        followPreview();
    tellOfOthers();
}

/// Gains that wait and that are planned otherwise: Apply writes what waits.
void GainsForm::tellOfOthers()
{
    QStringList others;
    const Writes plan = planned();
    for (const drive::RegisterWrite &write : m_model.pending())
        if (writesTo(plan, write.id) && !holds(plan, write))
            others.append(QString::fromStdString(m_model.catalog()->nameOf(write.id)));
    if (!others.isEmpty())
        m_lab->tell(tr("Edited by hand, not as planned here: %1. Apply writes what was edited.")
                        .arg(others.join(QStringLiteral(", "))));
    else if (m_toldOfOthers)
        m_lab->tell({});
    m_toldOfOthers = !others.isEmpty();
}

void GainsForm::followPreview()
{
    const auto pending = m_model.pending();
    Writes left = m_previewed;
    std::erase_if(left, [&pending](const auto &made) { return !holds(pending, made); });
    if (left.empty()) { // written, taken back, or edited by hand
        m_previewed.clear();
        m_lab->tell({});
    } else if (planned() != m_previewed) {
        // Beside what was edited by hand since, the rest is no plan any more.
        const bool byHand =
            std::any_of(m_previewed.begin(), m_previewed.end(), [&pending](const auto &made) {
                return writesTo(pending, made.id) && !holds(pending, made);
            });
        m_previewed.clear();
        if (!byHand && m_lab->previewPossible())
            preview();
        else
            dropPreview(left);
    }
}

void GainsForm::dropPreview(const Writes &edits)
{
    m_model.forgetEdits([&edits](catalog::RegisterId id) { return writesTo(edits, id); });
    m_lab->tell(tr("The form has changed: the edits of its preview were dropped."));
}

void GainsForm::editsChanged()
{
    m_lab->refreshPresent();
    followPlan();
}

void GainsForm::preview()
{
    if (m_edits.underWay())
        return m_lab->tell(tr("A write is under way: preview again when it has ended."));
    m_previewed.clear();
    m_lab->refreshPresent();
    const Writes wanted = planned();
    QStringList others;
    for (const drive::RegisterWrite &write : m_model.pending())
        if (!writesTo(wanted, write.id))
            others.append(QString::fromStdString(m_model.catalog()->nameOf(write.id)));
    int changes = 0;
    for (const drive::RegisterWrite &write : wanted) {
        if (!m_model.setPending(write.id, write.value)) {
            // One without the others would be another gain, perhaps a power of two away.
            m_model.forgetEdits([&wanted](catalog::RegisterId id) { return writesTo(wanted, id); });
            return m_lab->tell(
                tr("%1 cannot be edited now.")
                    .arg(QString::fromStdString(m_model.catalog()->nameOf(write.id))));
        }
        changes += m_model.known(write.id) != write.value;
    }
    if (changes > 0)
        m_previewed = wanted;
    QString told = changes > 0
        ? tr("%n edit(s) wait: Apply writes them as one step.", nullptr, changes)
        : tr("The board has these gains already.");
    if (!others.isEmpty())
        told += QLatin1Char(' ')
            + tr("%n other edit(s) waited already and would be written with them: %1.", nullptr,
                int(others.size()))
                  .arg(others.join(QStringLiteral(", ")));
    m_lab->tell(told);
}

} // namespace widgets
