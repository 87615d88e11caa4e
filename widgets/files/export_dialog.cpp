#include "widgets/files/export_dialog.h"

#include "capture/csv_export.h"
#include "session/files/motion_log_file.h"
#include "widgets/base/device_text.h"
#include "widgets/base/file_prompt.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/files/scope_picture.h"
#include "widgets/scope/view.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDateTime>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace widgets {
namespace {

/// "x.csv" and "HF" make "x_HF.csv", or "x_HF_2.csv" where that is taken: some disks do not tell capitals from others.
QString partPath(const QString &path, const QString &part, const QList<ExportOrder::Part> &taken)
{
    const QFileInfo info(path);
    const QString stem = info.completeBaseName() + QLatin1Char('_') + part;
    const auto named = [&info](const QString &name) {
        return QDir(info.path()).filePath(name + QStringLiteral(".csv"));
    };
    const auto isTaken = [&taken](const QString &one) {
        return std::any_of(taken.begin(), taken.end(), [&one](const ExportOrder::Part &other) {
            return one.compare(other.path, Qt::CaseInsensitive) == 0;
        });
    };
    QString found = named(stem);
    for (int i = 2; isTaken(found); ++i)
        found = named(QStringLiteral("%1_%2").arg(stem, QString::number(i)));
    return found;
}

QString partName(const capture::Channel &channel)
{
    using Kind = capture::ChannelInfo::Kind;
    switch (channel.info().kind) {
    case Kind::Fast:
        return QStringLiteral("HF");
    case Kind::Slow:
        return QStringLiteral("MF");
    case Kind::Polled:
        break;
    }
    QString name;
    for (const QChar c : deviceText(channel.info().name)) // what every file system takes
        name += c.unicode() < 128 && (c.isLetterOrNumber() || c == QLatin1Char('_'))
            ? c
            : QLatin1Char('-');
    return name;
}

} // namespace

QString suggestedCaptureName(const QDateTime &now, const QString &suffix)
{
    return QLocale::c().toString(now, QStringLiteral("yyyy-MM-dd_HH-mm-ss"))
        + QStringLiteral("_motor_capture.") + suffix;
}

ExportDialog::ExportDialog(capture::Capture &capture, ScopeView &scope, FilePrompt &files,
    const QString &folder, QWidget *parent)
    : QDialog(parent)
    , m_capture(capture)
    , m_scope(scope)
    , m_files(files)
    , m_folder(folder)
    , m_format(named(new QComboBox(this), "exportFormat"))
    , m_range(named(new QComboBox(this), "exportRange"))
    , m_rates(named(new QComboBox(this), "exportRates"))
    , m_summary(wrappedLabel("exportSummary", this))
{
    setObjectName(QStringLiteral("exportDialog"));
    setWindowTitle(tr("Export"));
    setModal(true);
    const auto add = [this](const char *title, const char *name) {
        m_format->addItem(
            QCoreApplication::translate("ExportFormat", title), QString::fromLatin1(name));
    };
    for (const session::ExportFormat &each : session::exportFormats())
        add(each.title, each.name);
    for (const PictureFormat &each : pictureFormats())
        add(each.title, each.suffix);
    m_range->addItem(tr("What the scope shows"), Visible);
    m_range->addItem(tr("Everything recorded"), Everything);
    if (m_scope.cursors().visible())
        m_range->addItem(tr("Between the cursors A and B"), Cursors);
    m_rates->addItem(tr("One file; slower signals keep their last value"));
    m_rates->addItem(tr("One file for each rate"));
    m_summary->setEnabled(false);

    auto *buttons = new QDialogButtonBox(this);
    m_save = buttons->addButton(tr("Export\u2026"), QDialogButtonBox::AcceptRole);
    m_save->setObjectName(QStringLiteral("exportSave"));
    buttons->addButton(QDialogButtonBox::Cancel)->setObjectName(QStringLiteral("exportCancel"));
    connect(m_save, &QPushButton::clicked, this, &ExportDialog::ask);
    connect(buttons, &QDialogButtonBox::rejected, this, &ExportDialog::reject);
    for (const QComboBox *choice : {m_format, m_range})
        connect(choice, &QComboBox::currentIndexChanged, this, &ExportDialog::updateSummary);

    auto *form = new QFormLayout;
    form->addRow(tr("&Format"), m_format);
    form->addRow(tr("&Range"), m_range);
    form->addRow(tr("R&ates"), m_rates);
    auto *layout = edged(new QVBoxLayout(this), kDialogEdges, kGrid);
    layout->addLayout(form);
    layout->addWidget(m_summary);
    layout->addWidget(buttons);
    setMinimumWidth(420);
    updateSummary();
}

const session::ExportFormat *ExportDialog::format() const
{
    return session::exportFormatNamed(m_format->currentData().toString().toStdString());
}

