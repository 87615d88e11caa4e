#include "session/recording/lent_note.h"

#include "lab/runner.h"
#include "session/files/whole_file.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace session {

namespace {

constexpr QLatin1String kRegisters("registers"), kId("id"), kName("name"), kHeld("held");

QString noteName(const drive::Identity &identity)
{
    QCryptographicHash hash(QCryptographicHash::Sha1);
    const auto add = [&hash](const std::string &text) {
        hash.addData(QByteArray::fromStdString(text) + '\0');
    };
    add(identity.firmware);
    add(identity.version);
    add(identity.controlBoard);
    std::ranges::for_each(identity.powerBoards, add);
    std::ranges::for_each(identity.motorNames, add);
    return QString::fromLatin1(hash.result().toHex().left(16)) + QStringLiteral(".json");
}

} // namespace

QString lentFolder()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation))
        .filePath(QStringLiteral("rotorscope/borrowed"));
}

LentNote::LentNote(QString folder)
    : m_folder(std::move(folder))
{
}

void LentNote::begin(const Endpoint &endpoint)
{
    m_keeps = endpoint.kind == Endpoint::Kind::Serial;
    m_path.clear();
    m_catalog.reset();
    m_held.clear();
    m_lent.clear();
    m_lending = 0;
    m_fresh.clear();
    tell();
}

void LentNote::tell()
{
    if (m_lent.empty() && !m_told)
        return;
    m_told = !m_lent.empty();
    std::vector<lab::Lent> lent;
    std::vector<drive::RegisterWrite> back;
    for (const auto &[id, one] : m_lent) {
        lent.push_back(one);
        // The file may be older than the table of registers, or of another board: its number alone names none.
        const catalog::RegisterInfo *info =
            m_catalog->nameOf(id) == one.name ? m_catalog->find(id) : nullptr;
        if (auto value = info != nullptr ? lab::typedValue(one.held, info->type) : std::nullopt)
            back.push_back({id, std::move(*value)});
    }
    std::string texts;
    for (const std::string &text : lab::leftTexts(lent))
        texts += (texts.empty() ? "" : "; ") + text;
    Q_EMIT left(QString::fromStdString(texts), back);
}

void LentNote::onEvent(const drive::Event &event, TimePoint)
{
    if (const auto *board = std::get_if<drive::Identified>(&event))
        meet(*board);
    else if (const auto *read = std::get_if<drive::RegistersRead>(&event)) {
        for (const drive::Reading &reading : read->readings)
            if (reading.status == drive::ReadStatus::Ok)
                m_held.insert_or_assign(reading.id, reading.value);
    } else if (const auto *ended = std::get_if<drive::Ended>(&event)) {
        if (!m_lent.empty())
            written(*ended);
    }
}

void LentNote::meet(const drive::Identified &board)
{
    if (board.catalog == m_catalog)
        return; // told again, and not met: an experiment may be at work
    m_catalog = board.catalog;
    if (!m_keeps)
        return tell(); // the same one again
    m_path = QDir(m_folder).filePath(noteName(board.identity));
    m_lent.clear();
    const auto content = readWholeFile(m_path, kMostText);
    const QJsonArray all =
        QJsonDocument::fromJson(content.value_or(QByteArray())).object()[kRegisters].toArray();
    for (const auto &each : all) {
        const QJsonObject one = each.toObject();
        const auto id = static_cast<drive::RegisterId>(one[kId].toInteger());
        m_lent[id] = {one[kName].toString().toStdString(), one[kHeld].toString().toStdString()};
    }
    tell();
}

/// Of one that was left before it is known what it held.
/// @return  it was not on the note
bool LentNote::borrow(drive::RegisterId id)
{
    const auto held = m_held.find(id);
    return held != m_held.end()
        && m_lent.try_emplace(id, lab::Lent{m_catalog->nameOf(id), lab::typedText(held->second)})
               .second;
}

