#include "widgets/window/about_dialog.h"

#include "widgets/base/look/section_head.h"
#include "widgets/base/look/spacing.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QScreen>
#include <QScrollArea>
#include <QStyle>
#include <QVBoxLayout>

#include <iterator>
#include <vector>

namespace widgets {
namespace {

struct About {
    Q_DECLARE_TR_FUNCTIONS(About)
};

// Of a dialog's table; the rest is for frame and buttons.
constexpr double kMostOfScreen = 0.75;
constexpr double kMostOfWidth = 0.9;

struct Key {
    QString key, what;
};

QLabel *plainLabel(const QString &text, QWidget *parent)
{
    auto *label = new QLabel(text, parent);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

QDialog *makeDialog(QWidget *parent, const QString &title)
{
    auto *dialog = new QDialog(parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    edged(new QVBoxLayout(dialog), kDialogEdges, kGrid);
    return dialog;
}

void finish(QDialog *dialog)
{
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    dialog->layout()->addWidget(buttons);
    dialog->open();
}

/// What is pressed, and what for: one below the other, in so many columns.
QWidget *keyTable(const std::vector<Key> &keys, std::size_t columns, QWidget *parent)
{
    auto *table = new QWidget(parent);
    auto *grid = new QGridLayout(table);
    grid->setHorizontalSpacing(3 * kGrid);
    grid->setVerticalSpacing(kHalfGrid);
    const std::size_t rows = (keys.size() + columns - 1) / columns;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const int row = static_cast<int>(i % rows), column = static_cast<int>(i / rows);
        for (const bool what : {false, true}) {
            auto *label = plainLabel(what ? keys[i].what : keys[i].key, table);
            label->setWordWrap(false);
            grid->addWidget(label, row, 2 * column + (what ? 1 : 0));
        }
    }
    grid->setRowStretch(static_cast<int>(rows), 1);
    return table;
}

} // namespace

QString stopLimitsText()
{
    return About::tr(
        "A program on a PC over a serial line is no replacement for a switch that removes the "
        "power: have one at hand. "
        "\"Stop motors\" takes the motor out of control; it may coast for a long time. "
        "If Rotorscope crashes, freezes or is killed, a guardian process tells the motors to stop "
        "(not "
        "on Windows). If the link is lost or the computer fails, nothing is sent and the motor "
        "goes on "
        "turning.");
}

void showAbout(QWidget *parent)
{
    QDialog *dialog = makeDialog(parent, About::tr("About Rotorscope"));
    auto *title = plainLabel(
        QStringLiteral("Rotorscope %1").arg(QCoreApplication::applicationVersion()), dialog);
    title->setFont(inBold(title->font(), 1.6));
    dialog->layout()->addWidget(title);
    dialog->layout()->addWidget(
        plainLabel(About::tr("A workbench for engineers who tune electric motors."), dialog));
    dialog->layout()->addWidget(plainLabel(stopLimitsText(), dialog));
    dialog->layout()->addWidget(
        plainLabel(About::tr("Free software under the GNU General Public License, version 3 or "
                             "later, without any warranty. "
                             "Built with Qt %1 and QCustomPlot.")
                       .arg(QString::fromLatin1(qVersion())),
            dialog));
    dialog->setMinimumWidth(460);
    finish(dialog);
}

void showKeys(QWidget *parent)
{
    QDialog *dialog = makeDialog(parent, About::tr("Keys"));
    const Key keys[] = {
        {QStringLiteral("Esc"), About::tr("Stop every motor, from any window")},
        {QStringLiteral("Ctrl+Enter"), About::tr("Start the motor (after Arm)")},
        {QStringLiteral("Ctrl+Backspace"), About::tr("Acknowledge faults")},
        {QStringLiteral("Ctrl+D"), About::tr("Connect, disconnect")},
        {QStringLiteral("Ctrl+K"), About::tr("Find a register")},
        {QStringLiteral("F2"), About::tr("Edit a register's value")},
        {QStringLiteral("Ctrl+Shift+A"), About::tr("Write the edited registers (after Arm)")},
        {QStringLiteral("Ctrl+Z, Ctrl+Shift+Z"), About::tr("Undo and redo what was written")},
        {About::tr("Enter"), About::tr("In the list: add to the scope. In a set-point: send it")},
        {About::tr("Space"), About::tr("Hold the picture, let it run (never starts a motor)")},
        {QStringLiteral("F, Shift+F"), About::tr("Show everything; fit the values only")},
        {QStringLiteral("+ \u2212"), About::tr("Zoom in, out; also the wheel")},
        {QStringLiteral("Ctrl+\u2190 Ctrl+\u2192"), About::tr("Earlier, later")},
        {About::tr("End"), About::tr("Follow the newest samples")},
        {QStringLiteral("S, T"), About::tr("Take a single record; force a trigger")},
        {About::tr("Page up, page down"), About::tr("Earlier and later records of the trigger")},
        {QStringLiteral("R, B"), About::tr("Keep the traces as reference A, B; with Shift: back")},
        {QStringLiteral("O"), About::tr("Show the whole recording below")},
        {QStringLiteral("G"), About::tr("Show the grid or hide it")},
        {QStringLiteral("C, 1, 2"), About::tr("Cursors; 1 and 2 give one to the mouse")},
        {QStringLiteral("M"), About::tr("Set a marker")},
        {QStringLiteral("\u2190 \u2192"),
            About::tr("Move the cursor by a sample, else the picture")},
        {QStringLiteral("Ctrl+Shift+E"), About::tr("Export CSV")},
        {QStringLiteral("Ctrl+S"), About::tr("Save the markers of an opened recording")},
        {QStringLiteral("Ctrl+Shift+M, Ctrl+Shift+X"), About::tr("Math channels; XY picture")},
        {QStringLiteral("Ctrl+T, Ctrl+Shift+T"), About::tr("Steps of the speed; run them")},
        {QStringLiteral("Ctrl+I, Ctrl+Shift+F"),
            About::tr("Identify the motor; its frequency response")},
        {QStringLiteral("Ctrl+Shift+G"), About::tr("Tour from an unknown motor to proved gains")},
        {QStringLiteral("Ctrl+Shift+N, Ctrl+Shift+L, Ctrl+Shift+B"),
            About::tr("Notes; motion log; run book")},
        {QStringLiteral("F9"), About::tr("Large numbers")},
        {QStringLiteral("F11"), About::tr("Full screen")},
    };
    // In two columns where the screen is wide enough, and to be scrolled where it is low: Close stays on the smallest
    // one.
    auto *area = new QScrollArea(dialog);
    const int bar = area->style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    const QSize screen = dialog->screen()->availableSize();
    const QSize room(int(screen.width() * kMostOfWidth), int(screen.height() * kMostOfScreen));
    const std::vector<Key> all(std::begin(keys), std::end(keys));
    auto *table = keyTable(all, 2, dialog);
    if (table->sizeHint().width() + bar > room.width()) {
        delete table;
        table = keyTable(all, 1, dialog);
    }
    area->setObjectName(QStringLiteral("keys"));
    area->setAccessibleName(dialog->windowTitle());
    area->setFrameShape(QFrame::NoFrame);
    area->setWidget(table);
    area->setWidgetResizable(true);
    dialog->layout()->addWidget(area);
    const QSize whole = table->sizeHint() + QSize(bar, bar);
    area->setMinimumSize(whole.boundedTo(room));
    finish(dialog);
}

} // namespace widgets
