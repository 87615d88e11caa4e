// Bands over each other against a pixel-by-pixel rule: none hides another, and every covered pixel is painted.
#include "widgets/scope/drawing/trace_bands.h"

#include <QTest>

#include <random>

using widgets::Band;
using widgets::PixelColumns;

namespace {

constexpr QRgb kBehind = 0xFF123456;
constexpr QRgb kGround = 0xFFFEFDFC;

struct Picture {
    int width, height, stripe;
    std::vector<PixelColumns> columns;
    std::int64_t first = 0; ///< number of the left column

    std::vector<Band> bands() const
    {
        std::vector<Band> result;
        for (std::size_t i = 0; i < columns.size(); ++i)
            result.push_back({0xFF000000U + QRgb(i + 1) * 1111U, &columns[i]});
        return result;
    }
    bool covers(std::size_t band, int x, int y) const
    {
        const auto at = std::size_t(x);
        return columns[band].top[at] <= y && y <= columns[band].bottom[at];
    }
    /// The colour of the band whose stripe it is if that is there, else of the first that is.
    QRgb expected(int x, int y, QRgb behind) const
    {
        const auto period = stripe * std::int64_t(columns.size());
        // Numbers may be below zero.
        const auto place = ((first + x + y) % period + period) % period;
        const auto owner = std::size_t(place / stripe);
        if (covers(owner, x, y))
            return bands()[owner].color;
        for (std::size_t band = 0; band < columns.size(); ++band) {
            if (covers(band, x, y))
                return bands()[band].color;
        }
        return behind;
    }
};

/// Bands with noisy or ragged edges, holes and peaks, partly outside of the picture.
Picture randomPicture(std::mt19937 &random)
{
    const auto below = [&random](int bound) { return int(random() % unsigned(bound)); };
    Picture picture{1 + below(90), 1 + below(70), 1 + below(6), {}, below(2000) - 1000};
    const int count = 1 + below(below(4) == 0 ? 32 : 9);
    for (int band = 0; band < count; ++band) {
        PixelColumns columns(picture.width);
        const int top = below(picture.height + 20) - 10;
        const int tall = below(picture.height + 10);
        const int noise = 1 + below(below(3) == 0 ? picture.height : 4);
        const int holes = below(3) == 0 ? 5 : 1000;
        for (int x = 0; x < picture.width; ++x) {
            if (below(holes) != 0)
                columns.set(x, top + below(noise), top + tall + below(noise));
        }
        picture.columns.push_back(columns);
    }
    return picture;
}

} // namespace

class TestTraceBands : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyPixelHasTheColourOfItsStripeOrOfTheFirstBandThere()
    {
        std::mt19937 random(5);
        for (int round = 0; round < 400; ++round) {
            const Picture picture = randomPicture(random);
            const bool grounded = random() % 2 == 0;
            QImage image(picture.width, picture.height, QImage::Format_ARGB32_Premultiplied);
            image.fill(kBehind);
            const auto bands = picture.bands();
            const QRgb behind = grounded ? kGround : kBehind;
            widgets::paintBands(image, bands, picture.stripe, picture.first,
                grounded ? std::optional<QRgb>(kGround) : std::nullopt);
            for (int y = 0; y < picture.height; ++y) {
                for (int x = 0; x < picture.width; ++x)
                    QCOMPARE(image.pixel(x, y), picture.expected(x, y, behind));
            }
        }
    }

    void fortyBandsLoseNoPixel()
    {
        Picture picture{50, 40, 3, {}, 0};
        for (int band = 0; band < 40; ++band) {
            PixelColumns columns(picture.width);
            for (int x = 0; x < picture.width; ++x)
                columns.set(x, band, band + 2);
            picture.columns.push_back(columns);
        }
        QImage image(picture.width, picture.height, QImage::Format_ARGB32_Premultiplied);
        image.fill(kBehind);
        const auto bands = picture.bands();
        widgets::paintBands(image, bands, picture.stripe, 0, kGround);
        for (int y = 0; y < picture.height; ++y) {
            for (int x = 0; x < picture.width; ++x)
                QVERIFY(image.pixel(x, y) != kGround && image.pixel(x, y) != kBehind);
        }
    }

    void withoutABandAllIsGround()
    {
        QImage image(20, 10, QImage::Format_ARGB32_Premultiplied);
        image.fill(kBehind);
        widgets::paintBands(image, {}, 3, 0, kGround);
        QCOMPARE(image.pixel(7, 7), kGround);
    }
};

QTEST_GUILESS_MAIN(TestTraceBands)
#include "tst_trace_bands.moc"
