#include "session/files/mat_file.h"

#include "capture/csv_export.h"
#include "capture/rows.h"
#include "session/files/mat_library.h"
#include "session/files/mat_packing.h"

#include <QFile>
#include <QTemporaryDir>

#include <algorithm>
#include <array>
#include <memory>
#include <new>

namespace session {

namespace {

using capture::Channel;
using capture::ChannelInfo;
using capture::Rows;

constexpr double kGathered = 0.2; ///< of all the time, about
constexpr double kWritten = 0.3; ///< plain
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

/// libmatio copies what it is given here; false if there is no memory for that.
bool addColumn(matvar_t *structure, const char *field, std::vector<double> &values)
{
    std::array<std::size_t, 2> size{values.size(), 1};
    matvar_t *column = matLibrary()->varCreate(
        nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, size.data(), values.data(), 0);
    if (column)
        matLibrary()->varSetField(structure, field, 0, column);
    return column != nullptr;
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
    if (!addColumn(target, "time", group.rows.time))
        return nullptr;
    for (std::size_t i = 0; i < signalFields.size(); ++i) {
        if (!addColumn(target, signalFields[i].constData(), group.rows.columns[i]))
            return nullptr;
        std::vector<double>().swap(group.rows.columns[i]); // never all of it twice
    }
    matLibrary()->varSetField(
        target, "units", 0, texts(signalFields, group.channels, &ChannelInfo::unit).release());
    matLibrary()->varSetField(
        target, "names", 0, texts(signalFields, group.channels, &ChannelInfo::name).release());
    return structure;
}

/// How a structure for signals of this kind is called.
QString groupName(ChannelInfo::Kind kind, int &polled)
{
    switch (kind) {
    case ChannelInfo::Kind::Fast:
        return QStringLiteral("fast");
    case ChannelInfo::Kind::Slow:
        return QStringLiteral("slow");
    case ChannelInfo::Kind::Polled:
        break;
    }
    return QStringLiteral("polled%1").arg(++polled);
}

struct Gathered {
    std::vector<Group> groups;
    bool tooLong = false;
    bool cancelled = false;
};

Gathered gather(const capture::Snapshot &channels, const std::optional<capture::TimeSpan> &range,
    const std::function<bool(double)> &proceed, std::size_t mostBytes)
{
    Gathered result;
    int polled = 0;
    std::size_t before = 0; ///< bytes
    const std::vector<capture::Snapshot> parts = capture::splitByRate(channels);
    for (const capture::Snapshot &part : parts) {
        const std::size_t rowBytes = (part->size() + 1) * sizeof(double);
        const auto goesOn = [&](std::size_t rows, std::size_t least) {
            const std::size_t left = (mostBytes - before) / rowBytes;
            result.tooLong = result.tooLong || std::max(rows, least) > left;
            const double done = static_cast<double>(result.groups.size())
                + static_cast<double>(rows)
                    / static_cast<double>(std::max({rows, least, std::size_t{1}}));
            result.cancelled = result.cancelled
                || (proceed && !proceed(kGathered * done / static_cast<double>(parts.size())));
            return !result.tooLong && !result.cancelled;
        };
        Group group{groupName(part->front().info().kind, polled), part, {}};
        group.rows = capture::rowsOf(part, range, goesOn);
        if (!goesOn(group.rows.time.size(), 0))
            return result;
        before += group.rows.time.size() * rowBytes;
        result.groups.push_back(std::move(group));
    }
    return result;
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

/// @param done  told how many are written; false: these are enough
bool writeGroups(const QByteArray &path, std::vector<Group> &groups,
    const std::function<bool(std::size_t)> &done)
{
    const MatFile file(
        matLibrary()->createVer(path.constData(), "MATLAB 5.0 MAT-file, Rotorscope", MAT_FT_MAT5));
    if (!file)
        return false;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const Variable structure = structOf(groups[i]);
        if (!structure
            || matLibrary()->varWrite(file.get(), structure.get(), MAT_COMPRESSION_NONE) != 0
            || !done(i + 1))
            return false;
    }
    return true;
}

MatResult write(const QString &path, const capture::Snapshot &channels,
    const std::optional<capture::TimeSpan> &range, const std::function<bool(double)> &proceed,
    std::size_t mostBytes)
{
    MatResult result;
    auto [groups, tooLong, cancelled] = gather(channels, range, proceed, mostBytes);
    result.file.error = cancelled ? FileError::Cancelled : FileError::None;
    result.tooLong = tooLong && !cancelled;
    if (cancelled || tooLong)
        return result;
    for (const Group &group : groups)
        result.rows += group.rows.time.size();
    if (matLibrary() == nullptr) {
        result.file = {FileError::CannotWrite, QStringLiteral("libmatio is not installed")};
        return result;
    }
    // libmatio opens files by their names; from its own place the file then goes to where it is wanted, or nowhere.
    const QTemporaryDir folder;
    if (!folder.isValid()) {
        result.file = {FileError::CannotWrite, folder.errorString()};
        return result;
    }
    const QString temporary = folder.filePath(QStringLiteral("capture.mat"));
    const QByteArray name = QFile::encodeName(temporary);
    QFile made(temporary);
    bool stopped = false;
    const auto written = [&, count = static_cast<double>(groups.size())](std::size_t done) {
        stopped = proceed
            && !proceed(kGathered + (kWritten - kGathered) * static_cast<double>(done) / count);
        return !stopped;
    };
    const bool plain = writeGroups(name, groups, written);
    if (stopped) {
        result.file.error = FileError::Cancelled;
        return result;
    }
    if (!plain || !readsBack(name, groups) || !made.open(QIODevice::ReadOnly)) {
        result.file = {FileError::CannotWrite,
            QStringLiteral("there is no room for it in %1").arg(folder.path())};
        return result;
    }
    MatPacking packing(
        made, [&](double done) { return !proceed || proceed(kWritten + (1.0 - kWritten) * done); });
    result.file = writePieces(
        path, [&](std::string_view &piece) { return packing.next(piece); },
        [&] { return packing.goesOn(); });
    if (packing.failed())
        result.file = {
            FileError::CannotWrite, QStringLiteral("what was written could not be read back")};
    return result;
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
    const std::optional<capture::TimeSpan> &range, const std::function<bool(double)> &proceed,
    std::size_t mostBytes)
{
    try {
        return write(path, channels, range, proceed, mostBytes);
    } catch (const std::bad_alloc &) { // a thread that ends with it ends the program
        MatResult result;
        result.file = {FileError::CannotWrite, QStringLiteral("there is not enough memory for it")};
        return result;
    }
}

} // namespace session
