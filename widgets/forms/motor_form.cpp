#include "widgets/forms/motor_form.h"

#include "session/files/motor_file.h"
#include "session/files/whole_file.h"
#include "widgets/base/device_text.h"
#include "widgets/base/file_prompt.h"
#include "widgets/base/lamp.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/section_head.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/messages.h"
#include "widgets/base/row_table.h"
#include "widgets/base/steady_label.h"
#include "widgets/forms/motor_converter.h"
#include "widgets/forms/motor_messages.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace widgets {

MotorForm::MotorForm(Device &device, RegisterModel &registers, MotorDescription &description,
    FilePrompt &files, QWidget *parent)
    : Form(parent)
    , m_device(device)
    , m_registers(registers)
    , m_description(description)
    , m_files(files)
{
    setObjectName(QStringLiteral("motorForm"));
    auto *layout = edged(new QHBoxLayout(this), kToolEdges, kGrid);
    layout->addWidget(makeLeft(), 1);
    layout->addWidget(makeRight());

    connect(&registers, &RegisterModel::catalogSet, this, &MotorForm::boardChanged);
    connect(&device, &Device::linkStateChanged, this, [this] {
        if (isVisible() && !m_asked)
            readAgain();
        showBoard();
    });
    connect(&device, &Device::readingsArrived, this,
        [this](const std::vector<drive::Reading> &readings) {
            const bool ours = std::any_of(readings.begin(), readings.end(), [&](const auto &one) {
                return std::find(m_ids.begin(), m_ids.end(), one.id) != m_ids.end();
            });
            if (ours)
                showBoard();
        });
    connect(&device, &Device::wishEnded, this, [this](const drive::Ended &ended) {
        if (ended.id != m_reading || m_reading == 0)
            return;
        m_reading = 0;
        if (ended.outcome != drive::Outcome::Ok) {
            m_asked = false;
            Q_EMIT failed(failureText(tr("Reading the motor's values"), ended));
        }
        showBoard();
    });
    connect(&description, &MotorDescription::changed, this, &MotorForm::showDescription);
    boardChanged();
    showDescription();
}

QPushButton *MotorForm::makeButton(const QString &text, const char *name, const QString &help)
{
    auto *button = named(new QPushButton(text, this), name);
    button->setToolTip(plainToolTip(help));
    return button;
}

QWidget *MotorForm::makeLeft()
{
    auto *left = new QWidget(this);
    m_again = makeButton(tr("Read a&gain"), "motorRead",
        tr("Reads these values from the board again; they are not polled."));
    m_open = makeButton(tr("&Open file\u2026"), "motorOpen",
        tr("Lays a motor file beside the board: of Rotorscope, of its simulator, or of ST's "
           "profiler."));
    m_close = makeButton(tr("&Close file"), "motorClose", tr("Ends the comparison with the file."));
    m_back = makeButton(tr("Take back"), "motorBack",
        tr("Takes the measured figures out of the description again that came into it last."));
    m_save = makeButton(tr("S&ave\u2026"), "motorSave",
        tr("Writes what the board says of its motor to a file, which the simulator takes, too; "
           "where measured figures are in use, the description that has them."));
    connect(m_again, &QPushButton::clicked, this, &MotorForm::readAgain);
    connect(m_open, &QPushButton::clicked, this, &MotorForm::openFile);
    connect(m_close, &QPushButton::clicked, this, &MotorForm::closeFile);
    connect(m_save, &QPushButton::clicked, this, &MotorForm::saveFile);
    connect(m_back, &QPushButton::clicked, &m_description, &MotorDescription::takeBack);
    auto *buttons = bare(new QHBoxLayout, kGrid);
    for (QPushButton *button : {m_again, m_open, m_close, m_back, m_save})
        buttons->addWidget(button);
    buttons->addStretch(1);

    m_reason = named(new SteadyLabel(left), "motorReason");
    m_reason->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    keepPlace(*m_reason); // what is below stays where it is
    m_tree = named(new QTreeView(left), "motorTree", tr("Motor and drive"));
    m_tree->setModel(&m_model);
    m_tree->setAlternatingRowColors(true);
    m_tree->setUniformRowHeights(true);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_tree->setMinimumHeight(120);
    QHeaderView *header = m_tree->header();
    header->setStretchLastSection(false);
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(MotorModel::ValueColumn, QHeaderView::Stretch);
    auto *copy = new QAction(tr("Copy"), m_tree);
    copy->setShortcut(QKeySequence::Copy);
    copy->setShortcutContext(Qt::WidgetShortcut);
    m_tree->addAction(copy);
    m_tree->setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(copy, &QAction::triggered, this, &MotorForm::copySelected);
    connect(&m_model, &QAbstractItemModel::modelReset, this, &MotorForm::expandGroups);
    m_told = wrappedLabel("motorTold", left);
    m_told->hide();

    auto *layout = bare(new QVBoxLayout(left), kHalfGrid);
    layout->addLayout(buttons);
    layout->addWidget(m_reason);
    layout->addWidget(m_told);
    layout->addWidget(m_tree, 1);
    return left;
}

