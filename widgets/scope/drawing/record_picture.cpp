#include "widgets/scope/drawing/record_picture.h"

#include "widgets/scope/drawing/trace_ink.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace widgets {

namespace {
/// Times that lie less than this apart, in pixels, are the same: they are sums of seconds.
constexpr double kSame = 1e-3;
} // namespace

bool RecordPicture::suits(const Look &look) const
{
    const double pixel = look.span / look.size.width();
    return look.size == m_look.size && std::abs(look.span - m_look.span) < kSame * pixel
        && look.traces == m_look.traces;
}

void RecordPicture::update(const Look &look, std::vector<Record> records, const Paint &paint)
{
    const double pixel = look.span / look.size.width();
    const auto same = [pixel](const Record &a, const Record &b) {
        return a.samples == b.samples && a.ends == b.ends
            && std::abs(a.from - b.from) < kSame * pixel;
    };
    const auto perRecord = static_cast<QRgb>(look.traces.size());
    // Of those that are painted the newer ones are wanted, and nothing between or below them.
    std::size_t kept = 0;
    if (suits(look) && !records.empty()) {
        const auto oldest = std::find_if(m_records.begin(), m_records.end(),
            [&](const Record &one) { return same(one, records.front()); });
        const auto count = static_cast<std::size_t>(m_records.end() - oldest);
        if (count <= records.size() && std::equal(oldest, m_records.end(), records.begin(), same))
            kept = count;
    }
    const auto last = static_cast<QRgb>(m_records.size() - kept);
    m_first += last * perRecord;
    if (kept == 0 || m_first > std::numeric_limits<QRgb>::max() / 2) {
        if (m_picture.size() != look.size)
            m_picture = QImage(look.size, QImage::Format_ARGB32_Premultiplied);
        m_picture.fill(0U);
        m_first = 1;
        kept = 0;
    }
    ImageInk ink(m_picture, std::nullopt);
    for (std::size_t i = kept; i < records.size(); ++i)
        paint(i, ink, m_first + static_cast<QRgb>(i) * perRecord);
    m_look = look;
    m_records = std::move(records);
}

void RecordPicture::drawOn(QImage &image, std::span<const QRgb> colors, QRgb ground) const
{
    const int width = m_picture.width(); // asked for each pixel it is a call, and a tenth of this
    for (int y = 0; y < m_picture.height(); ++y) {
        const auto *from = reinterpret_cast<const QRgb *>(m_picture.constScanLine(y));
        auto *to = reinterpret_cast<QRgb *>(image.scanLine(y));
        for (int x = 0; x < width; ++x) {
            const QRgb place = from[x] - m_first; // of what is no longer wanted: beyond all colours
            to[x] = place < colors.size() ? colors[place] : ground;
        }
    }
}

} // namespace widgets
