// Session: owns a transport and a drive, and is the only place that reads the clock and has a timer. It can live in a
// worker thread (the window) or in the main thread (the command line): every slot may be called queued.
//
// What the drive tells is handed on in batches: at most one every 16 ms, and never more than two that the receiver has
// not acknowledged, so a flooded link never floods an event loop. While it waits, registers are coalesced (the newest
// value of each wins) and samples beyond the bound are dropped for display only, counted, and shown as gaps.
#pragma once

#include "drive/drive.h"
#include "session/endpoint.h"

#include <QObject>

#include <atomic>
#include <memory>
#include <vector>

namespace session {

/// What happened, in order. Complete values: may cross threads.
struct Batch {
    std::vector<drive::Event> events;
    std::uint64_t droppedForDisplay = 0; ///< samples since the session began that only the display did not get
};
using BatchPtr = std::shared_ptr<const Batch>;

enum class PortState : std::uint8_t { Closed, Open };

class Session : public QObject {
    Q_OBJECT
public:
    explicit Session(QObject *parent = nullptr);
    ~Session() override;

    /// From any thread: a stop that does not queue behind other calls. Same as the slot stop().
    void stopFromAnyThread();

public Q_SLOTS:
    void open(const session::Endpoint &endpoint); ///< opens the port and connects; an open one is closed first
    void close(); ///< ends streaming, closes the port, ends with portChanged(Closed)
    void submit(const drive::Wish &wish);
    void stop(); ///< every motor, ahead of everything
    void setArmed(bool armed);
    void acknowledge(); ///< one batch has been taken in

Q_SIGNALS:
    void batch(const session::BatchPtr &batch);
    void portChanged(session::PortState state, const session::PortError &why);
    void armedChanged(bool armed);
};

} // namespace session

Q_DECLARE_METATYPE(session::BatchPtr)
Q_DECLARE_METATYPE(session::PortState)
Q_DECLARE_METATYPE(drive::Wish)
