// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_DESCRIPTOR_HPP
#define ORO_OS_DESCRIPTOR_HPP

#include <cerrno>
#include <utility>

#include <unistd.h>

namespace RTT {
namespace os {
namespace detail {

/** Owns a file descriptor. Closing it leaves `errno` as it is. */
class Descriptor {
public:
    explicit Descriptor(int number = -1) noexcept : number_(number) {}
    ~Descriptor() { reset(); }
    Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        if (this != &other) reset(other.release());
        return *this;
    }

    int get() const noexcept { return number_; }
    explicit operator bool() const noexcept { return number_ >= 0; }
    /** The caller owns it from now on. */
    int release() noexcept { return std::exchange(number_, -1); }
    void reset(int number = -1) noexcept {
        const int error = errno;
        if (number_ >= 0) ::close(number_);
        number_ = number;
        errno = error;
    }

private:
    int number_;
};

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
