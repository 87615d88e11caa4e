// SampleRoom: how much of the disk the scope's samples may take, what they take now, and what that means in hours. It
// sets the budget of the archive and tells when the disk wants no more; the samples themselves it does not touch.
#pragma once

#include "capture/capture.h"
#include "session/archive/disk_archive.h"
#include "widgets/base/banner.h"
#include "widgets/base/device.h"

#include <QObject>

namespace widgets {

class SampleRoom : public QObject {
    Q_OBJECT
public:
    /// Both outlive it.
    SampleRoom(capture::Capture &capture, session::DiskArchive &archive, QObject *parent = nullptr);

    /// @param gigabytes  0: memory only; negative: as much as is usual on this disk
    void setWanted(double gigabytes);
    double wanted() const { return m_wanted; }
    double usual() const; ///< in GB
    QString folder() const { return m_archive.folder(); }

    void refresh(Milliseconds now); ///< the rate at which samples take room, once a second

    /// "Samples: 0.41 GB in memory, 3.2 GB on disk"
    QString heldText() const;
    /// How long a time that many GB hold, at the present rate or at a usual one.
    QString meaningText(double gigabytes) const;
    /// What would go if that were all; empty if nothing would.
    QString lessText(double gigabytes) const;
    /// What has to go from now on; for when samples are let go.
    QString fullText() const;

Q_SIGNALS:
    void refreshed(const QString &heldText); ///< once a second
    void said(widgets::Banner::Kind kind, const QString &sentence);

private:
    double taken() const;
    void tellFailure(const session::ArchiveFailure &failure);

    capture::Capture &m_capture;
    session::DiskArchive &m_archive;
    double m_wanted = -1.0;
    std::uint64_t m_usual;
    Milliseconds m_then{};
    double m_takenThen = 0.0;
    double m_rate = 0.0; ///< bytes a second; 0: nothing comes
};

} // namespace widgets
