// The edits of a RegisterModel: what the user wants to be written, and how each write ended.
#include "widgets/base/device_text.h"
#include "widgets/base/fields/stepped_edit.h"
#include "widgets/base/value_text.h"
#include "widgets/registers/model.h"

#include <QColor>

#include <algorithm>

namespace widgets {
namespace {

constexpr Milliseconds kFlash{1500};

// Black text stays readable on each of them, in both themes; the states differ in lightness, too.
QColor colorOf(RegisterModel::EditState state)
{
    switch (state) {
    case RegisterModel::EditState::Pending:
        return QColor(0xff, 0xc1, 0x4d);
    case RegisterModel::EditState::Sending:
    case RegisterModel::EditState::Unproved: // neither is proved; their signs differ
        return QColor(0xff, 0xe0, 0xa8);
    case RegisterModel::EditState::Verified:
        return QColor(0x7f, 0xd8, 0x8f);
    case RegisterModel::EditState::Refused:
        return kRefusedColor;
    case RegisterModel::EditState::None:
        break;
    }
    return {};
}

/// The board took it a moment ago, and it is shown for so long: no edit any more.
bool flashes(RegisterModel::EditState state)
{
    return state == RegisterModel::EditState::Verified
        || state == RegisterModel::EditState::Unproved;
}

} // namespace

const RegisterModel::Edit *RegisterModel::editOf(catalog::RegisterId id) const
{
    const auto found = std::find_if(
        m_edits.begin(), m_edits.end(), [id](const Edit &edit) { return edit.id == id; });
    return found == m_edits.end() ? nullptr : &*found;
}

RegisterModel::Edit &RegisterModel::edit(catalog::RegisterId id)
{
    const auto found = std::find_if(
        m_edits.begin(), m_edits.end(), [id](const Edit &edit) { return edit.id == id; });
    return found == m_edits.end() ? m_edits.emplace_back(Edit{id, {}, {}, {}, {}}) : *found;
}

RegisterModel::EditState RegisterModel::editState(catalog::RegisterId id) const
{
    const Edit *edit = editOf(id);
    return edit ? edit->state : EditState::None;
}

bool RegisterModel::hasEdits() const
{
    return std::any_of(
        m_edits.begin(), m_edits.end(), [](const Edit &edit) { return !flashes(edit.state); });
}

QStringList RegisterModel::pendingElsewhere() const
{
    QStringList names;
    for (const Edit &edit : m_edits)
        if (edit.state == EditState::Pending && m_catalog && !find(edit.id))
            names.append(deviceText(m_catalog->nameOf(edit.id)));
    return names;
}

std::optional<EntryRules> RegisterModel::rulesOf(catalog::RegisterId id) const
{
    const catalog::RegisterInfo *info = m_catalog ? m_catalog->find(id) : nullptr;
    if (info == nullptr || !info->writable() || info->stub)
        return {};
    const auto motor = static_cast<std::size_t>(std::max(1, m_catalog->motorOf(id)) - 1);
    return entryRules(*info, m_catalog->readScale(id),
        motor < m_limits.size() ? m_limits[motor] : drive::MotorLimits{});
}

bool RegisterModel::editable(catalog::RegisterId id, int column) const
{
    const Row *row = find(id);
    if (!row || row->known == Known::NotSupported || !rulesOf(id)
        || (column != ValueColumn && column != RawColumn))
        return false;
    if (row->info->type == catalog::ValueType::Text)
        return false;
    return column == RawColumn || row->info->type != catalog::ValueType::Raw;
}

Result<catalog::Value, EntryError> RegisterModel::readEntry(
    catalog::RegisterId id, int column, const QString &text) const
{
    const auto rules = rulesOf(id);
    if (!rules)
        return fail(EntryError::CannotBeTyped);
    return column == RawColumn ? readRawEntry(text, *rules) : readShownEntry(text, *rules);
}

bool RegisterModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    const Row *row = rowAt(index);
    if (!row || role != Qt::EditRole || !editable(row->id, index.column()))
        return false;
    const auto read = readEntry(row->id, index.column(), value.toString());
    return read && setPending(row->id, *read);
}

