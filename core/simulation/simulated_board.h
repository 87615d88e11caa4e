// A simulated board as its line sees it: bytes in, bytes out, at the pace of the baud rate, on virtual time.
// The same object serves unit tests (time moves where they move it), the "Simulated board" entry of the connect bar
// and rotorscope-sim.
//
// receive() says when the bytes arrived at the board's pin at the earliest; the board spaces them at the baud rate.
// advance(now) lets the world go on until `now`. takeOutput() gives the bytes whose last bit has left by then.
#pragma once

#include "base/bytes.h"
#include "base/time.h"
#include "simulation/device.h"
#include "simulation/firmware/build.h"
#include "simulation/mcp/liars.h"
#include "simulation/plant/parameters.h"
#include "simulation/signals.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace simulation {

struct BoardOptions {
    std::string profile = "mcsdk-6.4"; ///< one of profileNames() or fcpProfiles()
    std::string motor; ///< a preset of plant/presets.h; empty: the first of them
    /// Instead of a preset; makeBoard() refuses impossible ones.
    std::optional<PlantParameters> plant;
    std::optional<LoadParameters> load; ///< instead of what the motor comes with
    int motors = 1; ///< 1 or 2
    std::vector<const BuildOption *> with; ///< options beside what profile and motor ask for
    std::optional<Build> build; ///< instead of what profile and motor ask for; `motors` is kept
    std::size_t rxMax = 256, txSyncMax = 256, txAsyncMax = 2048; ///< bytes
    bool dataCrc = false; ///< forced builds only: payloads end in CA FE
    int version = 0; ///< ASPEP version answered
    int linkId = 0; ///< 0 UART A, 1 UART B
    int streams = 10; ///< datalog signals
    std::uint32_t baud = 1843200;
    double hfHz = 16000.0; ///< control rate; FOCFW_CONFIG agrees with it
    std::uint32_t firstTimestamp = 0; ///< HF counter at power-on
    bool nullCheck = false; ///< a build that repeats the last response on an empty request
    /// An application with datalog sources for STATUS, SPEED_MEAS, SPEED_REF, FAULTS_FLAGS.
    bool wide = false;
    /// 0..2: the first echoes its payload reversed, the second answers status 0x42
    int userCallbacks = 0;
    int watchdogMs = 0; ///< 0: none; else user command 1 is the heartbeat and FW_NAME says so
    std::vector<LieChoice> lies; ///< what it does wrong on purpose
    std::uint64_t seed = 1;
};

/// What a motor does in truth, whatever the line says: for judges and for people who look at the bench.
struct MotorTruth {
    bool driven = false; ///< the stage is on: started, and neither stopping nor in a fault
    bool idle = true; ///< at rest as the firmware means it, or in a fault
    MotorState state = MotorState::Idle; ///< of the firmware
    std::uint32_t faults = 0; ///< present now in the high half, occurred and kept in the low half
    double rpm = 0.0; ///< of the rotor, mechanical, signed
    double measuredRpm = 0.0, referenceRpm = 0.0; ///< what the firmware believes, and wants
    double iqAmps = 0.0; ///< through the windings, across the magnets, peak, signed
    double maxRpm = 0.0; ///< that the design allows; 0: not known
    double ampsPerDigit = 0.0; ///< of current registers of 16 bits; 0: not known
    double maxAmps = 0.0; ///< that can be measured, peak; 0: not known
};

/// Its nextWake() is tens of microseconds to 1 ms away.
class SimulatedBoard : public ByteDevice {
public:
    // Control words; each as the user at the board would do it.
    virtual void reset() = 0; ///< power cycle
    /// Fault bits that are present from now on; 0: none.
    virtual void setFaults(std::uint16_t present) = 0;
    virtual void mute(Duration time) = 0; ///< what it sends meanwhile is lost on the line
    /// Bit 0 of the byte after so many more sent bytes.
    virtual void corruptAfter(std::uint64_t bytes) = 0;
    virtual void inject(ByteView bytes) = 0; ///< these bytes appear in its output at once
    /// Constant torque against motor 1 or 2 from now on; the fan's and the friction stay.
    virtual void setLoadTorque(int motor, double nm) = 0;

    /// Of a motor from 1 on; at rest for one that is not there.
    virtual MotorTruth truth(int motor) const = 0;

    /// What it is, for people and the port list.
    virtual std::string describe() const = 0;
};

// What the options come to.
Build buildOf(const BoardOptions &options);
/// With the sensors that the build reads; nothing if there is no motor of that name or no machine can be so.
std::optional<PlantParameters> plantOf(const BoardOptions &options);

/// A board of the named profile; nullptr if there is no such profile or motor, or the motor cannot be.
std::unique_ptr<SimulatedBoard> makeBoard(const BoardOptions &options);

std::vector<std::string> profileNames();

} // namespace simulation
