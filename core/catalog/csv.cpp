#include "catalog/csv.h"

namespace catalog {

namespace {

class CsvReader {
public:
    explicit CsvReader(std::string_view text)
        : m_text(text)
    {
    }

    Result<std::vector<CsvRow>, TableError> rows()
    {
        std::vector<CsvRow> all;
        while (m_at < m_text.size()) {
            auto row = nextRow();
            if (!row)
                return fail(row.error());
            if (row->fields.size() > 1 || !row->fields.front().empty())
                all.push_back(std::move(*row));
        }
        return all;
    }

private:
    Result<CsvRow, TableError> nextRow()
    {
        CsvRow row{m_line, {}};
        for (;;) {
            auto field = nextField();
            if (!field)
                return fail(field.error());
            row.fields.push_back(std::move(*field));
            if (m_at >= m_text.size())
                return row;
            const char separator = take();
            if (separator == '\n')
                return row;
            if (separator == '\r') {
                if (m_at < m_text.size() && m_text[m_at] == '\n')
                    take();
                return row;
            }
        }
    }

    Result<std::string, TableError> nextField()
    {
        if (m_at < m_text.size() && m_text[m_at] == '"')
            return quotedField();
        std::string field;
        while (m_at < m_text.size() && !endsField(m_text[m_at]))
            field.push_back(take());
        return field;
    }

    Result<std::string, TableError> quotedField()
    {
        const std::size_t opened = m_line;
        std::string field;
        take();
        while (m_at < m_text.size()) {
            const char c = take();
            if (c != '"') {
                field.push_back(c);
            } else if (m_at < m_text.size() && m_text[m_at] == '"') {
                field.push_back(take());
            } else if (m_at >= m_text.size() || endsField(m_text[m_at])) {
                return field;
            } else {
                return fail(TableError{m_line, "A closing quote is followed by text."});
            }
        }
        return fail(TableError{opened, "A quote is never closed."});
    }

    static bool endsField(char c) { return c == ',' || c == '\n' || c == '\r'; }

    char take()
    {
        const char c = m_text[m_at++];
        if (c == '\n')
            ++m_line;
        return c;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    std::size_t m_line = 1;
};

} // namespace

Result<std::vector<CsvRow>, TableError> readCsv(std::string_view text)
{
    return CsvReader(text).rows();
}

} // namespace catalog