QWidget *MotorForm::makeRight()
{
    auto *right = new QWidget(this);
    right->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
    m_warnings = wrappedLabel("motorWarnings", right);
    auto *group = new QWidget(right);
    m_converter = new MotorConverter(group);
    m_fromBoard = makeButton(tr("From the &board"), "convertBoard", {});
    connect(m_fromBoard, &QPushButton::clicked, this,
        [this] { m_converter->accept(m_facts ? drive::sheetOf(*m_facts) : motor::MotorSheet()); });
    auto *inner = bare(new QVBoxLayout(group), kHalfGrid);
    inner->addWidget(new SectionHead(tr("Converter"), group));
    inner->addWidget(m_converter);
    inner->addWidget(m_fromBoard, 0, Qt::AlignRight);
    auto *layout = bare(new QVBoxLayout(right), kGrid);
    layout->addWidget(m_warnings);
    layout->addWidget(group);
    layout->addStretch(1);
    return right;
}

void MotorForm::focusFirst() { m_tree->setFocus(Qt::ShortcutFocusReason); }

void MotorForm::showEvent(QShowEvent *event)
{
    Form::showEvent(event);
    if (!m_asked)
        readAgain();
}

/// Another board or motor, or none: its values come when it is looked at.
void MotorForm::boardChanged()
{
    const auto catalog = m_registers.catalog();
    m_ids = catalog && m_device.identified() ? drive::motorRegisters(*catalog, m_device.motor())
                                             : std::vector<catalog::RegisterId>();
    m_asked = false;
    m_reading = 0;
    m_facts.reset();
    if (isVisible())
        readAgain();
    showBoard();
}

void MotorForm::readAgain()
{
    if (!m_device.answering() || m_ids.empty() || m_reading != 0)
        return;
    m_asked = true;
    m_reading = m_device.submit(drive::Read{m_ids});
    enableButtons();
}

void MotorForm::showBoard()
{
    const auto catalog = m_registers.catalog();
    const auto known = [this](catalog::RegisterId id) { return m_registers.known(id); };
    const bool any = catalog
        && std::any_of(m_ids.begin(), m_ids.end(),
            [&](catalog::RegisterId id) { return m_registers.known(id).has_value(); });
    if (any) {
        m_facts = drive::motorFacts(*catalog, m_device.motor(), known);
        m_model.showBoard(*m_facts, drive::motorStructures(*catalog, m_device.motor(), known));
        m_converter->suggest(drive::sheetOf(*m_facts));
    } else if (m_model.rowCount() > 0) {
        m_model.clearBoard();
    }
    const bool answering = m_device.answering();
    m_reason->setText(any && answering ? QString()
            : any                      ? tr("Not connected: this is what the board said last.")
            : !answering ? tr("Connect to a board to see what it says of its motor. A file can be "
                              "looked at without.")
            : m_ids.empty() && m_device.identified() ? tr("This board does not describe its motor.")
                                                     : tr("The board is asked\u2026"));
    m_reason->setVisible(!m_reason->text().isEmpty());
    showWarnings();
    enableButtons();
}

void MotorForm::showWarnings()
{
    QStringList lines;
    if (m_facts) {
        const motor::DriveLimits drive{
            m_facts->bus_v, m_facts->limits.maxCurrentAmps, m_facts->limits.maxSpeedRpm};
        for (const auto warning : motor::checkMotor(m_facts->motor, drive))
            lines.append(QStringLiteral("\u26a0 ") + motorWarningText(warning));
        if (lines.isEmpty())
            lines.append(QStringLiteral("\u2713 ") + tr("The board's motor looks plausible."));
    }
    m_warnings->setText(lines.join(QLatin1Char('\n')));
    m_warnings->setVisible(!lines.isEmpty());
}

