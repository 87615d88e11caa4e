// What the judge of the screen takes for the values that a board gave. Bytes are written here by hand.
#include "support/wire/mcp.h"
#include "support/wire/mcp_board.h"

#include <QTest>

using namespace std::chrono_literals;

namespace {

constexpr std::uint16_t kSpeed = 5 << 6 | 3 << 3 | 1; ///< of 32 bits, motor 1

Bytes header(std::uint32_t word)
{
    word |= judge::WireMcp::checkOf(word) << 28;
    return {std::uint8_t(word), std::uint8_t(word >> 8), std::uint8_t(word >> 16),
        std::uint8_t(word >> 24)};
}

} // namespace

class TestGivenValues : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void anAnswerIsWhatWasAskedFor()
    {
        judge::McpBoard board;
        asks(board);
        answers(board, 7);
        QCOMPARE(board.given().of(kSpeed).size(), std::size_t{1});
        QCOMPARE(board.given().of(kSpeed).back().number, 7.0);
    }

    /// The payload of a request is on its way while the board begins anew, and makes no whole header.
    void aBoardThatBeganInARequestIsUnderstood()
    {
        judge::McpBoard board;
        board.asks(header(9 | 6 << 4), true);
        board.reset();
        board.asks(Bytes(6, 0x11), true);
        board.asks(header(5), true);
        board.asks(header(6), true);
        asks(board);
        answers(board, 8);
        QCOMPARE(board.given().of(kSpeed).size(), std::size_t{1});
    }

private:
    static void asks(judge::McpBoard &board)
    {
        board.asks(header(9 | 4 << 4), true);
        board.asks(Bytes{2 << 3, 0, kSpeed & 0xFF, kSpeed >> 8}, true);
    }
    static void answers(judge::McpBoard &board, std::uint8_t value)
    {
        board.says(header(10 | 5 << 4), TimePoint{1s}, true);
        board.says(Bytes{value, 0, 0, 0, 0}, TimePoint{1s}, true);
    }
};

QTEST_GUILESS_MAIN(TestGivenValues)
#include "tst_given_values.moc"
