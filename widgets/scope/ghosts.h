// ScopeGhosts: traces of other times behind those of the scope: earlier records, and two references that the user
// keeps.
#pragma once

#include "widgets/scope/kept_reference.h"

#include <QObject>
#include <QString>

#include <array>
#include <functional>
#include <vector>

namespace capture {
class Capture;
}

namespace widgets {

class PlotStack;

/// A time of a reference that came from a file, and what happened then.
struct Instant {
    double seconds = 0.0;
    QString text;
};

class ScopeGhosts : public QObject {
    Q_OBJECT
public:
    static constexpr int kMost = 16; ///< records

    /// The time in the picture that a reference is laid upon.
    struct Zero {
        double seconds = 0.0;
        bool trigger = false; ///< else the left edge
        capture::TimeSpan picture; ///< of which this time is one
    };
    /// Both outlive it.
    ScopeGhosts(capture::Capture &capture, PlotStack &stack, std::function<Zero()> zero,
        QObject *parent = nullptr);

    int count() const { return static_cast<int>(m_records.size()); }
    bool hasReference(Reference which) const { return referenceOf(which).kept != nullptr; }
    bool hasReference() const { return hasReference(Reference::A) || hasReference(Reference::B); }
    void place(); ///< behind the traces, before they are drawn
    Zero zero() const { return m_zero(); }

    /// The same from a file: beside what is shown, be it rolling or triggered.
    /// @param instants  at least one: those of its times that can be laid where references begin
    void lay(
        Reference which, capture::Snapshot kept, std::vector<Instant> instants, std::size_t first);
    bool isFromFile(Reference which) const { return !keptAs(which).instants.empty(); }
    const Instant &instant(Reference which) const; ///< that is laid there; of one from a file
    void nextInstant(Reference which, int by); ///< round and round

    /// What of them stood in the picture when they were made, for a workspace; those that are too long are not among
    /// them.
    std::vector<KeptReference> forWorkspace() const;
    /// Each takes the place of the one that is there; where there is none for it, that one stays.
    void adoptFromWorkspace(const std::vector<KeptReference> &references);

public Q_SLOTS:
    void setRecords(std::vector<Ghost> records); ///< newest first; at most kMost
    /// R, B: the traces as they are now stay dashed and paler behind those that come, at the same place from the
    /// trigger or, in a picture that rolls, from the left edge; those of the one are not drawn in the other. With Shift
    /// they go, and the one that was replaced last is back.
    void keep(widgets::Reference which);
    void drop(widgets::Reference which);

Q_SIGNALS:
    void referencesChanged();
    void laid(widgets::Reference which); ///< another instant of it
    /// By another one, which drop() takes away again; or @param back  the one that was replaced is there again.
    void replaced(widgets::Reference which, bool back);
    void redrawWanted();

private:
    struct Kept {
        Ghost ghost; ///< its shift is the time that lies at zero
        bool trigger = false; ///< which was the trigger's
        std::vector<Instant> instants; ///< of a file
        std::size_t instant = 0;
        capture::TimeSpan picture; ///< in which it was made, from its zero
    };
    const Kept &keptAs(Reference which) const
    {
        return m_references[static_cast<std::size_t>(which)];
    }
    const Ghost &referenceOf(Reference which) const { return keptAs(which).ghost; }
    void replace(Reference which, Kept kept);

    capture::Capture &m_capture;
    PlotStack &m_stack;
    std::function<Zero()> m_zero;
    std::vector<Ghost> m_records;
    std::array<Kept, 2> m_references, m_replaced;
};

} // namespace widgets
