// LentNote: what an experiment has borrowed of a board's registers, as a file for as long as it has it. A program that
// is killed meanwhile leaves the file, and the next one that meets the board says what is to be given back, and how. A
// register is off the note once it was written again, by whomever, and read back as written, and when the write that
// borrows it certainly changed nothing.
//
// A board is known by what it says of itself: another one that says the same has the same note. One that is simulated
// by this program ends with it and has no file. It stands in the session's thread; a file takes well below 1 ms, and
// the motor rests when one is written, or goes its old speed: nothing waits for the disk itself, because a program that
// is killed loses nothing of what it handed to the system.
#pragma once

#include "lab/lent.h"
#include "session/recording/session_tap.h"

#include <map>
#include <set>
#include <vector>

namespace session {

QString lentFolder(); ///< in the user's data folder, for window and command line

class LentNote : public QObject, public SessionTap {
    Q_OBJECT
public:
    /// @param folder  made when it is needed
    explicit LentNote(QString folder = lentFolder());

    void begin(const Endpoint &endpoint); ///< a connection
    void tell(); ///< what is left now, because an experiment is over

    void onEvent(const drive::Event &event, TimePoint now) override;
    void onWish(const drive::Wish &wish, TimePoint now) override;
    void onStop(TimePoint) override { }
    void onLink(recorded::LinkBytes::Direction, ByteView, TimePoint) override { }

Q_SIGNALS:
    /// Something is left on the board that was met, by another program or by this one: lab::leftTexts() in a row. Again
    /// with what remains when some of it was given back; empty: nothing of it, or another connection.
    /// @param back  what the registers held before, as far as the note makes sense
    void left(const QString &texts, const std::vector<drive::RegisterWrite> &back = {});

private:
    void meet(const drive::Identified &board);
    bool borrow(drive::RegisterId id);
    void borrowWay(int motor);
    void written(const drive::Ended &ended);
    void notBorrowed(const drive::Ended &ended);
    void save() const;

    QString m_folder;
    QString m_path; ///< of the board's note; empty: it has no file
    bool m_keeps = false; ///< it may have one
    bool m_told = false; ///< that something is left
    std::shared_ptr<const catalog::Catalog> m_catalog;
    std::map<drive::RegisterId, catalog::Value> m_held; ///< as it was read last
    std::map<drive::RegisterId, lab::Lent> m_lent;
    drive::WishId m_lending = 0; ///< the newest wish that writes what an experiment wants
    std::set<drive::RegisterId> m_fresh; ///< on the note since that wish; its end is awaited
};

/// Parts whose session tells the note, too.
Parts noted(const Parts &parts, const std::shared_ptr<LentNote> &note);

} // namespace session
