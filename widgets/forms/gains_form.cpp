#include "widgets/forms/gains_form.h"

#include "widgets/base/device_text.h"
#include "widgets/base/look/spacing.h"
#include "widgets/forms/gain_lab.h"
#include "widgets/forms/gain_number.h"
#include "widgets/forms/gain_table.h"
#include "widgets/forms/gain_texts.h"
#include "widgets/registers/edit_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <set>
#include <utility>

namespace widgets {

GainsForm::GainsForm(Device &device, RegisterModel &model, RegisterEdits &edits, QAction *apply,
    QAction *revert, const Inertias &inertias, QWidget *parent)
    : Form(parent)
    , m_device(device)
    , m_model(model)
    , m_edits(edits)
    , m_inertias(inertias)
    , m_pages(new QTabWidget(this))
    , m_board(new QLabel)
    , m_table(new GainTable(model))
    , m_lab(new GainLab(model))
    , m_editBar(new EditBar(edits, model, apply, revert, EditBar::Room::Wide, this))
{
    setObjectName(QStringLiteral("gainsForm"));
    m_pages->setObjectName(QStringLiteral("gainPages"));
    m_pages->tabBar()->setAccessibleName(tr("Pages of the gains"));
    m_pages->setDocumentMode(true);
    m_board->setObjectName(QStringLiteral("gainBoard"));
    m_board->setTextFormat(Qt::PlainText);
    m_board->setForegroundRole(QPalette::PlaceholderText);
    m_pages->setCornerWidget(m_board);
    m_pages->addTab(m_table, tr("&Regulators"));
    m_pages->addTab(m_lab, tr("Gain &lab"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(kHalfGrid, 0, kHalfGrid, 0);
    layout->setSpacing(kHalfGrid);
    layout->addWidget(m_pages, 1);
    // What a page wishes and what is written stay in view together where the page itself has to scroll.
    m_footer = new QWidget(this);
    auto *footer = new QHBoxLayout(m_footer);
    footer->setContentsMargins(0, 0, 0, 0);
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
    connect(&model, &QAbstractItemModel::modelReset, this, &GainsForm::boardChanged);
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
        takeFacts();
        Q_EMIT watchedRegistersChanged();
    }
    m_lab->refreshPresent();
}

QWidget *GainsForm::footer() const { return m_footer; }

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
    m_lab->forgetTyped();
    takeFacts();
    m_lab->refreshPresent();
    Q_EMIT watchedRegistersChanged();
}

void GainsForm::setInertias(const Inertias &inertias)
{
    if (inertias == m_inertias)
        return;
    m_inertias = inertias;
    takeFacts();
}

void GainsForm::takeFacts()
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

QStringList GainsForm::othersPending() const
{
    std::vector<catalog::RegisterId> planned;
    for (const motor::PlannedGain &gain : m_lab->plan().gains)
        for (const QString &suffix : {QString(), QStringLiteral("_DIV")})
            if (const auto id =
                    m_model.idOf((QLatin1String(gainRegister(gain.id)) + suffix).toStdString()))
                planned.push_back(*id);
    QStringList names;
    for (const drive::RegisterWrite &write : m_model.pending())
        if (std::find(planned.begin(), planned.end(), write.id) == planned.end())
            names.append(QString::fromStdString(m_model.catalog()->nameOf(write.id)));
    return names;
}

/// Whether the last preview still stands among the edits, as it was made.
bool GainsForm::previewWaits() const
{
    const auto pending = m_model.pending();
    return !m_previewed.empty()
        && std::all_of(m_previewed.begin(), m_previewed.end(), [&](const auto &made) {
               return std::any_of(pending.begin(), pending.end(), [&](const auto &write) {
                   return write.id == made.id && write.value == made.value;
               });
           });
}

/// The form shows other gains now: what waits to be written is never of an older one.
void GainsForm::followPlan()
{
    if (m_edits.underWay() || !previewWaits())
        return;
    if (m_lab->previewPossible())
        return preview();
    for (const drive::RegisterWrite &made : std::exchange(m_previewed, {}))
        if (const auto held = m_model.known(made.id))
            m_model.setPending(made.id, *held);
    m_lab->tell(tr("The form has changed: the edits of its preview were dropped."));
}

void GainsForm::editsChanged()
{
    if (!m_previewed.empty() && !m_edits.underWay() && !previewWaits()) {
        m_previewed.clear(); // written, taken back, or edited by hand
        m_lab->tell({});
    }
    m_lab->refreshPresent();
}

void GainsForm::preview()
{
    m_previewed.clear();
    if (m_edits.underWay())
        return m_lab->tell(tr("A write is under way: preview again when it has ended."));
    const QStringList others = othersPending();
    const motor::GainPlan plan = m_lab->plan(); // each edit lets the lab look again
    int changes = 0;
    std::set<catalog::RegisterId> planned;
    for (const motor::PlannedGain &gain : plan.gains) {
        const std::string name = gainRegister(gain.id);
        const auto numerator = m_model.idOf(name), divisor = m_model.idOf(name + "_DIV");
        if (!numerator || !divisor)
            continue; // the lab does not offer a preview then
        const catalog::Value digits{std::int64_t{gain.quantised.gain.numerator}},
            exponent{std::int64_t{gain.quantised.gain.exponent}};
        // One without the other would be another gain, a power of two away.
        const bool both =
            m_model.setPending(*numerator, digits) && m_model.setPending(*divisor, exponent);
        if (!both) {
            for (const auto id : {*numerator, *divisor})
                if (const auto held = m_model.known(id))
                    m_model.setPending(id, *held);
            return m_lab->tell(tr("%1 cannot be edited now.").arg(QString::fromStdString(name)));
        }
        planned.insert({*numerator, *divisor});
        changes += m_model.known(*numerator) != digits;
        changes += m_model.known(*divisor) != exponent;
    }
    for (const drive::RegisterWrite &write : m_model.pending())
        if (planned.count(write.id) > 0)
            m_previewed.push_back(write);
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
