// The time cursors as values: named pairs A and B in seconds on the session's axis, which pair is meant, and which of
// its ends the arrow keys move. Knows no pixels and no samples; the scope draws them, the cursor table reads them.
#pragma once

#include <QObject>
#include <QString>

#include <optional>
#include <vector>

namespace widgets {

enum class CursorEnd : std::uint8_t { A, B };

struct CursorPair {
    QString name; ///< of the user; plain text
    double a = 0.0; ///< seconds
    double b = 0.0;

    double at(CursorEnd end) const { return end == CursorEnd::A ? a : b; }
};

class Cursors : public QObject {
    Q_OBJECT
public:
    static constexpr int kMostPairs = 8;
    static constexpr int kNameLength = 24;

    explicit Cursors(QObject *parent = nullptr);

    bool visible() const { return m_visible; }
    const std::vector<CursorPair> &pairs() const { return m_pairs; } ///< never empty
    int current() const { return m_current; }
    const CursorPair &pair() const { return m_pairs[std::size_t(m_current)]; } ///< the current one
    /// The end that arrow keys move; empty: they move the picture.
    std::optional<CursorEnd> active() const { return m_active; }

public Q_SLOTS:
    void setVisible(bool visible); ///< hiding also lets go of the active end
    void setActive(std::optional<widgets::CursorEnd> end);
    /// Of the current pair; ignores what is no number.
    void move(widgets::CursorEnd end, double seconds);
    void shift(double seconds); ///< all pairs
    void setCurrent(int index);
    /// A further pair at these times becomes the current one; nothing if there are kMostPairs.
    void addPair(double a, double b);
    void removeCurrent(); ///< the last one stays
    void rename(const QString &name); ///< the current one; an empty name changes nothing

Q_SIGNALS:
    void changed();

private:
    QString freeName() const;

    std::vector<CursorPair> m_pairs;
    int m_current = 0;
    std::optional<CursorEnd> m_active;
    bool m_visible = false;
};

} // namespace widgets
