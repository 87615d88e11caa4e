#include "widgets/registers/model.h"

#include "widgets/base/device_text.h"
#include "widgets/base/register_texts.h"
#include "widgets/base/value_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QMimeData>

#include <utility>

namespace widgets {
namespace {

constexpr Milliseconds kPollPeriod{100}; ///< of what is on screen
constexpr Milliseconds kLongestInterval{
    800}; ///< a longer one is no period: it was not asked for meanwhile

QString fromCore(const std::string &text) { return QString::fromUtf8(text); }

bool shown(const catalog::RegisterInfo &info)
{
    return !info.stub
        && (info.readable() || info.streaming != catalog::Streaming::Polled
            || (info.writable() && info.type != catalog::ValueType::Raw));
}

} // namespace

RegisterModel::RegisterModel(QObject *parent)
    : QAbstractItemModel(parent)
{
}

void RegisterModel::setCatalog(std::shared_ptr<const catalog::Catalog> catalog, int motor)
{
    beginResetModel();
    const auto before = std::exchange(m_catalog, std::move(catalog));
    m_motor = motor;
    m_rows.clear();
    m_byId.clear();
    if (m_catalog) {
        for (const catalog::RegisterInfo &info : m_catalog->registers()) {
            if (!shown(info))
                continue;
            Row row;
            row.id = m_catalog->withMotor(info, motor);
            row.info = &info;
            row.scale = m_catalog->readScale(row.id);
            m_byId[row.id] = m_rows.size();
            m_rows.push_back(std::move(row));
        }
    }
    keepEdits(before.get());
    rebuildGroups();
    endResetModel();
    Q_EMIT catalogSet();
    Q_EMIT editsChanged();
}

void RegisterModel::rebuildGroups()
{
    m_groups.clear();
    Group pinnedGroup{tr("Pinned"), {}};
    for (const QString &name : m_pinned)
        for (std::size_t i = 0; i < m_rows.size(); ++i)
            if (fromCore(m_rows[i].info->name).compare(name, Qt::CaseInsensitive) == 0)
                pinnedGroup.rows.push_back(i);
    if (!pinnedGroup.rows.empty())
        m_groups.push_back(std::move(pinnedGroup));

    std::unordered_map<std::string, std::size_t> byName;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const auto [found, isNew] = byName.try_emplace(m_rows[i].info->group, m_groups.size());
        if (isNew) {
            const QString name = registerGroupText(m_rows[i].info->group);
            m_groups.push_back({name.isEmpty() ? tr("Other registers") : name, {}});
        }
        m_groups[found->second].rows.push_back(i);
    }
}

std::optional<catalog::RegisterId> RegisterModel::idOf(std::string_view name) const
{
    const catalog::RegisterInfo *info = m_catalog ? m_catalog->find(name) : nullptr;
    if (info == nullptr)
        return {};
    const catalog::RegisterId id = m_catalog->withMotor(*info, m_motor);
    return find(id) ? std::optional(id) : std::nullopt;
}

void RegisterModel::accept(const std::vector<drive::Reading> &readings, Milliseconds now)
{
    std::vector<std::size_t> changed;
    for (const drive::Reading &reading : readings) {
        const auto found = m_byId.find(reading.id);
        if (found == m_byId.end())
            continue;
        Row &row = m_rows[found->second];
        if (reading.status == drive::ReadStatus::Ok) {
            if (row.known == Known::Value)
                row.interval = now - row.at <= kLongestInterval ? now - row.at : Milliseconds{};
            row.known = Known::Value;
            row.value = reading.value;
            row.at = now;
            row.stale = !m_believed;
        } else {
            const bool refused = reading.status == drive::ReadStatus::Refused;
            row.known = refused ? Known::Refused : Known::NotSupported;
        }
        changed.push_back(found->second);
    }
    rowsChanged(changed);
}

void RegisterModel::refresh(Milliseconds now)
{
    endFlashes(now);
    markStale(now);
}

void RegisterModel::setBelieved(bool believed)
{
    if (std::exchange(m_believed, believed) != believed)
        Q_EMIT headerDataChanged(Qt::Horizontal, ValueColumn, ValueColumn);
    if (!believed) // fresh values clear the mark one by one
        markStale({});
}

void RegisterModel::markStale(Milliseconds now)
{
    std::vector<std::size_t> changed;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        Row &row = m_rows[i];
        const bool holds = m_believed && now - row.at <= 3 * std::max(kPollPeriod, row.interval);
        if (row.known != Known::Value || row.stale || holds)
            continue;
        row.stale = true;
        changed.push_back(i);
    }
    rowsChanged(changed);
}

std::optional<double> RegisterModel::shownValue(catalog::RegisterId id) const
{
    const Row *row = find(id);
    if (!row || row->known != Known::Value || row->stale)
        return {};
    const double number = rawNumber(row->value) * row->scale.factor;
    return number == number ? std::optional(number) : std::nullopt;
}

std::optional<catalog::Value> RegisterModel::current(catalog::RegisterId id) const
{
    const Row *row = find(id);
    return row && row->known == Known::Value && !row->stale ? std::optional(row->value)
                                                            : std::nullopt;
}

QString RegisterModel::text(catalog::RegisterId id) const
{
    const Row *row = find(id);
    if (!row || row->known != Known::Value || row->stale)
        return QStringLiteral("\u2013");
    return shownText(*row->info, row->value, row->scale);
}

