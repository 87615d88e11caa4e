// NameElision: names of registers that are cut so that they stay different. A board has whole families of names that
// begin and end alike (CL_CUR_D_SET_POINT, CL_CUR_Q_SET_POINT): what is cut off in their middle would be all that tells
// them apart.
#pragma once

#include <QFontMetrics>
#include <QHash>
#include <QStringList>

#include <map>
#include <optional>
#include <vector>

namespace widgets {

class NameElision {
public:
    void setNames(QStringList names); ///< among which each is to be known

    /// The whole name where it fits, in pixels. The first one of a width costs a few milliseconds for all.
    QString text(const QString &name, const QFontMetrics &metrics, int width);

private:
    using Texts = QHash<QString, QString>;
    Texts textsOf(const QFontMetrics &metrics, int width) const;

    QStringList m_names;
    std::optional<QFontMetrics> m_metrics;
    std::map<int, Texts> m_texts; ///< by width
};

} // namespace widgets
