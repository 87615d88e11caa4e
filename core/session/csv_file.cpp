#include "session/csv_file.h"

namespace session {

CsvResult writeCsvFile(
    const QString &path, capture::CsvWriter &writer, const std::function<bool(double)> &proceed)
{
    const FileResult file = writePieces(
        path, [&writer](std::string_view &text) { return writer.next(text); },
        [&] { return !proceed || proceed(writer.progress()); });
    CsvResult result;
    result.error = file.error;
    result.path = path;
    result.systemText = file.systemText;
    result.bytes = file.bytes;
    if (file.error == CsvError::None)
        result.rows = writer.rows();
    return result;
}

} // namespace session
