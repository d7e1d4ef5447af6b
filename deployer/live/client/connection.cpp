// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "connection.hpp"

#include "failure.hpp"
#include "short_path.hpp"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>

#include <algorithm>
#include <optional>
#include <utility>

#include <unistd.h>

namespace oroforge::live_client {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;
using Error = boost::system::error_code;

constexpr const char* kProtocol = "oro.v1";
constexpr std::size_t kMostBytes = std::size_t(64) << 20;  // of a message; an image of a camera has room

/** A descriptor that ends receive(). It is a copy, so that the original stays as it was. */
class Watched {
public:
    Watched(asio::io_context& context, int descriptor, asio::posix::stream_descriptor::wait_type what)
        : descriptor_(context), what_(what) {
        Error error;
        const int copy = dup(descriptor);
        // A regular file cannot be watched and needs no watching.
        if (copy >= 0 && descriptor_.assign(copy, error)) close(copy);
    }
    void arm() {
        if (armed_ || !descriptor_.is_open()) return;
        armed_ = true;
        // The handler of a wait that is cancelled comes after this object.
        descriptor_.async_wait(what_, [this, alive = std::weak_ptr<bool>(alive_)](const Error& error) {
            if (alive.expired()) return;
            armed_ = false;
            if (error)
                descriptor_.close();
            else
                ready_ = true;
        });
    }
    bool take() { return std::exchange(ready_, false); }

private:
    asio::posix::stream_descriptor descriptor_;
    const asio::posix::stream_descriptor::wait_type what_;
    bool armed_ = false, ready_ = false;
    const std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

template <class Socket>
class Stream final : public Connection {
public:
    /** `where` is for messages. */
    explicit Stream(std::string where) : where_(std::move(where)), stream_(context_) {}

    asio::io_context& context() { return context_; }
    Socket& socket() { return stream_.next_layer(); }

    /** Runs an asynchronous step until it is done. */
    template <class Begin>
    void step(const char* what, Deadline deadline, const Begin& begin) {
        std::optional<Error> result;
        begin([&result](const Error& error, auto&&...) { result = error; });
        if (!runUntil(deadline, [&result] { return result.has_value(); })) {
            Error ignored;
            socket().close(ignored);  // the handler refers to this frame
            runUntil(kNever, [&result] { return result.has_value(); });
            throw Failure(Status::Refused, where_ + " does not answer in time, " + what);
        }
        if (*result) fail(what, *result);
    }

    void shakeHands(const std::string& host, const std::string& target, Deadline deadline) {
        stream_.read_message_max(kMostBytes);
        stream_.set_option(websocket::stream_base::decorator([](websocket::request_type& request) {
            request.set(beast::http::field::sec_websocket_protocol, kProtocol);
            request.set(beast::http::field::user_agent, "oro");
        }));
        websocket::response_type response;
        step("opening a WebSocket", deadline, [&](auto done) {
            stream_.async_handshake(response, host, target, [done, &response, this](const Error& error) {
                refused_ = error ? static_cast<int>(response.result_int()) : 0;
                done(error);
            });
        });
        if (response[beast::http::field::sec_websocket_protocol] != kProtocol)
            throw Failure(Status::Refused, where_ + " is no deployment: it does not speak '" + kProtocol + "'");
        stream_.text(true);
        context_.restart();
    }

    bool send(const std::string& text, Deadline deadline) override {
        if (closed_) return true;  // receive() reports it
        sending_ = text;
        sent_ = false;
        stream_.async_write(asio::buffer(sending_), [this](const Error& error, std::size_t) {
            sent_ = true;
            if (error) end(error);
        });
        return runUntil(deadline, [this] { return sent_; });
    }

    Event receive(std::string& text, Deadline deadline) override {
        for (const auto& each : wakes_) each->arm();
        if (end_) end_->arm();
        listen();
        Event event = Event::Time;
        const auto happened = [&] {
            if (arrived_)
                event = Event::Message;
            else if (std::any_of(wakes_.begin(), wakes_.end(), [](const auto& each) { return each->take(); }))
                event = Event::Woken;
            else if (end_ && end_->take())
                event = Event::Broken;
            else if (closed_)
                event = Event::Closed;
            else
                return false;
            return true;
        };
        runUntil(deadline, happened);
        if (event != Event::Message) return event;
        if (stream_.got_binary()) event = Event::Bytes;
        text = beast::buffers_to_string(buffer_.data());
        buffer_.consume(buffer_.size());
        arrived_ = false;
        return event;
    }

