#include "widgets/files/scope_picture.h"

#include "widgets/base/look/theme.h"
#include "widgets/scope/view.h"

#include <QBuffer>
#include <QImage>
#include <QPageSize>
#include <QPdfWriter>
#include <QPixmap>
#include <QSvgGenerator>

namespace widgets {
namespace {

constexpr int kDotsPerInch = 96; ///< a pixel of the screen is a pixel of the picture

/// Paper is white: while it lives, the scope has the light colours. What is drawn on the screen waits until it is over.
class OnPaper {
public:
    explicit OnPaper(ScopeView &scope)
        : m_scope(scope)
        , m_palette(scope.palette())
        , m_own(scope.testAttribute(Qt::WA_SetPalette))
    {
        scope.setPalette(lightPalette());
    }
    ~OnPaper() { m_scope.setPalette(m_own ? m_palette : QPalette()); }
    OnPaper(const OnPaper &) = delete;
    OnPaper &operator=(const OnPaper &) = delete;

private:
    ScopeView &m_scope;
    QPalette m_palette;
    bool m_own;
};

void drawOnPaper(ScopeView &scope, QPaintDevice &device)
{
    const OnPaper paper(scope);
    scope.drawShapes(device);
}

QByteArray svgOf(ScopeView &scope)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator svg;
    const QSize size = scope.shapesSize();
    svg.setOutputDevice(&buffer);
    svg.setResolution(kDotsPerInch);
    svg.setSize(size);
    svg.setViewBox(QRect({}, size));
    svg.setTitle(QStringLiteral("Rotorscope"));
    drawOnPaper(scope, svg);
    return buffer.data();
}

QByteArray pdfOf(ScopeView &scope)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter pdf(&buffer);
        pdf.setResolution(kDotsPerInch);
        const QSizeF points = QSizeF(scope.shapesSize()) * 72.0 / kDotsPerInch;
        pdf.setPageSize(QPageSize(points, QPageSize::Point));
        pdf.setPageMargins(QMarginsF());
        drawOnPaper(scope, pdf);
    }
    return buffer.data();
}

QByteArray pngOf(ScopeView &scope)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    scopeImage(scope).save(&buffer, "PNG");
    return buffer.data();
}

constexpr PictureFormat kPictures[] = {
    {"png", QT_TRANSLATE_NOOP("ExportFormat", "Picture of the scope, PNG"), pngOf},
    {"svg", QT_TRANSLATE_NOOP("ExportFormat", "Picture of the plots, SVG"), svgOf},
    {"pdf", QT_TRANSLATE_NOOP("ExportFormat", "Picture of the plots, PDF"), pdfOf}};

} // namespace

QImage scopeImage(ScopeView &scope)
{
    QImage image;
    {
        const OnPaper paper(scope);
        scope.catchUp();
        image = scope.grab().toImage();
    }
    scope.catchUp(); // the screen does not flash
    return image;
}

std::span<const PictureFormat> pictureFormats() { return kPictures; }

session::FileResult writePicture(ScopeView &scope, const PictureFormat &format, const QString &path)
{
    const QByteArray bytes = format.draw(scope);
    bool written = false;
    return session::writePieces(path, [&](std::string_view &piece) {
        piece = {bytes.constData(), static_cast<std::size_t>(bytes.size())};
        return !std::exchange(written, true);
    });
}

} // namespace widgets