bool RegisterModel::supported(catalog::RegisterId id) const
{
    const Row *row = find(id);
    return row && row->known != Known::NotSupported;
}

bool RegisterModel::pollable(catalog::RegisterId id) const
{
    const Row *row = find(id);
    return row && row->info->readable() && row->known != Known::NotSupported;
}

void RegisterModel::setPinned(const QStringList &names)
{
    beginResetModel();
    m_pinned = names;
    rebuildGroups();
    endResetModel();
}

void RegisterModel::togglePinned(catalog::RegisterId id)
{
    const Row *row = find(id);
    if (!row)
        return;
    const QString name = fromCore(row->info->name);
    QStringList names = m_pinned;
    if (names.removeAll(name) == 0)
        names.append(name);
    setPinned(names);
}

const RegisterModel::Row *RegisterModel::find(catalog::RegisterId id) const
{
    const auto found = m_byId.find(id);
    return found == m_byId.end() ? nullptr : &m_rows[found->second];
}

/// One change a group: a view looks once, however many came together.
void RegisterModel::rowsChanged(const std::vector<std::size_t> &changed)
{
    const auto hasChanged = [&changed](std::size_t row) {
        return std::find(changed.begin(), changed.end(), row) != changed.end();
    };
    for (std::size_t g = 0; g < m_groups.size() && !changed.empty(); ++g) {
        const auto &rows = m_groups[g].rows;
        const auto first = std::find_if(rows.begin(), rows.end(), hasChanged);
        if (first == rows.end())
            continue;
        const auto last = std::find_if(rows.rbegin(), rows.rend(), hasChanged).base() - 1;
        const QModelIndex group = index(static_cast<int>(g), 0);
        Q_EMIT dataChanged(index(static_cast<int>(first - rows.begin()), NameColumn, group),
            index(static_cast<int>(last - rows.begin()), ColumnCount - 1, group));
    }
}

void RegisterModel::rowChanged(catalog::RegisterId id)
{
    if (const auto found = m_byId.find(id); found != m_byId.end())
        rowsChanged({found->second});
}

QModelIndex RegisterModel::indexOf(catalog::RegisterId id, Column column) const
{
    const auto found = m_byId.find(id);
    if (found == m_byId.end())
        return {};
    for (std::size_t g = m_groups.size(); g-- > 0;) { // its own group comes after the pinned one
        const auto &rows = m_groups[g].rows;
        const auto at = std::find(rows.begin(), rows.end(), found->second);
        if (at != rows.end())
            return index(
                static_cast<int>(at - rows.begin()), column, index(static_cast<int>(g), 0));
    }
    return {};
}

// Groups carry internal id 0, registers the number of their group plus one.
QModelIndex RegisterModel::index(int row, int column, const QModelIndex &parentIndex) const
{
    if (!hasIndex(row, column, parentIndex))
        return {};
    return createIndex(row, column,
        parentIndex.isValid() ? static_cast<quintptr>(parentIndex.row()) + 1 : quintptr{0});
}

QModelIndex RegisterModel::parent(const QModelIndex &child) const
{
    if (!child.isValid() || child.internalId() == 0)
        return {};
    return createIndex(static_cast<int>(child.internalId() - 1), 0, quintptr{0});
}

int RegisterModel::rowCount(const QModelIndex &parentIndex) const
{
    if (!parentIndex.isValid())
        return static_cast<int>(m_groups.size());
    if (parentIndex.internalId() != 0 || parentIndex.column() != 0)
        return 0;
    return static_cast<int>(m_groups[static_cast<std::size_t>(parentIndex.row())].rows.size());
}

const RegisterModel::Row *RegisterModel::rowAt(const QModelIndex &index) const
{
    if (!index.isValid() || index.internalId() == 0)
        return nullptr;
    const Group &group = m_groups[static_cast<std::size_t>(index.internalId() - 1)];
    return &m_rows[group.rows[static_cast<std::size_t>(index.row())]];
}

Qt::ItemFlags RegisterModel::flags(const QModelIndex &index) const
{
    const Qt::ItemFlags base = QAbstractItemModel::flags(index);
    const Row *row = rowAt(index);
    if (!row)
        return base;
    const bool scalar =
        row->info->type != catalog::ValueType::Text && row->info->type != catalog::ValueType::Raw;
    Qt::ItemFlags flags = base | Qt::ItemNeverHasChildren;
    flags.setFlag(Qt::ItemIsDragEnabled,
        scalar && (row->info->readable() || row->info->streaming != catalog::Streaming::Polled));
    flags.setFlag(Qt::ItemIsEditable, editable(row->id, index.column()));
    return flags;
}

QStringList RegisterModel::mimeTypes() const { return {QString::fromLatin1(kRegisterMimeType)}; }

QMimeData *RegisterModel::mimeData(const QModelIndexList &indexes) const
{
    QJsonArray ids;
    for (const QModelIndex &index : indexes) {
        const Row *row = rowAt(index);
        if (row && index.column() == NameColumn && !ids.contains(QJsonValue(double(row->id))))
            ids.append(double(row->id));
    }
    if (ids.isEmpty())
        return nullptr;
    auto *data = new QMimeData;
    data->setData(
        QString::fromLatin1(kRegisterMimeType), QJsonDocument(ids).toJson(QJsonDocument::Compact));
    return data;
}

} // namespace widgets