bool RegisterModel::setPending(catalog::RegisterId id, const catalog::Value &value)
{
    const auto rules = rulesOf(id);
    const Edit *before = editOf(id);
    if (!rules || (before && before->state == EditState::Sending) // first its own end
        || !catalog::refuseValue(*rules->info, value).empty())
        return false;
    const bool sameAsBoard = known(id) == value;
    if (before && (sameAsBoard || before->state != EditState::Pending))
        std::erase_if(m_edits, [id](const Edit &edit) { return edit.id == id; });
    if (!sameAsBoard) {
        Edit &wanted = edit(id);
        wanted.wanted = value;
        wanted.state = EditState::Pending;
        wanted.reason.clear();
    }
    rowChanged(id);
    Q_EMIT editsChanged();
    return true;
}

std::vector<drive::RegisterWrite> RegisterModel::pending() const
{
    std::vector<drive::RegisterWrite> writes;
    for (const Edit &edit : m_edits)
        if (edit.state == EditState::Pending)
            writes.push_back({edit.id, edit.wanted});
    return writes;
}

void RegisterModel::forgetEdits(const std::function<bool(catalog::RegisterId)> &of)
{
    const auto end = std::stable_partition(m_edits.begin(), m_edits.end(), [&of](const Edit &edit) {
        return edit.state == EditState::Sending || (of && !of(edit.id));
    });
    const std::vector<Edit> gone(end, m_edits.end());
    m_edits.erase(end, m_edits.end());
    for (const Edit &edit : gone)
        rowChanged(edit.id);
    Q_EMIT editsChanged();
}

void RegisterModel::markSending(const std::vector<drive::RegisterWrite> &writes)
{
    for (Edit &edit : m_edits)
        if (edit.state == EditState::Pending
            && std::find(writes.begin(), writes.end(), drive::RegisterWrite{edit.id, edit.wanted})
                != writes.end()) {
            edit.state = EditState::Sending;
            rowChanged(edit.id);
        }
    Q_EMIT editsChanged();
}

void RegisterModel::markNotSent()
{
    for (Edit &edit : m_edits)
        if (edit.state == EditState::Sending) {
            edit.state = EditState::Pending;
            rowChanged(edit.id);
        }
    Q_EMIT editsChanged();
}

void RegisterModel::onResults(const std::vector<drive::WriteResult> &results)
{
    for (const drive::WriteResult &result : results) {
        const Edit *before = editOf(result.id);
        const bool typed = before != nullptr;
        if (typed && before->state == EditState::Pending && result.readBack != before->wanted) {
            rowChanged(result.id);
            continue;
        }
        const bool wrong = result.verified == false;
        const QString reason = deviceText(result.reason);
        if (result.outcome == drive::Outcome::NotSent && typed) {
            edit(result.id).state = EditState::Pending;
            edit(result.id).reason = tr("Not sent: %1", "the reason").arg(reason);
        } else if (result.outcome == drive::Outcome::Ok && !wrong) {
            Edit &done = edit(result.id);
            done.state = result.verified ? EditState::Verified : EditState::Unproved;
            done.reason = reason;
            done.until.reset();
        } else if (typed) {
            Edit &refused = edit(result.id);
            refused.state = EditState::Refused;
            refused.reason = wrong && result.readBack
                ? tr("Written, but the board holds %1.").arg(describe(result.id, *result.readBack))
                : result.outcome == drive::Outcome::Unknown
                ? tr("Sent, outcome unknown: %1").arg(reason)
                : tr("Refused: %1", "the board's reason").arg(reason);
        }
        rowChanged(result.id);
    }
    Q_EMIT editsChanged();
}

