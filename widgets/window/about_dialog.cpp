#include "widgets/window/about_dialog.h"

#include "widgets/base/look/section_head.h"
#include "widgets/base/look/spacing.h"

#include <QAction>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeySequence>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QScrollArea>
#include <QStyle>
#include <QVBoxLayout>

#include <utility>
#include <vector>

namespace widgets {
namespace {

struct About {
    Q_DECLARE_TR_FUNCTIONS(About)
};

// Of a dialog's table; the rest is for frame and buttons.
constexpr double kMostOfScreen = 0.75;
constexpr double kMostOfWidth = 0.9;
constexpr std::size_t kMostColumns = 3;

struct Key {
    QString key, what;
};
struct Section {
    QString name;
    std::vector<Key> keys;
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

/// Sections one below the other, in so many columns of about one height.
QWidget *keyTable(const std::vector<Section> &sections, std::size_t columns, QWidget *parent)
{
    auto *table = new QWidget(parent);
    auto *row = bare(new QHBoxLayout(table), 3 * kGrid);
    // One more than there are, so that the last column is one of them.
    std::size_t all = 1, above = 0, column = 0;
    for (const Section &section : sections)
        all += section.keys.size() + 1;
    QGridLayout *grid = nullptr;
    for (const Section &section : sections) {
        const std::size_t lines = section.keys.size() + 1;
        const std::size_t wanted = (2 * above + lines) * columns / (2 * all); // for its middle
        above += lines;
        if (grid == nullptr || wanted != column) {
            auto *whole = new QVBoxLayout;
            grid = bare(new QGridLayout, 2 * kGrid, kHalfGrid);
            whole->addLayout(grid);
            whole->addStretch(1);
            row->addLayout(whole);
            column = wanted;
        }
        int line = grid->rowCount();
        grid->addWidget(new SectionHead(section.name, table), line, 0, 1, 2);
        for (const Key &key : section.keys) {
            ++line;
            for (const bool what : {false, true}) {
                auto *label = plainLabel(what ? key.what : key.key, table);
                label->setWordWrap(false);
                grid->addWidget(label, line, what ? 1 : 0);
            }
        }
    }
    row->addStretch(1);
    return table;
}

QString nativeKeys(const QList<QKeySequence> &keys)
{
    QStringList texts;
    for (const QKeySequence &key : keys)
        texts.append(key.toString(QKeySequence::NativeText));
    return texts.join(QLatin1String(", "));
}

QString withoutMark(QString text) { return text.remove(QLatin1Char('&')); }

/// As its menu shows it: a key that belongs to something else, such as Esc, stands behind a tab.
Key keyOf(const QAction &action)
{
    const QString text = withoutMark(action.text());
    const auto tab = text.indexOf(QLatin1Char('\t'));
    if (tab >= 0)
        return {text.mid(tab + 1), text.left(tab)};
    if (action.objectName() == QLatin1String("scopeRun"))
        return {nativeKeys(action.shortcuts()),
            About::tr("Hold the picture, let it run (never starts a motor)")};
    return {nativeKeys(action.shortcuts()), text};
}

/// Nothing is listed twice that has its key from an action: a new one is here by itself.
std::vector<Section> allKeys(const QMainWindow &window)
{
    std::vector<Section> sections;
    QList<const QAction *> inMenus;
    for (const QAction *entry : window.findChild<QMenuBar *>()->actions()) {
        Section section{withoutMark(entry->text()), {}};
        for (const QAction *action : entry->menu()->actions()) {
            inMenus.append(action);
            if (Key key = keyOf(*action); !key.key.isEmpty())
                section.keys.push_back(std::move(key));
        }
        if (!section.keys.empty())
            sections.push_back(std::move(section));
    }
    Section beside{About::tr("Beside the menus"),
        {{nativeKeys({Qt::Key_Return}),
             About::tr("In the list: add to the scope. In a set-point: send it")},
            {nativeKeys({Qt::Key_Left, Qt::Key_Right}),
                About::tr("Move the cursor by a sample, else the picture")},
            {About::tr("Wheel", "of the mouse"), About::tr("Zoom in, out")}}};
    for (const QAction *action : window.findChildren<QAction *>())
        if (!action->shortcuts().isEmpty() && !inMenus.contains(action))
            beside.keys.push_back(keyOf(*action));
    sections.push_back(std::move(beside));
    return sections;
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

void showKeys(QMainWindow &window)
{
    QDialog *dialog = makeDialog(&window, About::tr("Keys"));
    // In as many columns as the screen is wide enough for, and to be scrolled where it is low: Close stays on the
    // smallest one.
    auto *area = new QScrollArea(dialog);
    const int bar = area->style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    const QSize screen = dialog->screen()->availableSize();
    const QSize room(int(screen.width() * kMostOfWidth), int(screen.height() * kMostOfScreen));
    const std::vector<Section> keys = allKeys(window);
    std::size_t columns = kMostColumns;
    auto *table = keyTable(keys, columns, dialog);
    while (columns > 1 && table->sizeHint().width() + bar > room.width()) {
        delete table;
        table = keyTable(keys, --columns, dialog);
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
