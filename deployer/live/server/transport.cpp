// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The only file that includes Boost.Beast: it takes ten seconds to compile.
#include "transport.hpp"

#include "../door/peer.hpp"
#include "collecting_socket.hpp"
#include "sockets.hpp"

#include <rtt/Logger.hpp>

#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <algorithm>
#include <cerrno>
#include <list>
#include <optional>
#include <sys/socket.h>
#include <vector>

namespace OCL::live {
namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
typedef CollectingSocket::next_layer_type Socket;
typedef boost::system::error_code Error;

constexpr std::size_t kMostClients = 16, kMostHandshakes = 32, kLongestMessage = 64 * 1024, kLongestHead = 8 * 1024;
constexpr std::chrono::seconds kHandshake(10);
constexpr std::chrono::milliseconds kFarewell(200), kAcceptPause(100);
/** Fewer than handshakes, so that those of others go on in between. */
constexpr int kAcceptedAtOnce = 8;

}  // namespace

class Transport::Impl {
public:
    class Connection;
    explicit Impl(Reception& reception) : reception(reception), work_(context.get_executor()), ticks_(context) {}

    void listen(int socket, bool isLocal) {
        listeners_.push_back(std::make_unique<Listener>(*this, socket, isLocal));
        accept(*listeners_.back());
    }
    void begin(int socket, bool isLocal);
    void stop();
    void tick(std::chrono::milliseconds period) {
        const bool starts = period_.count() == 0 && period.count() != 0;
        period_ = period;
        if (starts) {
            ticks_.expires_after(period);
            awaitTick();
        } else if (period.count() == 0) {
            ticks_.cancel();
        }
    }
    std::size_t clients(bool isLocal) const;
    void forget(const Connection* connection);
    void dropOldestHandshake(bool isLocal);

    net::io_context context{1};
    Reception& reception;

private:
    struct Listener {
        Listener(Impl& impl, int number, bool isLocal)
            : socket(impl.context, number), pause(impl.context), isLocal(isLocal) {}
        net::posix::stream_descriptor socket;
        net::steady_timer pause;
        bool isLocal;
    };
    void accept(Listener& listener);
    void acceptAll(Listener& listener);
    void awaitTick();

    net::executor_work_guard<net::io_context::executor_type> work_;
    net::steady_timer ticks_;
    std::chrono::milliseconds period_{0};
    std::vector<std::unique_ptr<Listener>> listeners_;
    std::list<std::shared_ptr<Connection>> connections_;  // the oldest first
    bool ending_ = false;
};

