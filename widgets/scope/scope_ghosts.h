// ScopeGhosts: traces of other times behind those of the scope: earlier records, and two references that a person keeps.
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

    /// Both outlive it. @param zero  the time in the picture that a reference is laid upon
    ScopeGhosts(capture::Capture &capture, PlotStack &stack, std::function<double()> zero,
        QObject *parent = nullptr);

    int count() const { return static_cast<int>(m_records.size()); }
    bool hasReference(Reference which) const { return referenceOf(which).kept != nullptr; }
    bool hasReference() const { return hasReference(Reference::A) || hasReference(Reference::B); }
    void place(); ///< behind the traces, before they are drawn

public Q_SLOTS:
    void setRecords(std::vector<Ghost> records); ///< newest first; at most kMost
    /// R, B: the traces as they are now stay dashed and paler behind those that come, at the same place from the trigger
    /// or, in a picture that rolls, from the left edge. With Shift they go.
    void keep(widgets::Reference which);
    void drop(widgets::Reference which);

Q_SIGNALS:
    void referencesChanged();
    void redrawWanted();

private:
    const Ghost &referenceOf(Reference which) const
    {
        return m_references[static_cast<std::size_t>(which)];
    }

    capture::Capture &m_capture;
    PlotStack &m_stack;
    std::function<double()> m_zero;
    std::vector<Ghost> m_records;
    std::array<Ghost, 2> m_references; ///< their shift is the time that lies at zero
};

} // namespace widgets
