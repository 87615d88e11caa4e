#include "session/files/motor_file_st.h"

#include "motor/constants.h"
#include "session/files/json_text.h"
#include "simulation/plant/presets.h"

#include <QJsonObject>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace session {

namespace {

using Kind = MotorFileError::Kind;

constexpr double kMicro = 1e-6; // the profiler multiplies inertia and friction by a million

/// A number of the file and what it may be, in the file's own unit.
struct Key {
    const char *name;
    double least, most;
    bool whole = false;
};
constexpr Key kPolePairs{"polePairs", 1, 64, true}, kNominalCurrent{"nominalCurrent", 1e-3, 1e4},
    kResistance{"rs", 1e-4, 1e3}, kInductance{"ls", 1e-6, 1e3}, kKe{"BEmfConstant", 1e-4, 1e5},
    kMaxSpeed{"maxRatedSpeed", 6, 32767}, kBus{"nominalDCVoltage", 1, 1000},
    kInertia{"inertia", 0, 1e8}, kFriction{"friction", 0, 1e7}, kRatio{"ld_lq_ratio", 0.01, 100};
constexpr std::array kNumbers{kPolePairs, kNominalCurrent, kResistance, kInductance, kKe, kMaxSpeed,
    kBus, kInertia, kFriction};
/// Known, and of no use here.
constexpr std::array kOthers{"id", "label", "description", "hardwareFamily", "magneticStructure"};

class StReader {
public:
    explicit StReader(const QJsonObject &object)
        : m_object(object)
    {
    }

    Result<MotorFile, MotorFileError> read()
    {
        m_file.origin = MotorFile::Origin::St;
        m_file.machine = simulation::presets().front().parameters;
        takeName();
        takeFigures();
        takeInductances();
        takeFlux();
        if (m_failed)
            return fail(m_error);
        if (hasOtherKeys())
            m_file.notes.push_back(MotorFile::Note::UnknownKeysLeftOut);
        return m_file;
    }

private:
    simulation::MotorParameters &motor() { return m_file.machine.motor; }
    void give(const char *path) { m_file.given.insert(path); }

    void complain(MotorFileError error)
    {
        if (!std::exchange(m_failed, true))
            m_error = std::move(error);
    }

    std::optional<double> number(const QJsonObject &object, const Key &key, const char *within = "")
    {
        const QJsonValue value = object[keyOf(key.name)];
        if (value.isUndefined() || value.isNull())
            return std::nullopt;
        const double read = value.toDouble(std::numeric_limits<double>::quiet_NaN());
        if (read >= key.least && read <= key.most && (!key.whole || read == std::trunc(read)))
            return read;
        complain({.kind = Kind::WrongValue,
            .place = std::string(within) + key.name,
            .wanted =
                key.whole ? MotorFileError::Wanted::WholeNumber : MotorFileError::Wanted::Number,
            .least = key.least,
            .most = key.most});
        return std::nullopt;
    }
    std::optional<double> number(const Key &key) { return number(m_object, key); }

    void takeName()
    {
        constexpr qsizetype kMostNameBytes = 23;
        for (const char *name : {"label", "id"}) {
            QByteArray text = m_object[keyOf(name)].toString().toUtf8();
            if (text.isEmpty() || m_file.given.contains("motor.name"))
                continue;
            while (text.size() > kMostNameBytes) // whole characters only
                text = QString::fromUtf8(text).chopped(1).toUtf8();
            motor().name = text.toStdString();
            give("motor.name");
        }
    }

    /// What the file does not have stays as it is.
    template <class T>
    std::optional<double> take(const Key &key, T &into, const char *path)
    {
        const auto read = number(key);
        if (read) {
            into = static_cast<T>(*read);
            give(path);
        }
        return read;
    }

    void takeFigures()
    {
        take(kPolePairs, motor().polePairs, "motor.polePairs");
        take(kNominalCurrent, motor().nominal_a, "motor.nominal_a");
        take(kMaxSpeed, motor().maxSpeed_rpm, "motor.maxSpeed_rpm");
        take(kBus, m_file.machine.inverter.supply_v, "inverter.supply_v");
        if (const auto inertia = number(kInertia); inertia && *inertia * kMicro >= 1e-9) {
            motor().inertia_kgm2 = *inertia * kMicro; // 0: was not measured
            give("motor.inertia_kgm2");
        }
        if (const auto friction = number(kFriction); friction && *friction > 0.0) {
            motor().viscous_nms = *friction * kMicro;
            give("motor.viscous_nms");
        }
    }

    void takeInductances()
    {
        const auto ohms = take(kResistance, motor().rs_ohm, "motor.rs_ohm");
        auto henry = number(kInductance);
        if (!henry)
            return;
        // Profiler: henry. Motor library: millihenry. A winding's time constant tells them apart, its L alone does not.
        constexpr double kLongest_s = 0.03, kLargest_h = 1.0, kResistanceUnknown_h = 0.02;
        if (ohms ? *henry / *ohms > kLongest_s : *henry > kResistanceUnknown_h) {
            *henry *= 1e-3;
            m_file.notes.push_back(MotorFile::Note::InductanceInMillihenry);
        }
        const QJsonValue structure = m_object[QLatin1String("magneticStructure")];
        const QString type = structure.isString() ? structure.toString()
                                                  : structure[QLatin1String("type")].toString();
        const double ratio =
            number(structure.toObject(), kRatio, "magneticStructure.").value_or(1.0);
        motor().lq_h = *henry;
        motor().ld_h = *henry * ratio;
        if (motor().ld_h > kLargest_h || motor().ld_h < 1e-6 || *henry > kLargest_h)
            complain(
                {.kind = Kind::WrongValue, .place = kInductance.name, .least = 1e-6, .most = 1e3});
        give("motor.lq_h");
        give("motor.ld_h");
        if (type.startsWith(QLatin1String("I-")))
            m_file.notes.push_back(MotorFile::Note::OneInductanceOnly);
    }

    void takeFlux()
    {
        const auto ke = number(kKe);
        if (!ke)
            return;
        if (!m_file.given.contains("motor.polePairs"))
            return complain({.kind = Kind::Missing, .place = kPolePairs.name});
        motor().flux_wb = motor::fluxOfKe_wb(*ke, motor().polePairs);
        if (motor().flux_wb < 1e-6 || motor().flux_wb > 10.0)
            complain({.kind = Kind::WrongValue,
                .place = kKe.name,
                .least = kKe.least,
                .most = kKe.most});
        give("motor.flux_wb");
    }

    bool hasOtherKeys() const
    {
        const auto known = [](const QString &key) {
            const auto is = [&](const char *name) { return key == QLatin1String(name); };
            return std::ranges::any_of(kNumbers, [&](const Key &number) { return is(number.name); })
                || std::ranges::any_of(kOthers, is);
        };
        const QStringList keys = m_object.keys();
        return !std::ranges::all_of(keys, known);
    }

    const QJsonObject &m_object;
    MotorFile m_file;
    MotorFileError m_error;
    bool m_failed = false;
};

} // namespace

bool isStMotor(const QJsonObject &object)
{
    const auto has = [&](const Key &key) { return object.contains(keyOf(key.name)); };
    return std::ranges::any_of(kNumbers, has);
}

Result<MotorFile, MotorFileError> readStMotor(const QJsonObject &object)
{
    return StReader(object).read();
}

} // namespace session
