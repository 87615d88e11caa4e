#include "widgets/registers/entry_edit.h"

#include <QKeyEvent>
#include <QValidator>

namespace widgets {
namespace {

constexpr int kLongestEntry = 2048;

class EntryValidator : public QValidator {
public:
    explicit EntryValidator(EntryEdit &edit)
        : QValidator(&edit)
        , m_edit(edit)
    {
    }

    State validate(QString &text, int &) const override
    {
        return m_edit.takes(text) ? Acceptable : Intermediate;
    }

private:
    const EntryEdit &m_edit;
};

} // namespace

EntryEdit::EntryEdit(Rules rules, As as, QWidget *parent)
    : SteppedEdit(parent)
    , m_rules(std::move(rules))
    , m_as(as)
{
    setMaxLength(kLongestEntry);
    connect(this, &QLineEdit::textChanged, this, [this] { showProblem(); });
}

void EntryEdit::keepWhatIsBad() { setValidator(new EntryValidator(*this)); }

Result<catalog::Value, EntryError> EntryEdit::read(const QString &text) const
{
    const auto rules = m_rules();
    if (!rules)
        return fail(EntryError::CannotBeTyped);
    return m_as == As::Raw ? readRawEntry(text, *rules) : readShownEntry(text, *rules);
}

std::optional<catalog::Value> EntryEdit::value() const
{
    const auto value = read(text());
    return value ? std::optional(*value) : std::nullopt;
}

QString EntryEdit::problem() const
{
    if (m_emptyAllowed && text().trimmed().isEmpty())
        return {};
    auto rules = m_rules();
    const auto value = read(text());
    if (value || !rules)
        return {};
    if (m_as == As::Raw)
        rules->scale = {};
    return entryErrorText(value.error(), *rules);
}

void EntryEdit::keyPressEvent(QKeyEvent *event)
{
    SteppedEdit::keyPressEvent(event);
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        event->accept(); // not for what the editor stands in: that would open it once more
}

void EntryEdit::stepBy(int steps)
{
    const auto rules = m_rules();
    const auto now = value();
    const auto next = rules && now ? stepped(*now, steps * m_step, *rules) : std::nullopt;
    if (next)
        setFollowed(m_as == As::Raw ? rawEntryText(catalog::onWire(*rules->info, *next))
                                    : shownEntryText(*next, *rules));
}

} // namespace widgets