const PictureFormat *ExportDialog::picture() const
{
    const std::span<const PictureFormat> all = pictureFormats();
    const auto found = std::find_if(all.begin(), all.end(), [this](const PictureFormat &each) {
        return m_format->currentData() == QLatin1String(each.suffix);
    });
    return found == all.end() ? nullptr : &*found;
}

QString ExportDialog::suffix() const
{
    if (const PictureFormat *drawn = picture())
        return QString::fromLatin1(drawn->suffix);
    const session::ExportFormat *written = format();
    return written != nullptr ? QString::fromLatin1(written->suffix) : QString();
}

std::optional<capture::TimeSpan> ExportDialog::range() const
{
    if (m_range->currentData() == Visible) {
        const ScopeView::TimeRange shown = m_scope.visibleRange();
        return capture::TimeSpan{shown.from, shown.to};
    }
    if (m_range->currentData() == Cursors) {
        const CursorPair &pair = m_scope.cursors().pair();
        return capture::TimeSpan{std::min(pair.a, pair.b), std::max(pair.a, pair.b)};
    }
    return {};
}

capture::Snapshot ExportDialog::snapshot() const
{
    std::vector<capture::ChannelId> ids;
    if (m_range->currentData() == Everything) {
        for (const capture::ChannelInfo &info : m_capture.channels())
            ids.push_back(info.id);
    } else {
        const auto shown = m_scope.channels();
        ids.assign(shown.begin(), shown.end());
    }
    return m_capture.snapshot(ids);
}

QString ExportDialog::emptyText() const
{
    return m_capture.channels().empty() ? tr("Nothing has been recorded yet.")
                                        : tr("No trace is shown. Choose everything recorded.");
}

void ExportDialog::updateSummary()
{
    using Holds = session::ExportFormat::Holds;
    const session::ExportFormat *chosen = format();
    const bool rows = chosen && chosen->holds == Holds::RowsOfTheFastest;
    m_range->setEnabled(chosen);
    m_rates->setEnabled(rows);
    const auto channels = snapshot();
    m_save->setEnabled(!channels->empty());
    if (channels->empty()) {
        m_summary->setText(emptyText());
    } else if (!chosen) {
        m_summary->setText(tr("The scope as it is on the screen now."));
    } else if (rows) {
        m_summary->setText(
            tr("%n signal(s). The first column is the time in seconds. Lost samples have no row.",
                nullptr, static_cast<int>(channels->size())));
    } else if (chosen->holds == Holds::FastSignals) {
        m_summary->setText(tr("The 16-bit codes of the fast signals, a channel each, at their own "
                              "rate; where samples were lost the next ones follow at once."));
    } else {
        m_summary->setText(tr("%n signal(s), every sample with its time; what is unknown is NaN.",
            nullptr, static_cast<int>(channels->size())));
    }
}

void ExportDialog::ask()
{
    const SaveQuestion question{tr("Export"), orHome(m_folder),
        suggestedCaptureName(QDateTime::currentDateTime(), suffix()),
        tr("%1 files (*.%2)").arg(suffix().toUpper(), suffix()), suffix()};
    m_files.askSave(this, question, [this](const QString &path) { order(path); });
}

/// The files that it would replace and the prompt has not asked about: it knows the name that was typed only. A user
/// who agreed to replace that one means its log, too.
QStringList ExportDialog::taken(const ExportOrder &order) const
{
    QStringList names;
    const auto check = [&names](const QString &path) {
        if (QFileInfo::exists(path))
            names.append(QFileInfo(path).fileName());
    };
    for (const ExportOrder::Part &part : order.parts)
        if (part.path != order.path)
            check(part.path);
    const bool agreed = !order.parts.isEmpty() && order.parts.first().path == order.path
        && QFileInfo::exists(order.path);
    if (!order.motionLog.isEmpty() && !agreed)
        check(order.motionLog);
    return names;
}

void ExportDialog::order(const QString &path)
{
    ExportOrder made{format(), picture(), path, {}, range(), {}};
    const capture::Snapshot all = snapshot();
    if (m_rates->isEnabled() && m_rates->currentIndex() == 1) {
        for (const capture::Snapshot &part : capture::splitByRate(all))
            made.parts.append({partPath(path, partName(part->front()), made.parts), part});
    } else if (made.format) {
        made.parts.append({path, all});
    }
    if (made.parts.isEmpty() && made.format) {
        m_summary->setText(emptyText());
        return;
    }
    if (!made.parts.isEmpty() && m_hasLog && m_hasLog())
        made.motionLog = session::motionLogPath(made.parts.first().path);
    if (const QStringList there = taken(made); !there.isEmpty()) {
        m_summary->setText(tr("%1 exists already. Choose another name.")
                               .arg(deviceText(there.join(QStringLiteral(", ")))));
        return;
    }
    Q_EMIT wanted(made);
    accept();
}

} // namespace widgets