class Transport::Impl::Connection final : public Link,
                                          public CollectingSocket::Owner,
                                          public std::enable_shared_from_this<Connection> {
public:
    Connection(Impl& owner, int socket, bool isLocal)
        : isLocal(isLocal),
          owner_(owner),
          name_(isLocal ? peerOf(socket).text() : addressOf(socket)),
          stream_(*this, Socket(owner.context, net::generic::stream_protocol(familyOf(socket), 0), socket)),
          deadline_(owner.context) {
        if (!isLocal) keepAlive(socket);
    }

    const bool isLocal;
    bool isOpen() const { return client_ != nullptr; }

    void start() {
        endAfter(kHandshake);
        parser_.emplace();
        parser_->header_limit(kLongestHead);
        parser_->body_limit(0);
        http::async_read_header(stream_.next_layer(), buffer_, *parser_,
                                [self = shared_from_this()](Error error, std::size_t) { self->onHead(error); });
    }

    void wake() override {
        if (!client_ || isWriting_ || isClosing_ || stream_.next_layer().isFull()) return;
        guarded([this] { isWriting_ = client_->next(frame_); });
        if (!isWriting_) return;
        stream_.binary(frame_.isBinary);
        stream_.async_write(net::buffer(frame_.bytes), [self = shared_from_this()](Error error, std::size_t) {
            self->isWriting_ = false;
            if (error) return self->cut();
            if (!self->isReading_) self->read();
            self->wake();
            self->onWritten();
        });
    }

    /** Says that nothing more comes, and closes in any case after 0.2 s. */
    void close(websocket::close_code code) {
        if (!client_) return cut();
        if (std::exchange(isClosing_, true)) return;
        endAfter(kFarewell);
        stream_.async_close(code, [self = shared_from_this()](Error) { self->cut(); });
    }

    void cut() {
        Error ignored;
        deadline_.cancel();
        client_.reset();
        stream_.next_layer().next_layer().close(ignored);
        owner_.forget(this);
    }

private:
    void onWritten() override {
        stream_.next_layer().send(isWriting_, [self = shared_from_this()](Error error) {
            if (error) return self->cut();
            self->wake();
            self->onWritten();
        });
    }

    void endAfter(std::chrono::milliseconds time) {
        deadline_.expires_after(time);
        deadline_.async_wait([self = shared_from_this()](Error error) {
            if (!error) self->cut();
        });
    }

    std::string field(http::field name) const {
        const beast::string_view text = parser_->get()[name];
        return std::string(text.data(), text.size());
    }

    void onHead(Error error) {
        if (error == http::error::header_limit) return refuse(431, "the header is too long");
        if (error && error.category() == make_error_code(http::error::bad_method).category() &&
            error != http::error::end_of_stream && error != http::error::partial_message)
            return refuse(400, "this is not HTTP");
        if (error) return cut();
        const auto& request = parser_->get();
        head_.isLocal = isLocal;
        head_.isUpgrade = websocket::is_upgrade(request);
        head_.method.assign(request.method_string().data(), request.method_string().size());
        head_.target.assign(request.target().data(), request.target().size());
        head_.host = field(http::field::host);
        head_.origin = field(http::field::origin);
        head_.authorization = field(http::field::authorization);
        head_.protocols = field(http::field::sec_websocket_protocol);
        for (const auto once : {http::field::host, http::field::origin, http::field::authorization})
            if (request.count(once) > 1)
                return refuse(400, "the header " + std::string(http::to_string(once)) + " came twice");
        if (buffer_.size() != 0) return refuse(400, "a message came before the WebSocket was open");
        Verdict verdict{500, "it is not decided", ""};
        guarded([&] { verdict = owner_.reception.judge(head_); });
        if (verdict.status == 101 && owner_.clients(isLocal) >= kMostClients)
            return refuse(503, "there are 16 clients already");
        if (verdict.status != 101) return refuse(verdict.status, verdict.text);
        accept(verdict.protocol);
    }

    void accept(const std::string& protocol) {
        stream_.set_option(websocket::stream_base::decorator([protocol](websocket::response_type& response) {
            response.set(http::field::server, "oroforge");
            if (!protocol.empty()) response.set(http::field::sec_websocket_protocol, protocol);
        }));
        stream_.read_message_max(kLongestMessage);
        stream_.auto_fragment(false);
        stream_.async_accept(parser_->get(), [self = shared_from_this(), protocol](Error error) {
            if (error) return self->cut();
            self->opened(protocol);
        });
    }

    void opened(const std::string& protocol) {
        deadline_.cancel();
        parser_.reset();
        guarded([&] { client_ = owner_.reception.welcome(head_, protocol, name_, *this); });
        if (!client_) return cut();
        read();
        wake();
    }

    void refuse(unsigned status, const std::string& text) {
        response_.result(status);
        response_.set(http::field::server, "oroforge");
        response_.set(http::field::content_type, "text/plain; charset=utf-8");
        response_.set(http::field::cache_control, "no-store");
        response_.set("X-Content-Type-Options", "nosniff");
        response_.set("Content-Security-Policy", "default-src 'none'");
        if (status == 401) response_.set(http::field::www_authenticate, "Bearer");
        if (status == 405) response_.set(http::field::allow, "GET");
        if (status == 426) response_.set(http::field::upgrade, "websocket");
        response_.keep_alive(false);
        response_.body() = text + "\n";
        response_.prepare_payload();
        http::async_write(stream_.next_layer(), response_, [self = shared_from_this()](Error error, std::size_t) {
            if (error) return self->cut();
            self->drain();
        });
    }

    /** Takes what still comes, so that the answer is not destroyed by a reset. */
    void drain() {
        Error ignored;
        stream_.next_layer().next_layer().shutdown(Socket::shutdown_send, ignored);
        endAfter(kFarewell);
        takeRest();
    }
    void takeRest() {
        buffer_.clear();
        stream_.next_layer().async_read_some(buffer_.prepare(4096),
                                             [self = shared_from_this()](Error error, std::size_t) {
                                                 if (error) return self->cut();
                                                 self->takeRest();
                                             });
    }

    void read() {
        if (isReading_ || isClosing_ || !client_ || client_->isFull()) return;
        isReading_ = true;
        stream_.async_read(buffer_, [self = shared_from_this()](Error error, std::size_t) {
            self->isReading_ = false;
            if (error || !self->client_) return self->cut();
            const auto data = self->buffer_.cdata();
            self->guarded([&] {
                self->client_->receive({static_cast<const char*>(data.data()), data.size()},
                                       self->stream_.got_binary());
            });
            self->buffer_.clear();
            self->wake();
            self->read();
        });
    }

    /** An exception, such as a lack of memory, ends this client only. */
    template <class Function>
    void guarded(Function function) {
        try {
            function();
        } catch (const std::exception& thrown) {
            RTT::log(RTT::Warning) << "client " << name_ << " of the live window is dropped: " << thrown.what()
                                   << RTT::endlog();
            // Not at once: the caller uses the client.
            net::post(owner_.context,
                      [self = shared_from_this()] { self->close(websocket::close_code::internal_error); });
        }
    }

    Impl& owner_;
    const std::string name_;
    websocket::stream<CollectingSocket> stream_;
    net::steady_timer deadline_;
    beast::flat_buffer buffer_;
    std::optional<http::request_parser<http::empty_body>> parser_;
    http::response<http::string_body> response_;
    RequestHead head_;
    Frame frame_;
    std::unique_ptr<Client> client_;
    bool isReading_ = false, isWriting_ = false, isClosing_ = false;
};

