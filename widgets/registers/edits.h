// RegisterEdits: carries out what was edited in a RegisterModel, as one step that can be taken back. It asks before
// what can move or harm something, writes only while armed, and keeps in its list only what the board is known to have
// taken.
//
// apply(), write(), undo() and redo() are refused while another one is under way. Each may emit asked(); then confirm()
// or decline() has to follow. The list ends with the connection: a board that was away may have been reset.
#pragma once

#include "drive/write_caution.h"
#include "widgets/base/device.h"
#include "widgets/registers/model.h"
#include "widgets/registers/write_report.h"

#include <QObject>
#include <QUndoStack>

namespace widgets {

/// What keeps a board's values before a list of registers is written (AutoSnapshots in the program).
class KeepBeforeWriting : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    virtual void make() = 0; ///< made() or broken() follows; nothing while one is under way

Q_SIGNALS:
    void made(); ///< it is in memory: writing may begin
    void broken(const QString &sentence); ///< the board could not be read
    void told(const QString &sentence); ///< something is missing that does not stop a write
};

/// One register of a write that the user is asked about.
struct WriteLine {
    QString name, was, becomes; ///< values with units; `was` may be empty: not known
    int motor = 0; ///< 0: the board's
    catalog::Caution caution = catalog::Caution::None;
    bool acts = false; ///< a set-point, a mode, a command: more than a parameter
};

class RegisterEdits : public QObject {
    Q_OBJECT
public:
    RegisterEdits(Device &device, RegisterModel &model, QObject *parent = nullptr);

    /// From now on what the board holds is read and kept before more than one register is written, in whatever way. It
    /// outlives this.
    void keepBeforeWriting(KeepBeforeWriting &snapshots);

    const QUndoStack &steps() const { return m_steps; }
    int pendingCount() const { return static_cast<int>(m_model.pending().size()); }
    bool underWay() const { return m_stage != Stage::Idle; }
    /// Why nothing can be written now; empty if it can.
    QString writeHint() const;
    /// The same for each verb, with what there is to do.
    QString applyHint() const;
    QString undoHint() const;
    QString redoHint() const;

    /// Writes these in this order, as one step of the list that is named `text`: for forms and files whose values
    /// belong together. Asks like apply(); does nothing while writeHint() says why. Edits that wait stay as they are.
    void write(const QString &text, std::vector<drive::RegisterWrite> writes);

public Q_SLOTS:
    void apply();
    void undo();
    void redo();
    void revert() { m_model.forgetEdits(); }
    void confirm();
    void decline();

Q_SIGNALS:
    void asked(const QList<widgets::WriteLine> &lines);
    void changed(); ///< one of the hints or counts may be another
    void told(const QString &sentence, bool good); ///< how it ended
    void declined(); ///< nothing of it was sent
    /// The same of a write, register by register.
    void reported(const widgets::WriteReport &report);

private:
    enum class Stage : std::uint8_t { Idle, Asking, Keeping, Sending };
    enum class Verb : std::uint8_t { Apply, Write, Undo, Redo };

    void begin(Verb verb, std::vector<drive::RegisterWrite> writes);
    QList<WriteLine> cautious(const std::vector<drive::RegisterWrite> &writes) const;
    std::vector<drive::RegisterWrite> stepWrites(Verb verb) const;
    void keepOrSend();
    void kept();
    void notKept(const QString &sentence);
    void notSent(const QString &why);
    void send();
    void end(const drive::Ended &ended);
    void keep(const drive::Ended &ended);
    void tell(const drive::Ended &ended);
    void tellEnd(const QString &sentence, bool good);
    drive::HeldValues facts() const;
    void linkChanged();
    void forget();

    Device &m_device;
    RegisterModel &m_model;
    KeepBeforeWriting *m_snapshots = nullptr;
    QUndoStack m_steps;
    Stage m_stage = Stage::Idle;
    Verb m_verb = Verb::Apply;
    bool m_disarmed = false; ///< since the snapshot before the write began
    bool m_confirmed = false; ///< the user has said yes to this very list
    std::vector<drive::RegisterWrite> m_writes;
    QStringList m_aside; ///< told while the write is under way
    QString m_text; ///< of the step; empty: what was written
    drive::WishId m_wish = 0;
};

} // namespace widgets
