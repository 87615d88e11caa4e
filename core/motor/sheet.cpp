#include "motor/sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace motor {

namespace {

constexpr std::array kQuantities{
    MotorQuantityInfo{MotorQuantity::PolePairs, &MotorSheet::polePairs, ""},
    MotorQuantityInfo{MotorQuantity::Resistance, &MotorSheet::rs_ohm, "\u03a9"},
    MotorQuantityInfo{MotorQuantity::InductanceD, &MotorSheet::ld_h, "H"},
    MotorQuantityInfo{MotorQuantity::InductanceQ, &MotorSheet::lq_h, "H"},
    MotorQuantityInfo{MotorQuantity::Flux, &MotorSheet::flux_wb, "Wb"},
    MotorQuantityInfo{MotorQuantity::NominalCurrent, &MotorSheet::nominalCurrent_a, "A"},
    MotorQuantityInfo{MotorQuantity::MaxSpeed, &MotorSheet::maxSpeed_rpm, "rpm"},
    MotorQuantityInfo{MotorQuantity::BusVoltage, &MotorSheet::bus_v, "V"},
    MotorQuantityInfo{MotorQuantity::Inertia, &MotorSheet::inertia_kgm2, "kg m\u00b2"},
    MotorQuantityInfo{MotorQuantity::ViscousFriction, &MotorSheet::viscous_nms, "N m s"},
    MotorQuantityInfo{MotorQuantity::DryFriction, &MotorSheet::coulomb_nm, "N m"},
};

} // namespace

MotorParameters MotorSheet::parameters() const
{
    return {.polePairs = polePairs.value_or(0.0),
        .rs_ohm = rs_ohm.value_or(0.0),
        .lq_h = lq_h.value_or(0.0),
        .ld_h = ld_h.value_or(0.0),
        .flux_wb = flux_wb.value_or(0.0),
        .nominalCurrent_a = nominalCurrent_a.value_or(0.0)};
}

std::span<const MotorQuantityInfo> motorQuantities() { return kQuantities; }

std::vector<MotorComparison> compareMotors(
    const MotorSheet &here, const MotorSheet &there, double tolerance)
{
    std::vector<MotorComparison> rows;
    for (const MotorQuantityInfo &info : kQuantities) {
        MotorComparison row{info.quantity, here.*info.member, there.*info.member, false};
        if (row.here && row.there) {
            const double larger = std::max(std::abs(*row.here), std::abs(*row.there));
            row.differs = !(std::abs(*row.here - *row.there) <= tolerance * larger);
        }
        if (row.here || row.there)
            rows.push_back(row);
    }
    return rows;
}

} // namespace motor
