#include "session/mat_file.h"

#include "capture/csv_export.h"
#include "capture/rows.h"
#include "session/mat_library.h"

#include <QFile>
#include <QTemporaryDir>

#include <array>
#include <memory>

namespace session {

namespace {

using capture::Channel;
using capture::ChannelInfo;
using capture::Rows;

constexpr std::size_t kMostRows = (std::size_t{1} << 31) / sizeof(double) - 1024;
constexpr double kGathered = 0.3; ///< of all the time, about
constexpr double kPacked = 0.95;
constexpr qsizetype kLongestName = 31; ///< that libmatio and old MATLAB keep

struct CloseMat {
    void operator()(mat_t *file) const { matLibrary()->close(file); }
};
struct FreeVariable {
    void operator()(matvar_t *variable) const { matLibrary()->varFree(variable); }
};
using MatFile = std::unique_ptr<mat_t, CloseMat>;
using Variable = std::unique_ptr<matvar_t, FreeVariable>;

/// A structure for one rate.
struct Group {
    QString name;
    capture::Snapshot channels;
    Rows rows;
};

/// libmatio copies what it is given here.
matvar_t *columnOf(std::vector<double> &values)
{
    std::array<std::size_t, 2> size{values.size(), 1};
    return matLibrary()->varCreate(
        nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, size.data(), values.data(), 0);
}

matvar_t *textOf(const std::string &text)
{
    // UTF-16, which every reader of this version takes; UTF-8 some take for Latin-1.
    QString words = QString::fromStdString(text);
    std::array<std::size_t, 2> size{1, static_cast<std::size_t>(words.size())};
    return matLibrary()->varCreate(
        nullptr, MAT_C_CHAR, MAT_T_UTF16, 2, size.data(), words.data(), 0);
}

Variable emptyStruct(const QByteArray &name, const std::vector<QByteArray> &fields)
{
    std::vector<const char *> names;
    names.reserve(fields.size() + 1);
    for (const QByteArray &field : fields)
        names.push_back(field.constData());
    names.push_back(nullptr);
    const std::array<std::size_t, 2> one{1, 1};
    return Variable(matLibrary()->varCreateStruct(
        name.isEmpty() ? nullptr : name.constData(), 2, one.data(), names.data()));
}

/// A structure with a text for each signal.
Variable texts(const std::vector<QByteArray> &fields, const capture::Snapshot &channels,
    std::string ChannelInfo::*member)
{
    Variable structure = emptyStruct({}, fields);
    for (std::size_t i = 0; structure && i < fields.size(); ++i)
        matLibrary()->varSetField(
            structure.get(), fields[i].constData(), 0, textOf(channels->at(i).info().*member));
    return structure;
}

Variable structOf(Group &group)
{
    QStringList taken{QStringLiteral("time"), QStringLiteral("units"), QStringLiteral("names")};
    std::vector<QByteArray> signalFields;
    for (const Channel &channel : *group.channels) {
        taken.append(matName(QString::fromStdString(channel.info().name), taken));
        signalFields.push_back(taken.back().toLatin1());
    }
    std::vector<QByteArray> fields{"time"};
    fields.insert(fields.end(), signalFields.begin(), signalFields.end());
    fields.insert(fields.end(), {"units", "names"});
    Variable structure = emptyStruct(group.name.toLatin1(), fields);
    if (!structure)
        return nullptr;
    matvar_t *target = structure.get();
    matLibrary()->varSetField(target, "time", 0, columnOf(group.rows.time));
    for (std::size_t i = 0; i < signalFields.size(); ++i)
        matLibrary()->varSetField(
            target, signalFields[i].constData(), 0, columnOf(group.rows.columns[i]));
    matLibrary()->varSetField(
        target, "units", 0, texts(signalFields, group.channels, &ChannelInfo::unit).release());
    matLibrary()->varSetField(
        target, "names", 0, texts(signalFields, group.channels, &ChannelInfo::name).release());
    return structure;
}

std::vector<Group> groupsOf(
    const capture::Snapshot &channels, const std::optional<capture::TimeSpan> &range)
{
    std::vector<Group> groups;
    int polled = 0;
    for (const capture::Snapshot &part : capture::splitByRate(channels)) {
        QString name;
        switch (part->front().info().kind) {
        case ChannelInfo::Kind::Fast:
            name = QStringLiteral("fast");
            break;
        case ChannelInfo::Kind::Slow:
            name = QStringLiteral("slow");
            break;
        case ChannelInfo::Kind::Polled:
            name = QStringLiteral("polled%1").arg(++polled);
            break;
        }
        groups.push_back({name, part, capture::rowsOf(part, range)});
    }
    return groups;
}

/// libmatio does not look whether the disk took what it wrote: the file is read back before it is believed.
bool readsBack(const QByteArray &path, const std::vector<Group> &groups)
{
    const MatFile file(matLibrary()->open(path.constData(), MAT_ACC_RDONLY));
    for (const Group &group : groups) {
        const Variable read(
            file ? matLibrary()->varRead(file.get(), group.name.toLatin1().constData()) : nullptr);
        const matvar_t *time = read ? matLibrary()->varGetField(read.get(), "time", 0) : nullptr;
        const auto bytes = group.rows.time.size() * sizeof(double);
        if (!time || time->nbytes != bytes
            || (bytes > 0 && memcmp(time->data, group.rows.time.data(), bytes) != 0))
            return false;
    }
    return true;
}

bool writeGroups(const QByteArray &path, std::vector<Group> &groups)
{
    const MatFile file(
        matLibrary()->createVer(path.constData(), "MATLAB 5.0 MAT-file, Rotorscope", MAT_FT_MAT5));
    if (!file)
        return false;
    for (Group &group : groups) {
        const Variable structure = structOf(group);
        if (!structure
            || matLibrary()->varWrite(file.get(), structure.get(), MAT_COMPRESSION_ZLIB) != 0)
            return false;
    }
    return true;
}

} // namespace

QString matName(const QString &name, const QStringList &taken)
{
    QString field;
    for (const QChar c : name) {
        const bool plain = c.unicode() < 128 && c.isLetterOrNumber();
        field += plain ? c : QLatin1Char('_');
    }
    if (field.isEmpty() || !field.front().isLetter())
        field.prepend(QLatin1Char('x'));
    field.truncate(kLongestName);
    const QString whole = field;
    for (int i = 2; taken.contains(field); ++i) {
        const QString number = QStringLiteral("_%1").arg(i);
        field = whole.left(kLongestName - number.size()) + number;
    }
    return field;
}

MatResult writeMatFile(const QString &path, const capture::Snapshot &channels,
    const std::optional<capture::TimeSpan> &range, const std::function<bool(double)> &proceed)
{
    MatResult result;
    result.file.error = FileError::Cancelled;
    std::vector<Group> groups = groupsOf(channels, range);
    if (proceed && !proceed(kGathered))
        return result;
    result.file.error = FileError::None;
    for (const Group &group : groups) {
        result.rows += group.rows.time.size();
        result.tooLong = result.tooLong || group.rows.time.size() > kMostRows;
    }
    if (result.tooLong)
        return result;
    if (matLibrary() == nullptr) {
        result.file.error = FileError::CannotWrite;
        result.file.systemText = QStringLiteral("libmatio is not installed");
        return result;
    }
    // libmatio opens files by their names; from its own place the file then goes to where it is wanted, or nowhere.
    const QTemporaryDir folder;
    const QString temporary = folder.filePath(QStringLiteral("capture.mat"));
    const QByteArray name = QFile::encodeName(temporary);
    QFile made(temporary);
    if (!writeGroups(name, groups) || !readsBack(name, groups) || !made.open(QIODevice::ReadOnly)) {
        result.file.error = FileError::CannotWrite;
        result.file.systemText = QStringLiteral("there is no room for it in %1").arg(folder.path());
        return result;
    }
    result.file.error = FileError::Cancelled;
    if (proceed && !proceed(kPacked))
        return result;
    bool whole = true;
    QByteArray bytes;
    result.file = writePieces(
        path,
        [&](std::string_view &piece) {
            constexpr qint64 kPiece = 1 << 20;
            bytes = made.read(kPiece);
            whole = !bytes.isEmpty() || made.pos() == made.size();
            piece = {bytes.constData(), static_cast<std::size_t>(bytes.size())};
            return !piece.empty() || !whole;
        },
        [&] { return whole && (!proceed || proceed(1.0)); });
    if (!whole)
        result.file = {FileError::CannotWrite, made.errorString()};
    return result;
}

} // namespace session
