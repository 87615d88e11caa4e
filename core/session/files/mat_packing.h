// MatPacking: a plain file of MATLAB, level 5, with each of its variables packed. libmatio packs at zlib's own level,
// which takes four times as long as the first one (0.45 s against 0.10 s a million numbers of a motor) for a file
// that is about as large, and cannot be stopped meanwhile.
// Source: "MAT-File Format", MathWorks, chapter 1: an element miCOMPRESSED holds one element miMATRIX with its tag.
#pragma once

#include <QByteArray>
#include <QFile>

#include <functional>
#include <string_view>

namespace session {

/// Hands on the packed file in pieces: its header, then a variable each. Holds one packed variable in memory.
class MatPacking {
public:
    /// @param plain    open for reading, at its begin; what libmatio wrote, so its tags are believed
    /// @param proceed  told the share of the file that is packed, every mebibyte; false cancels
    MatPacking(QFile &plain, std::function<bool(double)> proceed);

    /// The next piece, which lives until the call after this one; false when there is none.
    bool next(std::string_view &piece);
    bool goesOn() const { return !m_cancelled && !m_failed; }
    bool failed() const { return m_failed; } ///< the plain file could not be read to its end

private:
    void pack(qint64 size);

    QFile &m_plain;
    std::function<bool(double)> m_proceed;
    QByteArray m_piece;
    bool m_cancelled = false;
    bool m_failed = false;
};

} // namespace session
