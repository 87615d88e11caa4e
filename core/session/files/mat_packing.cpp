#include "session/files/mat_packing.h"

#include <zlib.h>

#include <QScopeGuard>
#include <QtEndian>

#include <algorithm>

namespace session {

namespace {

constexpr qint64 kHeader = 128; ///< bytes in front of the first variable
constexpr qint64 kTag = 8; ///< bytes: type and size of an element
constexpr std::uint32_t kPackedType = 15; ///< miCOMPRESSED
constexpr int kLevel = 1;
constexpr qint64 kPackedAtOnce = 1 << 20; ///< bytes

} // namespace

MatPacking::MatPacking(QFile &plain, std::function<bool(double)> proceed)
    : m_plain(plain)
    , m_proceed(std::move(proceed))
{
}

bool MatPacking::next(std::string_view &piece)
{
    if (m_plain.pos() == 0) {
        m_piece = m_plain.read(kHeader);
        m_failed = m_piece.size() != kHeader;
    } else if (m_plain.atEnd()) {
        return false;
    } else {
        const QByteArray tag = m_plain.peek(kTag);
        m_failed = tag.size() != kTag;
        if (!m_failed)
            pack(kTag + qFromLittleEndian<std::uint32_t>(tag.constData() + sizeof(std::uint32_t)));
    }
    piece = {m_piece.constData(), static_cast<std::size_t>(m_piece.size())};
    return true;
}

/// The element of `size` bytes that stands next, as one packed element.
void MatPacking::pack(qint64 size)
{
    QByteArray room(kPackedAtOnce, Qt::Uninitialized);
    m_piece.fill('\0', kTag);
    z_stream packer{};
    m_failed = deflateInit(&packer, kLevel) != Z_OK;
    const auto end = qScopeGuard([&packer] { (void)deflateEnd(&packer); });
    for (qint64 left = size; left > 0 && goesOn();) {
        QByteArray plain = m_plain.read(std::min(left, kPackedAtOnce));
        m_failed = plain.isEmpty();
        left -= plain.size();
        packer.next_in = reinterpret_cast<Bytef *>(plain.data());
        packer.avail_in = static_cast<uInt>(plain.size());
        do {
            packer.next_out = reinterpret_cast<Bytef *>(room.data());
            packer.avail_out = static_cast<uInt>(room.size());
            (void)deflate(&packer, left > 0 ? Z_NO_FLUSH : Z_FINISH);
            m_piece.append(
                room.constData(), room.size() - static_cast<qsizetype>(packer.avail_out));
        } while (packer.avail_out == 0);
        m_cancelled =
            !m_proceed(static_cast<double>(m_plain.pos()) / static_cast<double>(m_plain.size()));
    }
    if (!goesOn()) {
        m_piece.clear();
        return;
    }
    qToLittleEndian(kPackedType, m_piece.data());
    qToLittleEndian(
        static_cast<std::uint32_t>(m_piece.size() - kTag), m_piece.data() + sizeof(std::uint32_t));
}

} // namespace session
