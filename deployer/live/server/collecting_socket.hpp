// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Included by transport.cpp only: Boost.Beast takes ten seconds to compile.
#ifndef OROFORGE_LIVE_COLLECTING_SOCKET_HPP
#define OROFORGE_LIVE_COLLECTING_SOCKET_HPP

#include <boost/asio/async_result.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/bind_handler.hpp>
#include <boost/beast/core/role.hpp>
#include <boost/beast/websocket/teardown.hpp>

#include <cstddef>
#include <string>
#include <utility>

namespace OCL::live {

/**
 * The socket below a WebSocket. It collects what is written, so that many small messages take one system call. The
 * owner calls send() at onWritten(), and when it has written the last one of several messages.
 */
class CollectingSocket {
public:
    typedef boost::asio::generic::stream_protocol::socket next_layer_type;
    typedef next_layer_type::executor_type executor_type;
    typedef boost::system::error_code Error;

    class Owner {
    public:
        virtual void onWritten() = 0;

    protected:
        ~Owner() = default;
    };

    CollectingSocket(Owner& owner, next_layer_type socket) : owner_(owner), socket_(std::move(socket)) {}

    executor_type get_executor() noexcept { return socket_.get_executor(); }
    next_layer_type& next_layer() noexcept { return socket_; }
    const next_layer_type& next_layer() const noexcept { return socket_; }

    /** What is written now waits here; in the queue of the client old samples could be dropped. */
    bool isFull() const { return collected_.size() >= kMost; }
    /** Sends what was collected, unless more is about to be written. `then(error)` is called when it is sent. */
    template <class Then>
    void send(bool moreFollows, Then then) {
        if (isSending_ || collected_.empty() || (moreFollows && !isFull())) return;
        isSending_ = true;
        std::swap(sent_, collected_);
        boost::asio::async_write(socket_, boost::asio::buffer(sent_),
                                 [this, then = std::move(then)](Error error, std::size_t) {
                                     isSending_ = false;
                                     sent_.clear();
                                     error_ = error;
                                     then(error);
                                 });
    }

    template <class Buffers, class Handler>
    BOOST_ASIO_INITFN_RESULT_TYPE(Handler, void(Error, std::size_t))
    async_read_some(const Buffers& buffers, Handler&& handler) {
        return socket_.async_read_some(buffers, std::forward<Handler>(handler));
    }

    template <class Buffers, class Handler>
    BOOST_ASIO_INITFN_RESULT_TYPE(Handler, void(Error, std::size_t))
    async_write_some(const Buffers& buffers, Handler&& handler) {
        return boost::asio::async_initiate<Handler, void(Error, std::size_t)>(
            [this](auto&& then, const auto& from) {
                const std::size_t size = error_ ? 0 : collect(from);
                boost::asio::post(get_executor(),
                                  boost::beast::bind_front_handler(std::forward<decltype(then)>(then), error_, size));
            },
            handler, buffers);
    }

private:
    static constexpr std::size_t kMost = 64 * 1024;

    template <class Buffers>
    std::size_t collect(const Buffers& buffers) {
        const std::size_t before = collected_.size(), size = boost::asio::buffer_size(buffers);
        collected_.resize(before + size);
        boost::asio::buffer_copy(boost::asio::buffer(&collected_[before], size), buffers);
        owner_.onWritten();
        return size;
    }

    Owner& owner_;
    next_layer_type socket_;
    std::string collected_, sent_;
    bool isSending_ = false;
    Error error_;  // nothing can be sent any more
};

// Found by Boost.Beast.
inline void teardown(boost::beast::role_type role, CollectingSocket& socket, CollectingSocket::Error& error) {
    using boost::beast::websocket::teardown;
    teardown(role, socket.next_layer(), error);
}
template <class Handler>
void async_teardown(boost::beast::role_type role, CollectingSocket& socket, Handler&& handler) {
    using boost::beast::websocket::async_teardown;
    async_teardown(role, socket.next_layer(), std::forward<Handler>(handler));
}

}  // namespace OCL::live

#endif
