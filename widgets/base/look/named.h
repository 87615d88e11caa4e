// named(): gives a part of the window the name by which others find it, where it is made.
#pragma once

#include <QString>

namespace widgets {

/// @return  that part
template <class Part>
Part *named(Part *part, const char *name)
{
    part->setObjectName(QLatin1String(name));
    return part;
}

/// @param says  what it is called where it is read out
template <class Part>
Part *named(Part *part, const char *name, const QString &says)
{
    part->setAccessibleName(says);
    return named(part, name);
}

} // namespace widgets