void RegisterModel::endFlashes(Milliseconds now)
{
    std::vector<catalog::RegisterId> over;
    for (Edit &edit : m_edits) {
        if (!flashes(edit.state))
            continue;
        if (!edit.until)
            edit.until = now + kFlash;
        else if (now >= *edit.until)
            over.push_back(edit.id);
    }
    for (const catalog::RegisterId id : over) {
        std::erase_if(m_edits, [id](const Edit &edit) { return edit.id == id; });
        rowChanged(id);
    }
}

/// After a change of board or motor: only what can still be written as it was typed, and means the same.
void RegisterModel::keepEdits(const catalog::Catalog *before)
{
    std::erase_if(m_edits, [this, before](const Edit &edit) {
        const auto rules = rulesOf(edit.id);
        const bool otherScale = rules && edit.state != EditState::Sending && before != nullptr
            && before->readScale(edit.id) != rules->scale;
        return !rules || otherScale || flashes(edit.state)
            || !catalog::refuseValue(*rules->info, edit.wanted).empty();
    });
}

std::optional<catalog::Value> RegisterModel::known(catalog::RegisterId id) const
{
    const Row *row = find(id);
    return row && row->known == Known::Value ? std::optional(row->value) : std::nullopt;
}

std::optional<catalog::Value> RegisterModel::wanted(catalog::RegisterId id) const
{
    const Edit *edit = editOf(id);
    return edit && !flashes(edit->state) ? std::optional(edit->wanted) : known(id);
}

QString RegisterModel::describe(catalog::RegisterId id, const catalog::Value &value) const
{
    const catalog::RegisterInfo *info = m_catalog ? m_catalog->find(id) : nullptr;
    if (info == nullptr || info->type == catalog::ValueType::Raw)
        return rawText(value);
    return shownText(*info, value, m_catalog->readScale(id));
}

QString RegisterModel::copyText(catalog::RegisterId id) const
{
    const Row *row = find(id);
    if (!row)
        return {};
    return QStringList{deviceText(m_catalog->nameOf(id)), display(*row, ValueColumn).toString(),
        display(*row, RawColumn).toString()}
        .join(QLatin1Char('\t'));
}

QVariant RegisterModel::editBackground(const Row &row) const
{
    const EditState state = editState(row.id);
    return state == EditState::None ? QVariant() : QVariant(colorOf(state));
}

QString RegisterModel::editSentence(const Row &row) const
{
    const Edit *edit = editOf(row.id);
    if (!edit)
        return {};
    QStringList lines;
    const QString held = row.known == Known::Value
        ? tr("The board holds %1.").arg(describe(row.id, row.value))
        : QString();
    switch (edit->state) {
    case EditState::Pending:
        lines = {tr("Not written yet."), held, edit->reason};
        break;
    case EditState::Sending:
        lines = {tr("On its way to the board.")};
        break;
    case EditState::Verified:
        lines = {tr("Written and read back.")};
        break;
    case EditState::Unproved:
        lines = {edit->reason.isEmpty()
                ? tr("Written, not verified.")
                : tr("Written, not verified: %1", "the reason").arg(edit->reason)};
        break;
    case EditState::Refused:
        lines = {edit->reason, held};
        break;
    case EditState::None:
        break;
    }
    lines.removeAll(QString());
    return lines.join(QLatin1Char(' '));
}

QString RegisterModel::editToolTip(const Row &row) const
{
    if (editOf(row.id) != nullptr)
        return QStringLiteral("<b>%1</b>").arg(editSentence(row).toHtmlEscaped());
    return editable(row.id, RawColumn)
        ? tr("Double-click its value or press F2 to edit it.").toHtmlEscaped()
        : QString();
}

std::optional<std::int64_t> knownWhole(const RegisterModel &model, std::string_view name)
{
    const auto id = model.idOf(name);
    const auto value = id ? model.known(*id) : std::nullopt;
    const auto *whole = value ? std::get_if<std::int64_t>(&*value) : nullptr;
    return whole ? std::optional(*whole) : std::nullopt;
}

} // namespace widgets
