// ScopeGhosts: traces of other times behind those of the scope: earlier records, and two references that the user keeps.
#pragma once

#include "widgets/scope/drawing/marks.h"

#include <QObject>

#include <array>
#include <functional>
#include <vector>

namespace capture {
class Capture;
}

namespace widgets {

class PlotStack;

class ScopeGhosts : public QObject {
    Q_OBJECT
public:
    static constexpr int kMost = 16; ///< records

    /// The time in the picture that a reference is laid upon.
    struct Zero {
        double seconds = 0.0;
        bool trigger = false; ///< else the left edge
    };
    /// Both outlive it.
    ScopeGhosts(capture::Capture &capture, PlotStack &stack, std::function<Zero()> zero,
        QObject *parent = nullptr);

    int count() const { return static_cast<int>(m_records.size()); }
    bool hasReference(Reference which) const { return referenceOf(which).kept != nullptr; }
    bool hasReference() const { return hasReference(Reference::A) || hasReference(Reference::B); }
    void place(); ///< behind the traces, before they are drawn

public Q_SLOTS:
    void setRecords(std::vector<Ghost> records); ///< newest first; at most kMost
    /// R, B: the traces as they are now stay dashed and paler behind those that come, at the same place from the trigger
    /// or, in a picture that rolls, from the left edge; those of the one are not drawn in the other. With Shift they go, and
    /// the one that was replaced last is back.
    void keep(widgets::Reference which);
    void drop(widgets::Reference which);

Q_SIGNALS:
    void referencesChanged();
    void redrawWanted();

private:
    const Ghost &referenceOf(Reference which) const
    {
        return m_references[static_cast<std::size_t>(which)].ghost;
    }

    capture::Capture &m_capture;
    PlotStack &m_stack;
    std::function<Zero()> m_zero;
    std::vector<Ghost> m_records;
    struct Kept {
        Ghost ghost; ///< its shift is the time that lies at zero
        bool trigger = false; ///< which was the trigger's
    };
    std::array<Kept, 2> m_references, m_replaced;
};

} // namespace widgets
