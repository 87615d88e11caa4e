// Any text as each of the JSON files that Rotorscope reads: it is taken whole or refused, and what was taken is the
// same after writing and reading it again. The first byte chooses the reader.
#include "fuzz/script.h"
#include "session/files/fcp_rig_file.h"
#include "session/files/mcb_rig_file.h"
#include "session/files/motor_file.h"
#include "session/files/rev_up_json.h"
#include "session/files/run.h"
#include "session/files/snapshot_json.h"

namespace {

void snapshot(const QByteArray &text)
{
    const auto read = session::readSnapshotJson(text);
    if (!read)
        return fuzz::require(read.error().line >= 0 && read.error().number >= 0);
    const QByteArray ours = session::snapshotJson(*read);
    const auto again = session::readSnapshotJson(ours);
    fuzz::require(again.has_value() && session::snapshotJson(*again) == ours);
}

void motorFile(const QByteArray &text)
{
    const auto read = session::readMotor(text);
    if (!read)
        return fuzz::require(!session::motorFileErrorText("file", read.error()).empty());
    const auto again = session::readMotor(session::motorJson(read->sheet()));
    if (again) // a sheet may have less than a machine needs
        fuzz::require(session::motorJson(again->sheet()) == session::motorJson(read->sheet()));
}

void revUp(const QByteArray &text)
{
    constexpr double kAmpsPerDigit = 0.001;
    for (const double scale : {0.0, kAmpsPerDigit}) {
        const auto read = session::readRevUpJson(text, scale);
        if (!read)
            continue;
        const QByteArray ours = session::revUpJson(*read, scale);
        const auto again = session::readRevUpJson(ours, scale);
        fuzz::require(again.has_value() && session::revUpJson(*again, scale) == ours);
    }
}

void run(const QByteArray &text)
{
    const auto read = session::readRunJson(text);
    if (!read)
        return fuzz::require(!read.error().isEmpty());
    const auto again = session::readRunJson(session::runJson(*read));
    fuzz::require(again.has_value() && *again == *read);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size == 0)
        return 0;
    const QByteArray text(
        reinterpret_cast<const char *>(data + 1), static_cast<qsizetype>(size - 1));
    switch (data[0] % 6) {
    case 0:
        snapshot(text);
        break;
    case 1:
        motorFile(text);
        break;
    case 2:
        revUp(text);
        break;
    case 3:
        if (const auto rig = session::readFcpRig(text); !rig)
            fuzz::require(!rig.error().empty());
        break;
    case 4:
        if (const auto rig = session::readMcbRig(text); !rig)
            fuzz::require(!rig.error().isEmpty());
        break;
    default:
        run(text);
        break;
    }
    return 0;
}
