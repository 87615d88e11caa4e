// Plain sockets: no library for three calls.
#include "tcp_port.h"

#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <string_view>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

namespace sim {

namespace {

void makeQuiet(int descriptor)
{
    fcntl(descriptor, F_SETFD, FD_CLOEXEC);
    fcntl(descriptor, F_SETFL, O_NONBLOCK);
}

enum class Guess : std::uint8_t { Client, Browser, NotYet };

/// What the first bytes of a connection come from. Of the words of HTTP none is the beginning of a packet of ours that
/// is worth waiting for; the last is how TLS begins.
Guess guess(const Bytes &first)
{
    static constexpr std::array<std::string_view, 11> kBeginnings{"GET ", "POST ", "PUT ", "HEAD ",
        "OPTIONS ", "CONNECT ", "TRACE ", "DELETE ", "PATCH ", "PRI * HTTP", "\x16\x03\x01"};
    const std::string_view text(reinterpret_cast<const char *>(first.data()), first.size());
    Guess best = Guess::Client;
    for (const std::string_view beginning : kBeginnings) {
        if (text.substr(0, beginning.size()) == beginning)
            return Guess::Browser;
        if (beginning.substr(0, text.size()) == text)
            best = Guess::NotYet;
    }
    return best;
}

} // namespace

Result<std::unique_ptr<Port>, std::string> TcpPort::open(std::uint16_t number)
{
    const auto refused = [number](const char *what) {
        return fail("cannot " + std::string(what) + " 127.0.0.1:" + std::to_string(number) + ": "
            + std::strerror(errno));
    };
    const int listener = socket(AF_INET, SOCK_STREAM, 0);
    if (listener < 0)
        return refused("open");
    std::unique_ptr<TcpPort> port(new TcpPort(listener, number));
    makeQuiet(listener);
    const int yes = 1;
    setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(number);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    auto *general = reinterpret_cast<sockaddr *>(&address); // as bind() wants it
    socklen_t size = sizeof address;
    if (bind(listener, general, size) != 0 || ::listen(listener, 1) != 0)
        return refused("listen at");
    if (getsockname(listener, general, &size) == 0)
        port->m_number = ntohs(address.sin_port);
    return port;
}

TcpPort::~TcpPort()
{
    leave();
    ::close(m_listener);
}

void TcpPort::leave()
{
    if (m_client >= 0)
        ::close(m_client);
    m_client = -1;
}

bool TcpPort::clientPresent()
{
    const int next = accept(m_listener, nullptr, nullptr);
    if (next >= 0 && m_client >= 0) {
        ::close(next); // a serial line has two ends
    } else if (next >= 0) {
        makeQuiet(next);
        const int yes = 1;
        setsockopt(next, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
        m_client = next;
        m_trusted = false;
        m_first.clear();
    }
    return m_client >= 0;
}

Bytes TcpPort::read()
{
    std::array<std::uint8_t, 4096> piece{};
    const ssize_t count = recv(m_client, piece.data(), piece.size(), 0);
    if (count > 0)
        return judged({piece.begin(), piece.begin() + count});
    if (count == 0 || (errno != EAGAIN && errno != EINTR))
        leave();
    return {};
}

Bytes TcpPort::judged(Bytes bytes)
{
    if (m_trusted)
        return bytes;
    m_first.insert(m_first.end(), bytes.begin(), bytes.end());
    switch (guess(m_first)) {
    case Guess::Browser:
        leave();
        return {};
    case Guess::NotYet:
        return {};
    case Guess::Client:
        break;
    }
    m_trusted = true;
    return std::exchange(m_first, {});
}

void TcpPort::write(ByteView bytes)
{
    while (m_client >= 0 && !bytes.empty()) {
        const ssize_t count = send(m_client, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (count <= 0)
            return;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
}

} // namespace sim
