#include "widgets/base/look/section_head.h"

#include "widgets/base/look/spacing.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>

namespace widgets {

SectionHead::SectionHead(const QString &name, QWidget *parent)
    : QWidget(parent)
{
    auto *label = new QLabel(name, this);
    label->setTextFormat(Qt::PlainText);
    label->setFont(inBold(label->font()));
    auto *line = new QFrame(this);
    line->setFrameShape(QFrame::HLine);
    line->setFrameShadow(QFrame::Sunken);
    auto *layout = bare(new QHBoxLayout(this), kGrid);
    layout->addWidget(label);
    layout->addWidget(line, 1);
}

} // namespace widgets
