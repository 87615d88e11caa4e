#include "widgets/measuring/math_channels.h"

#include "widgets/base/device_text.h"

#include <algorithm>
#include <set>

namespace widgets {

struct MathChannels::Computed {
    Entry entry;
    catalog::RegisterId registerId = 0; ///< its colour and its trigger go by it
    std::vector<capture::ChannelId> inputs; ///< that `math` was made for
    std::optional<scope::MathChannel> math;
};

MathChannels::MathChannels(capture::Capture &capture, QObject *parent)
    : QObject(parent)
    , m_capture(capture)
{
    m_rest.setSingleShot(true);
    m_rest.setInterval(0);
    connect(&m_rest, &QTimer::timeout, this, [this] {
        advance();
        Q_EMIT advanced();
    });
}

MathChannels::~MathChannels() = default;

void MathChannels::setPolled(std::function<std::vector<catalog::RegisterId>()> polled)
{
    m_polled = std::move(polled);
}

bool MathChannels::isMine(capture::ChannelId channel) const
{
    return channel != 0
        && std::any_of(m_computed.begin(), m_computed.end(),
            [channel](const auto &computed) { return computed->entry.channel == channel; });
}

/// Of what was recorded, and of the first `count` of these.
std::vector<scope::FormulaName> MathChannels::namesFor(std::size_t count) const
{
    std::vector<scope::FormulaName> result;
    std::set<std::string> known;
    for (const capture::ChannelInfo &info : m_capture.channels()) {
        if (!isMine(info.id) && known.insert(info.name).second)
            result.push_back({info.name, info.unit});
    }
    for (std::size_t i = 0; i < count; ++i) {
        const auto info = m_capture.info(m_computed[i]->entry.channel);
        if (info && known.insert(info->name).second)
            result.push_back({info->name, info->unit});
    }
    return result;
}

std::vector<scope::FormulaName> MathChannels::names(const QString &of) const
{
    std::size_t before = 0;
    while (before < m_computed.size() && m_computed[before]->entry.formula.name != of)
        ++before;
    return namesFor(before);
}

MathChannels::Check MathChannels::check(const QString &text, const QString &of) const
{
    const auto formula = scope::Formula::compile(text.toStdString(), names(of));
    if (!formula)
        return {formula.error(), false, {}};
    return {std::nullopt, formula->used().empty(), deviceText(formula->unit())};
}

bool MathChannels::isFree(const QString &name) const
{
    if (!isMathName(name) || scope::columnFunction(name.toStdString()))
        return false;
    const auto all = m_capture.channels();
    return !find(name) && std::none_of(all.begin(), all.end(), [&](const auto &info) {
        return info.name == name.toStdString();
    });
}

QString MathChannels::freeName() const
{
    for (int i = 1;; ++i) {
        QString name = QStringLiteral("M%1").arg(i);
        if (isFree(name))
            return name;
    }
}

MathChannels::Computed *MathChannels::find(const QString &name) const
{
    const auto found = std::find_if(m_computed.begin(), m_computed.end(),
        [&name](const auto &computed) { return computed->entry.formula.name == name; });
    return found == m_computed.end() ? nullptr : found->get();
}

std::vector<MathChannels::Entry> MathChannels::entries() const
{
    std::vector<Entry> result;
    for (const auto &computed : m_computed)
        result.push_back(computed->entry);
    return result;
}

QList<MathFormula> MathChannels::formulas() const
{
    QList<MathFormula> result;
    for (const auto &computed : m_computed)
        result.append(computed->entry.formula);
    return result;
}

void MathChannels::add(const MathFormula &formula)
{
    auto computed = std::make_unique<Computed>();
    computed->entry.formula = formula;
    computed->registerId = m_nextRegister++;
    m_computed.push_back(std::move(computed));
}

void MathChannels::setFormulas(const QList<MathFormula> &formulas)
{
    for (const auto &computed : m_computed)
        dropChannel(*computed);
    m_computed.clear();
    for (qsizetype i = 0; i < std::min(formulas.size(), kMostMathFormulas); ++i)
        add(formulas[i]);
    advance();
    Q_EMIT changed();
}

bool MathChannels::set(const QString &name, const QString &text)
{
    Computed *computed = find(name);
    const bool room = qsizetype(m_computed.size()) < kMostMathFormulas;
    if ((!computed && (!room || !isFree(name))) || !check(text, name).fine())
        return false;
    if (!computed) {
        add({name, text, true});
    } else {
        computed->entry.formula.text = text;
        computed->math.reset(); // its samples were another formula's
    }
    advance();
    Q_EMIT changed();
    Q_EMIT advanced();
    return true;
}

void MathChannels::remove(const QString &name)
{
    const auto found = std::find_if(m_computed.begin(), m_computed.end(),
        [&name](const auto &computed) { return computed->entry.formula.name == name; });
    if (found == m_computed.end())
        return;
    dropChannel(**found);
    m_computed.erase(found);
    advance(); // those that used it have to wait now
    Q_EMIT changed();
}

void MathChannels::setShown(const QString &name, bool shown)
{
    Computed *computed = find(name);
    if (!computed || computed->entry.formula.shown == shown)
        return;
    computed->entry.formula.shown = shown;
    Q_EMIT changed();
}

void MathChannels::dropChannel(Computed &computed)
{
    const capture::ChannelId channel = std::exchange(computed.entry.channel, 0);
    computed.math.reset();
    computed.inputs.clear();
    computed.entry.unit.clear();
    if (channel == 0)
        return;
    Q_EMIT goes(channel);
    m_capture.removeImported(channel);
}

/// A new one, in the place of that which it may have had.
void MathChannels::makeChannel(Computed &computed, const std::string &unit)
{
    const capture::ChannelId before = computed.entry.channel;
    computed.entry.unit = deviceText(unit);
    computed.entry.channel =
        m_capture.addImported(computed.entry.formula.name.toStdString(), unit, computed.registerId);
    Q_EMIT made(computed.entry.formula.name, before);
    if (before != 0)
        m_capture.removeImported(before);
    Q_EMIT changed();
}

/// Still those that were recorded last under their registers.
bool MathChannels::inputsAreThere(const Computed &computed) const
{
    return std::all_of(
        computed.inputs.begin(), computed.inputs.end(), [this](capture::ChannelId id) {
            const auto info = m_capture.info(id);
            return info && m_capture.find(info->registerId) == id;
        });
}

/// Finds its signals; false if one of them is not there.
bool MathChannels::compile(std::size_t index)
{
    Computed &computed = *m_computed[index];
    const std::vector<scope::FormulaName> known = namesFor(index);
    auto formula = scope::Formula::compile(computed.entry.formula.text.toStdString(), known);
    if (!formula || formula->used().empty())
        return false;
    computed.inputs.clear();
    const auto all = m_capture.channels();
    for (const std::size_t used : formula->used()) {
        const auto info = std::find_if(
            all.begin(), all.end(), [&](const auto &one) { return one.name == known[used].name; });
        computed.inputs.push_back(m_capture.find(info->registerId).value_or(info->id));
    }
    const std::string unit = formula->unit();
    computed.math.emplace(std::move(*formula));
    makeChannel(computed, unit);
    return true;
}

/// True once its signals are there and it can be computed from them.
bool MathChannels::prepare(std::size_t index)
{
    Computed &computed = *m_computed[index];
    if (computed.entry.channel != 0 && !m_capture.channel(computed.entry.channel)) {
        computed.entry.channel = 0; // the recording was cleared
        computed.math.reset();
    }
    if ((computed.math && inputsAreThere(computed)) || compile(index))
        return true;
    if (computed.entry.channel != 0) {
        dropChannel(computed);
        Q_EMIT changed();
    }
    return false;
}

/// Up to where nothing is missing that may still come: what is neither streamed nor asked for any more is complete.
std::optional<scope::Nanos> MathChannels::until(
    std::span<const capture::Channel *const> inputs) const
{
    const auto streaming = m_capture.streaming();
    const auto polled = m_polled ? m_polled() : std::vector<catalog::RegisterId>();
    std::vector<const capture::Channel *> growing;
    for (const capture::Channel *input : inputs) {
        const capture::ChannelInfo &info = input->info();
        const bool asked = info.kind == capture::ChannelInfo::Kind::Polled
            && std::find(polled.begin(), polled.end(), info.registerId) != polled.end();
        const bool streamed =
            std::find(streaming.begin(), streaming.end(), info.id) != streaming.end();
        if (asked || streamed || isMine(info.id))
            growing.push_back(input);
    }
    if (growing.empty())
        return std::numeric_limits<scope::Nanos>::max();
    return scope::settledUntil(growing);
}

/// @return  true if there is a rest
bool MathChannels::step(std::size_t index)
{
    if (!prepare(index))
        return false;
    Computed &computed = *m_computed[index];
    std::vector<const capture::Channel *> inputs;
    for (const capture::ChannelId id : computed.inputs)
        inputs.push_back(m_capture.channel(id));
    const auto settled = until(inputs);
    if (!settled)
        return false;
    const bool rest = computed.math->update(inputs, *settled, kInstantsAtOnce / m_computed.size());
    const scope::MathResults &results = computed.math->results();
    const capture::ChannelId to = computed.entry.channel;
    std::span<const capture::Nanos> times(results.times);
    std::span<const double> values(results.values);
    for (const scope::MathResults::Piece &piece : results.pieces) {
        if (piece.begins)
            m_capture.breakImported(to);
        m_capture.appendImported(
            to, times.first(piece.count), values.first(piece.count), piece.holdUntil);
        times = times.subspan(piece.count);
        values = values.subspan(piece.count);
    }
    m_capture.keepNewest(to, kMostValues / m_computed.size());
    return rest;
}

void MathChannels::advance()
{
    if (m_advancing)
        return;
    m_advancing = true;
    bool rest = false;
    for (std::size_t i = 0; i < m_computed.size(); ++i)
        rest = step(i) || rest;
    m_advancing = false;
    if (rest)
        m_rest.start();
}

} // namespace widgets
