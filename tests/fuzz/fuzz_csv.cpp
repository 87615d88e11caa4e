// Any text as a CSV file into a capture: cut anywhere it reads the same, and what was read can be written and read
// again. The first byte says how it is cut.
#include "capture/csv_export.h"
#include "capture/csv_import.h"
#include "fuzz/script.h"

namespace {

struct Read {
    capture::Capture capture{{.maxBytes = 10'000'000}};
    std::uint64_t rows = 0;
    std::size_t channels = 0;
    std::optional<capture::CsvError> error;
};

void read(std::string_view text, std::size_t piece, Read &into)
{
    capture::CsvImport import(into.capture);
    bool whole = true;
    for (std::size_t at = 0; at < text.size() && whole; at += piece)
        whole = import.feed(text.substr(at, piece));
    if (whole)
        import.finish();
    into.rows = import.rows();
    into.channels = import.channels().size();
    into.error = import.error();
    fuzz::require(into.channels < capture::CsvImport::kMostColumns);
    fuzz::require(!into.error || into.error->field.size() <= capture::CsvImport::kLongestLine);
}

std::string written(const capture::Capture &capture)
{
    std::vector<capture::ChannelId> ids;
    for (const capture::ChannelInfo &info : capture.channels())
        ids.push_back(info.id);
    capture::CsvWriter writer(capture.snapshot(ids), {});
    std::string text;
    std::string_view piece;
    while (writer.next(piece))
        text += piece;
    return text;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size == 0)
        return 0;
    const std::string_view text(reinterpret_cast<const char *>(data + 1), size - 1);
    Read whole, cut;
    read(text, std::max<std::size_t>(text.size(), 1), whole);
    read(text, 1 + data[0] % 16, cut);
    fuzz::require(whole.rows == cut.rows && whole.channels == cut.channels);
    fuzz::require(whole.error.has_value() == cut.error.has_value());
    if (whole.error)
        fuzz::require(whole.error->what == cut.error->what && whole.error->line == cut.error->line);
    if (whole.error || !whole.capture.timeSpan()) // rows of empty fields alone are no file for us
        return 0;
    const std::string ours = written(whole.capture);
    fuzz::require(ours == written(cut.capture));
    Read again;
    read(ours, ours.size(), again);
    fuzz::require(!again.error && again.channels == whole.channels);
    return 0;
}
