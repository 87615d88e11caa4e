// The head of a section of a panel: its name, and a line from there to the edge. All of them alike.
#pragma once

#include <QWidget>

namespace widgets {

class SectionHead : public QWidget {
public:
    SectionHead(const QString &name, QWidget *parent);
};

} // namespace widgets