void MotorForm::expandGroups()
{
    m_tree->expandAll();
    m_tree->setColumnHidden(MotorModel::FileColumn, !m_model.hasFile());
    m_tree->resizeColumnToContents(MotorModel::ValueColumn);
    m_tree->setColumnWidth(
        MotorModel::ValueColumn, std::min(m_tree->columnWidth(MotorModel::ValueColumn) + 12, 260));
}

void MotorForm::enableButtons()
{
    m_again->setEnabled(m_device.answering() && !m_ids.empty() && m_reading == 0);
    m_save->setEnabled(m_facts.has_value() || m_description.holdsMeasured());
    m_close->setEnabled(m_model.hasFile());
    m_back->setEnabled(m_description.holdsMeasured());
    m_fromBoard->setEnabled(m_facts.has_value());
    m_fromBoard->setToolTip(
        plainToolTip(m_facts ? tr("Begins again with the board's values.") : m_reason->text()));
}

void MotorForm::say(const QString &sentence, bool bad)
{
    m_told->setText(bad ? QStringLiteral("\u2716 ") + sentence : sentence);
    QPalette colors = palette();
    if (bad)
        colors.setColor(QPalette::WindowText, Lamp::colorOf(Lamp::Light::Bad, palette()));
    m_told->setPalette(colors);
    m_told->setVisible(!sentence.isEmpty());
}

void MotorForm::openFile()
{
    m_files.askOpen(this, {tr("Open a motor file"), orHome(m_folder), tr("Motor files (*.json)")},
        [this](const QString &path) { accept(path); });
}

void MotorForm::accept(const QString &path)
{
    m_folder = QFileInfo(path).path();
    const QString name = fileNameText(path);
    const auto file = session::readMotorFile(path);
    if (!file) {
        say(tr("%1 was not opened. %2", "file, sentence")
                .arg(name, motorFileErrorText(file.error())),
            true);
        return;
    }
    const motor::MotorSheet sheet = file->sheet();
    m_description.open(sheet);
    if (!sheet.name.empty() && sheet.inertia_kgm2.value_or(0.0) > 0.0)
        Q_EMIT inertiaFound(deviceText(sheet.name), *sheet.inertia_kgm2);
    QString sentence = file->origin == session::MotorFile::Origin::St
        ? tr("%1: a motor from ST's tools.").arg(name)
        : tr("%1: a motor file.").arg(name);
    if (m_facts && m_model.compared() > 0)
        sentence += QLatin1Char(' ')
            + (m_model.differences() == 0
                    ? tr("Nothing differs from the board.")
                    : tr("%n value(s) differ from the board.", nullptr, m_model.differences()));
    for (const auto note : file->notes)
        sentence += QLatin1Char(' ') + motorFileNoteText(note);
    say(sentence);
    m_tree->scrollToTop();
    enableButtons();
}

void MotorForm::closeFile()
{
    m_description.close();
    say({});
}

void MotorForm::showDescription()
{
    m_model.showFile(m_description.sheet());
    if (m_description.holdsMeasured())
        say(tr("The description beside the board holds measured figures; Save writes them to a "
               "file."));
    else if (!m_model.hasFile())
        say({});
    enableButtons();
}

void MotorForm::saveFile()
{
    std::optional<motor::MotorSheet> sheet;
    if (m_description.holdsMeasured())
        sheet = m_description.sheet();
    else if (m_facts)
        sheet = drive::sheetOf(*m_facts);
    if (!sheet)
        return;
    m_files.askSave(this,
        {tr("Save the motor"), orHome(m_folder), QStringLiteral("motor.json"),
            tr("Motor files (*.json)"), QStringLiteral("json")},
        [this, sheet = *sheet](const QString &path) {
            m_folder = QFileInfo(path).path();
            const QString problem = session::writeWholeFile(path, session::motorJson(sheet));
            const QString name = fileNameText(path);
            say(problem.isEmpty() ? tr("Saved as %1.").arg(name)
                                  : tr("%1 was not saved: %2", "file, reason").arg(name, problem),
                !problem.isEmpty());
        });
}

void MotorForm::copySelected()
{
    QStringList lines;
    for (const QModelIndex &index : m_tree->selectionModel()->selectedRows())
        lines.append(rowText(index));
    if (!lines.isEmpty())
        QApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

} // namespace widgets
