#include "widgets/registers/name_elision.h"

#include <algorithm>

namespace widgets {
namespace {

constexpr QChar kDots(0x2026);
constexpr int kKerning = 3; ///< pixels that a text may be wider than its letters
/// That are kept: those of a column that is being drawn wider are used once.
constexpr std::size_t kMostWidths = 8;

/// A name and how far each of its beginnings reaches.
class Measured {
public:
    Measured(const QString &name, const QFontMetrics &metrics)
        : m_name(name)
    {
        for (const QChar letter : name)
            m_reach.push_back(m_reach.back() + metrics.horizontalAdvance(letter));
    }
    const QString &name() const { return m_name; }
    int width() const { return m_reach.back(); }
    /// Letters before the cut, where what is left is as wide before it as behind it. @param room  without the dots
    int middle(int room) const
    {
        const auto past = std::upper_bound(m_reach.begin(), m_reach.end(), room / 2);
        return static_cast<int>(past - m_reach.begin()) - 1;
    }
    /// With so many letters before the cut, and as many behind it as there is room for.
    QString cut(int before, int room) const
    {
        const int letters = static_cast<int>(m_name.size());
        before = std::clamp(before, 0, letters);
        int behind = letters - before;
        while (behind > 0
            && m_reach[std::size_t(before)] + width() - m_reach[std::size_t(letters - behind)]
                > room)
            --behind;
        return m_name.left(before) + kDots + m_name.right(behind);
    }

private:
    QString m_name;
    std::vector<int> m_reach{0};
};

/// Of names that look alike cut in their middle: cut as near to it as tells them apart, or most of them.
QStringList apart(const std::vector<const Measured *> &names, int room)
{
    const int middle = names.front()->middle(room);
    const auto cutAt = [&](int before) {
        QStringList texts;
        for (const Measured *name : names)
            texts.append(name->cut(before, room));
        return texts;
    };
    const auto different = [](QStringList texts) {
        texts.removeDuplicates();
        return texts.size();
    };
    QStringList best = cutAt(middle);
    for (int off = 1; off <= 2 * middle && different(best) < best.size(); ++off)
        for (const int before : {middle + off, middle - off}) {
            if (before < 0 || before > 2 * middle)
                continue;
            if (QStringList texts = cutAt(before); different(texts) > different(best))
                best = std::move(texts);
        }
    return best;
}

} // namespace

void NameElision::setNames(QStringList names)
{
    names.removeDuplicates();
    m_names = std::move(names);
    m_texts.clear();
}

QString NameElision::text(const QString &name, const QFontMetrics &metrics, int width)
{
    if (metrics.horizontalAdvance(name) <= width)
        return name;
    if (m_metrics != metrics || m_texts.size() >= kMostWidths)
        m_texts.clear();
    m_metrics = metrics;
    auto known = m_texts.find(width);
    if (known == m_texts.end())
        known = m_texts.emplace(width, textsOf(metrics, width)).first;
    return known->second.value(name, name);
}

NameElision::Texts NameElision::textsOf(const QFontMetrics &metrics, int width) const
{
    const int room = width - metrics.horizontalAdvance(kDots) - kKerning;
    std::vector<Measured> names;
    for (const QString &name : m_names)
        if (metrics.horizontalAdvance(name) > width)
            names.emplace_back(name, metrics);
    QHash<QString, std::vector<const Measured *>> alike;
    for (const Measured &name : names)
        alike[name.cut(name.middle(room), room)].push_back(&name);
    Texts texts;
    for (const std::vector<const Measured *> &group : std::as_const(alike)) {
        const QStringList cut = apart(group, room);
        for (std::size_t i = 0; i < group.size(); ++i)
            texts.insert(group[i]->name(), cut[qsizetype(i)]);
    }
    return texts;
}

} // namespace widgets
