#include "widgets/control/fault_help.h"

#include "widgets/base/device_text.h"
#include "widgets/base/look/named.h"
#include "widgets/control/fault_picture.h"
#include "widgets/control/fault_texts.h"
#include "widgets/control/motor_button.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace widgets {
namespace {

QString sectionOf(const std::string &name)
{
    const FaultText text = faultText(catalog::faultKindOf(name));
    QString html = QStringLiteral("<h3>%1</h3><p>%2</p><ol>")
                       .arg(deviceText(name).toHtmlEscaped(), text.meaning.toHtmlEscaped());
    for (const FaultText::Cause &cause : text.causes)
        html += QStringLiteral("<li><p><b>%1.</b> %2</p></li>")
                    .arg(cause.cause.toHtmlEscaped(), cause.remedy.toHtmlEscaped());
    return html + QStringLiteral("</ol>");
}

} // namespace

FaultHelp::FaultHelp(Device &device, const FaultRecords &records, QWidget *parent)
    : QDialog(parent)
    , m_device(device)
    , m_picture(new FaultPicture(records, this))
    , m_text(named(new QTextBrowser(this), "faultHelpText"))
{
    setObjectName(QStringLiteral("faultHelp"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Faults and their causes"));
    m_text->setAccessibleName(windowTitle());
    m_text->setOpenLinks(false);
    auto *stop = named(new StopButton(this), "faultHelpStop");
    connect(stop, &StopButton::stopPressed, &device, &Device::stop);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *bottom = new QHBoxLayout;
    bottom->addWidget(stop);
    bottom->addStretch(1);
    bottom->addWidget(buttons);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(m_picture, 3);
    layout->addWidget(m_text, 2);
    layout->addLayout(bottom);
    QSize size(760, records.records().empty() ? 460 : 620);
    if (parent != nullptr) // on a small screen its Stop would be below the edge
        size = size.boundedTo(parent->window()->size());
    resize(size);
    connect(&device, &Device::statusChanged, this, &FaultHelp::update);
    connect(&device, &Device::motorChanged, this, [this] {
        update();
        m_picture->showNewestOf(m_device.motor());
    });
    connect(&device, &Device::linkStateChanged, this, &FaultHelp::update);
    update();
}

void FaultHelp::present()
{
    m_picture->showNewestOf(m_device.motor());
    show();
    raise();
    activateWindow();
}

QString FaultHelp::plainText() const { return m_text->toPlainText(); }

void FaultHelp::update()
{
    const drive::MotorStatus status = m_device.status(m_device.motor());
    QString html;
    const auto part = [&html](const QString &title, const std::vector<std::string> &names) {
        if (names.empty())
            return;
        html += QStringLiteral("<h2>%1</h2>").arg(title.toHtmlEscaped());
        for (const std::string &name : names)
            html += sectionOf(name);
    };
    const QString motor = QString::number(m_device.motor());
    if (!m_device.statusIsNow(m_device.motor()))
        html = QStringLiteral("<p>%1</p>").arg(tr("Faults are not known").toHtmlEscaped());
    else if (status.faultsNow.empty() && status.faultsPast.empty())
        html = QStringLiteral("<p>%1</p>").arg(tr("Motor %1 has no fault.").arg(motor));
    else {
        part(tr("Present at motor %1").arg(motor), status.faultsNow);
        part(tr("Over, to be acknowledged"), faultsOver(status));
    }
    if (m_html == html)
        return; // the place that is read stays where it is
    m_html = html;
    m_text->setHtml(html);
}

} // namespace widgets