void Transport::Impl::begin(int socket, bool isLocal) {
    // A socket that has gone already is no reason to end the others.
    try {
        connections_.push_back(std::make_shared<Connection>(*this, socket, isLocal));
    } catch (const std::exception&) {
        (void)::close(socket);
        return;
    }
    connections_.back()->start();
    dropOldestHandshake(isLocal);
}

void Transport::Impl::dropOldestHandshake(bool isLocal) {
    const auto isOne = [&](const auto& one) { return one->isLocal == isLocal && !one->isOpen(); };
    const auto count = std::count_if(connections_.begin(), connections_.end(), isOne);
    if (static_cast<std::size_t>(count) <= kMostHandshakes) return;
    const std::shared_ptr<Connection> dropped = *std::find_if(connections_.begin(), connections_.end(), isOne);
    dropped->cut();
}

std::size_t Transport::Impl::clients(bool isLocal) const {
    return static_cast<std::size_t>(std::count_if(connections_.begin(), connections_.end(), [&](const auto& one) {
        return one->isOpen() && one->isLocal == isLocal;
    }));
}

void Transport::Impl::forget(const Connection* connection) {
    connections_.remove_if([&](const std::shared_ptr<Connection>& one) { return one.get() == connection; });
}

void Transport::Impl::accept(Listener& listener) {
    listener.socket.async_wait(net::posix::stream_descriptor::wait_read, [this, &listener](Error error) {
        if (!error && !ending_) acceptAll(listener);
    });
}

void Transport::Impl::acceptAll(Listener& listener) {
    for (int i = 0; i != kAcceptedAtOnce; ++i) {
        const int socket = ::accept4(listener.socket.native_handle(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
        if (socket >= 0 && listener.isLocal && !peerOf(socket).mayEnter()) {
            (void)::close(socket);
        } else if (socket >= 0) {
            begin(socket, listener.isLocal);
        } else if (isExhaustion(errno)) {
            // The client stays in the queue of the socket, which is ready all the time.
            listener.pause.expires_after(kAcceptPause);
            listener.pause.async_wait([this, &listener](Error error) {
                if (!error && !ending_) accept(listener);
            });
            return;
        } else if (errno != EINTR && errno != ECONNABORTED) {
            break;
        }
    }
    accept(listener);
}

void Transport::Impl::awaitTick() {
    ticks_.async_wait([this](Error error) {
        if (error || period_.count() == 0 || ending_) return;
        // Before onTick(): an exception of it must not be the end of all ticks. After a pause of the process, missed
        // ticks are not made up for.
        ticks_.expires_at(std::max(ticks_.expiry() + period_, std::chrono::steady_clock::now()));
        awaitTick();
        reception.onTick();
    });
}

void Transport::Impl::stop() {
    ending_ = true;
    Error ignored;
    ticks_.cancel();
    for (const auto& listener : listeners_) {
        listener->socket.close(ignored);
        listener->pause.cancel();
    }
    const std::vector<std::shared_ptr<Connection>> all(connections_.begin(), connections_.end());
    for (const auto& connection : all) connection->close(websocket::close_code::going_away);
    work_.reset();
}

Transport::Transport(Reception& reception) : impl_(new Impl(reception)) {}
Transport::~Transport() = default;
void Transport::listen(int socket, bool isLocal) { impl_->listen(socket, isLocal); }
void Transport::add(int socket, bool isLocal) { impl_->begin(socket, isLocal); }
void Transport::stop() {
    net::post(impl_->context, [this] { impl_->stop(); });
}
void Transport::post(std::function<void()> function) { net::post(impl_->context, std::move(function)); }
void Transport::tick(std::chrono::milliseconds period) { impl_->tick(period); }

void Transport::run() {
    for (bool again = true; again;) {
        again = false;
        try {
            impl_->context.run();
        } catch (const std::exception& thrown) {
            RTT::log(RTT::Error) << "the live window goes on after an error: " << thrown.what() << RTT::endlog();
            again = true;
        }
    }
}

}  // namespace OCL::live