/// What an experiment writes is borrowed, but where it is what the register held before: it is given back then, or was
/// never anything else.
void LentNote::onWish(const drive::Wish &wish, TimePoint)
{
    if (wish.id < lab::Runner::kFirstWish || !m_catalog)
        return;
    if (const auto *ramp = std::get_if<drive::SpeedRamp>(&wish.what))
        return borrowWay(ramp->motor);
    const auto *write = std::get_if<drive::Write>(&wish.what);
    if (write == nullptr)
        return;
    const auto isBack = [this](const drive::RegisterWrite &one) {
        const auto lent = m_lent.find(one.id);
        const auto held = m_held.find(one.id);
        const std::string value = lab::typedText(one.value);
        return lent != m_lent.end() ? lent->second.held == value
                                    : held != m_held.end() && lab::typedText(held->second) == value;
    };
    if (std::ranges::all_of(write->writes, isBack))
        return;
    m_lending = wish.id;
    m_fresh.clear();
    for (const drive::RegisterWrite &one : write->writes)
        if (borrow(one.id))
            m_fresh.insert(one.id);
    save();
}

/// A servo drive is told with each speed how to go there. Whether a ramp that was refused had written some of that is
/// not known: it stays until it was written back.
void LentNote::borrowWay(int motor)
{
    bool more = false;
    for (const std::string_view name : m_catalog->start().way)
        if (const catalog::RegisterInfo *info = m_catalog->find(name))
            more = borrow(m_catalog->withMotor(*info, motor)) || more;
    if (more)
        save();
}

void LentNote::written(const drive::Ended &ended)
{
    const std::size_t before = m_lent.size();
    if (ended.id == m_lending)
        notBorrowed(ended);
    else
        for (const drive::WriteResult &one : ended.writes)
            if (one.outcome == drive::Outcome::Ok && one.verified.value_or(false))
                m_lent.erase(one.id);
    if (m_lent.size() == before)
        return;
    save();
    if (m_told)
        tell();
}

/// Off the note is what this write put on it and certainly did not change: it was not sent, or refused and nothing else
/// is read back. What is doubtful stays, and what an earlier write has borrowed.
void LentNote::notBorrowed(const drive::Ended &ended)
{
    for (const drive::RegisterId id : std::exchange(m_fresh, {})) {
        const auto at = m_lent.find(id);
        if (at == m_lent.end())
            continue;
        const auto one = std::ranges::find(ended.writes, id, &drive::WriteResult::id);
        const bool listed = one != ended.writes.end();
        const drive::Outcome outcome = listed ? one->outcome : ended.outcome;
        const bool changed =
            listed && one->readBack && lab::typedText(*one->readBack) != at->second.held;
        if (outcome == drive::Outcome::NotSent || (outcome == drive::Outcome::Refused && !changed))
            m_lent.erase(at);
    }
}

/// Whole or not at all. What cannot be kept is as it was without it: an experiment says at its end what it leaves.
void LentNote::save() const
{
    if (m_path.isEmpty())
        return;
    if (m_lent.empty()) {
        QFile::remove(m_path);
        return;
    }
    QJsonArray all;
    for (const auto &[id, lent] : m_lent)
        all.append(
            QJsonObject{{kId, static_cast<qint64>(id)}, {kName, QString::fromStdString(lent.name)},
                {kHeld, QString::fromStdString(lent.held)}});
    QDir().mkpath(m_folder);
    QFile file(m_path + QStringLiteral(".part"));
    const QByteArray content = QJsonDocument(QJsonObject{{kRegisters, all}}).toJson();
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size() || !file.flush())
        return;
    file.close();
    std::error_code failed;
    std::filesystem::rename(
        QFileInfo(file).filesystemFilePath(), QFileInfo(m_path).filesystemFilePath(), failed);
}

Parts noted(const Parts &parts, const std::shared_ptr<LentNote> &note)
{
    Parts result = listened(parts, note);
    result.drive = [makeDrive = result.drive, note](const Endpoint &endpoint) {
        note->begin(endpoint);
        return makeDrive(endpoint);
    };
    return result;
}

} // namespace session
