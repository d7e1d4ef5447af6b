// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_WATCH_HPP
#define ORO_CORBA_DETAIL_WATCH_HPP

#include <functional>
#include <memory>

namespace RTT {
namespace corba {
namespace detail {

/** Calls a function about once a second, in a thread that all watches share, as long as this object exists. */
class Watch {
public:
    explicit Watch(std::function<void()> check);
    /** Blocks while the function is executing, except in the function itself. */
    ~Watch();
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    struct Entry;

private:
    const std::shared_ptr<Entry> entry_;
};

/** Ends the thread until the next watch begins. Blocks while a function is executing. */
void endWatches();

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