    void wakeOn(const std::vector<int>& descriptors) override {
        wakes_.clear();
        for (const int each : descriptors)
            wakes_.push_back(std::make_unique<Watched>(context_, each, asio::posix::stream_descriptor::wait_read));
    }
    void endOn(int descriptor) override {
        end_.reset(new Watched(context_, descriptor, asio::posix::stream_descriptor::wait_error));
    }
    std::string reason() const override { return reason_; }

private:
    template <class Condition>
    bool runUntil(Deadline deadline, const Condition& condition) {
        while (!condition()) {
            context_.restart();
            const bool timed = deadline != kNever;
            if ((timed ? context_.run_one_until(deadline) : context_.run_one()) == 0 && !condition()) return false;
        }
        return true;
    }

    void listen() {
        if (listening_ || arrived_ || closed_) return;
        listening_ = true;
        stream_.async_read(buffer_, [this](const Error& error, std::size_t) {
            listening_ = false;
            if (error)
                end(error);
            else
                arrived_ = true;
        });
    }

    void end(const Error& error) {
        if (closed_) return;
        closed_ = true;
        const bool ordinary = error == websocket::error::closed || error == asio::error::eof ||
                              error == asio::error::connection_reset || error == asio::error::broken_pipe ||
                              error == boost::beast::error::timeout;
        const std::string said(stream_.reason().reason.c_str());
        if (error == websocket::error::message_too_big || error == websocket::error::buffer_overflow)
            reason_ = "a message of more than " + std::to_string(kMostBytes >> 20) + " MiB";
        else if (!ordinary)
            reason_ = error.message();
        else
            reason_ = said;
    }

    [[noreturn]] void fail(const char* what, const Error& error) const {
        if (refused_ == 401 || refused_ == 403)
            throw Failure(Status::Refused, where_ + " refuses the connection (HTTP " + std::to_string(refused_) +
                                               "); give the token that 'deployer --web' printed: ws://…/?token=…");
        if (refused_ >= 400)
            throw Failure(Status::Refused, where_ + " refuses the connection (HTTP " + std::to_string(refused_) + ")");
        const bool gone = error == asio::error::connection_refused || error == asio::error::not_found ||
                          error == Error(ENOENT, boost::system::system_category());
        if (gone)
            throw Failure(Status::NoDeployment,
                          where_ + " has ended, or does not listen; 'oro list' shows the deployments");
        if (error == asio::error::access_denied)
            throw Failure(Status::NoDeployment, where_ + " belongs to another user");
        throw Failure(Status::Refused, where_ + " cannot be reached, " + what + ": " + error.message());
    }

    const std::string where_;
    asio::io_context context_{1};
    websocket::stream<Socket> stream_;
    beast::flat_buffer buffer_{kMostBytes};
    std::string sending_, reason_;
    bool sent_ = true, listening_ = false, arrived_ = false, closed_ = false;
    int refused_ = 0;
    std::vector<std::unique_ptr<Watched>> wakes_;
    std::unique_ptr<Watched> end_;
};

}  // namespace

std::unique_ptr<Connection> Connection::toSocket(const std::string& path, Deadline deadline) {
    auto stream = std::make_unique<Stream<asio::local::stream_protocol::socket>>("'" + path + "'");
    const ShortPath fits(path);
    std::optional<asio::local::stream_protocol::endpoint> end;
    try {
        end.emplace(fits.text());
    } catch (const boost::system::system_error&) {
        throw Failure(Status::Usage, "the path '" + path + "' is too long for a socket");
    }
    stream->step("connecting", deadline, [&](auto done) { stream->socket().async_connect(*end, done); });
    stream->shakeHands("localhost", "/", deadline);
    return stream;
}

std::unique_ptr<Connection> Connection::toAddress(const Address& address, Deadline deadline) {
    auto stream = std::make_unique<Stream<asio::ip::tcp::socket>>(address.host + ":" + address.port);
    asio::ip::tcp::resolver resolver(stream->context());
    Error error;
    const auto ends = resolver.resolve(address.host, address.port, error);
    if (error) throw Failure(Status::NoDeployment, "there is no computer '" + address.host + "': " + error.message());
    stream->step("connecting", deadline,
                 [&](auto done) { asio::async_connect(stream->socket(), ends.begin(), ends.end(), done); });
    stream->socket().set_option(asio::ip::tcp::no_delay(true), error);
    const bool numeric = address.host.find(':') != std::string::npos;
    stream->shakeHands((numeric ? "[" + address.host + "]" : address.host) + ":" + address.port, address.target,
                       deadline);
    return stream;
}

}  // namespace oroforge::live_client
