// Reading and writing little-endian numbers in byte buffers. Every read is bounds-checked: a reader that has run
// off its end stays failed and yields zeros, so a decoder checks once, at its end.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

class ByteReader {
public:
    explicit ByteReader(ByteView bytes)
        : m_bytes(bytes)
    {
    }

    bool ok() const { return m_ok; }
    std::size_t left() const { return m_bytes.size() - m_at; }
    std::size_t position() const { return m_at; }

    std::uint8_t u8() { return static_cast<std::uint8_t>(number(1)); }
    std::uint16_t u16() { return static_cast<std::uint16_t>(number(2)); }
    std::uint32_t u32() { return static_cast<std::uint32_t>(number(4)); }
    std::int8_t s8() { return static_cast<std::int8_t>(u8()); }
    std::int16_t s16() { return static_cast<std::int16_t>(u16()); }
    std::int32_t s32() { return static_cast<std::int32_t>(u32()); }
    std::uint64_t u64() { return number(8); }
    std::int64_t s64() { return static_cast<std::int64_t>(u64()); }
    float f32() { return std::bit_cast<float>(u32()); }
    double f64() { return std::bit_cast<double>(u64()); }

    /// The next `count` bytes, empty (and failed) if there are fewer.
    ByteView take(std::size_t count)
    {
        if (count > left()) {
            m_ok = false;
            m_at = m_bytes.size();
            return {};
        }
        const ByteView part = m_bytes.subspan(m_at, count);
        m_at += count;
        return part;
    }

    /// Text up to and without its terminating zero; fails if there is none.
    std::string zeroTerminated()
    {
        std::string text;
        while (left() > 0) {
            const auto c = static_cast<char>(u8());
            if (c == '\0')
                return text;
            text.push_back(c);
        }
        m_ok = false;
        return text;
    }

private:
    std::uint64_t number(std::size_t width)
    {
        const ByteView part = take(width);
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < part.size(); ++i)
            value |= std::uint64_t{part[i]} << (8 * i);
        return value;
    }

    ByteView m_bytes;
    std::size_t m_at = 0;
    bool m_ok = true;
};

class ByteWriter {
public:
    /// Room for most messages from the start: one allocation instead of several.
    ByteWriter() { m_bytes.reserve(64); }

    ByteWriter &u8(std::uint32_t value) { return number(value, 1); }
    ByteWriter &u16(std::uint32_t value) { return number(value, 2); }
    ByteWriter &u32(std::uint32_t value) { return number(value, 4); }
    ByteWriter &u64(std::uint64_t value) { return number(value, 8); }
    ByteWriter &s16(std::int32_t value) { return number(static_cast<std::uint32_t>(value), 2); }
    ByteWriter &s32(std::int32_t value) { return number(static_cast<std::uint32_t>(value), 4); }
    ByteWriter &s64(std::int64_t value) { return u64(static_cast<std::uint64_t>(value)); }
    ByteWriter &f32(float value) { return u32(std::bit_cast<std::uint32_t>(value)); }
    ByteWriter &f64(double value) { return u64(std::bit_cast<std::uint64_t>(value)); }
    ByteWriter &bytes(ByteView part)
    {
        m_bytes.insert(m_bytes.end(), part.begin(), part.end());
        return *this;
    }
    ByteWriter &text(std::string_view part)
    {
        m_bytes.insert(m_bytes.end(), part.begin(), part.end());
        return *this;
    }

    void reserve(std::size_t more) { m_bytes.reserve(m_bytes.size() + more); }
    std::size_t size() const { return m_bytes.size(); }
    Bytes take() { return std::move(m_bytes); }

private:
    ByteWriter &number(std::uint64_t value, int width)
    {
        for (int i = 0; i < width; ++i)
            m_bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
        return *this;
    }

    Bytes m_bytes;
};
