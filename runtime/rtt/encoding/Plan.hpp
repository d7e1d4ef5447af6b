// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ENCODING_PLAN_HPP
#define ORO_ENCODING_PLAN_HPP

#include <rtt/encoding/Rules.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace RTT {
namespace types {
class TypeInfo;
}

namespace encoding {

namespace detail {
struct Form;
}

/** Why bytes could not be decoded. */
struct RTT_API DecodeError {
    const char* problem = nullptr;  ///< what is wrong, without a capital; null if nothing is
    std::size_t offset = 0;         ///< of the byte at which that was found

    explicit operator bool() const { return problem != nullptr; }
    /** "byte 12: a bool is neither 0 nor 1". Allocates. */
    std::string text() const;
};

/**
 * How the values of a type are written as bytes and read from them, compiled once from its shape. A constant that any
 * number of threads may use.
 *
 * encode() never allocates, and decode() not once the containers of the value are large enough, except for what is
 * copied out of its place: elements of maps and of matrices, containers that functions return, long double and
 * std::bitset, which travel as texts; and encode() sorts unordered containers. Neither blocks.
 */
class RTT_API Plan {
public:
    /** Containers, optional values and variants nest at most this deep. */
    static constexpr unsigned kDeepest = 64;

    /** Null, with the reason in `why`, if the type, or a part of it, has no shape. Allocates. */
    static std::shared_ptr<const Plan> make(const types::TypeInfo& type, const Rules& rules, std::string& why);
    ~Plan();
    Plan(const Plan&) = delete;
    Plan& operator=(const Plan&) = delete;

    /** The number of bytes that encode() writes for this value; 0 if it cannot be encoded: it nests too deeply, has a
        container of more than 2^32-1 elements, a variant without a value or a value of an enumeration that has no name
        where names are needed, or a function of the type throws. As fast as encode(). */
    std::size_t sizeOf(const void* value) const;
    /** Writes the value in this machine's byte order and returns the number of bytes; 0, with an undefined content of
        the buffer, if it has no room for them or the value cannot be encoded. */
    std::size_t encode(const void* value, void* to, std::size_t room) const;
    /** Sets the value from all of these bytes. If they are wrong, the value is some valid value afterwards. Memory is
        only taken for elements whose bytes are there. */
    DecodeError decode(const void* from, std::size_t size, ByteOrder order, void* value) const;

    /** The number of bytes of all values if it is the same for all; otherwise 0. */
    std::size_t fixedSize() const;
    /** Equal for types of equal parts, by name, kind and order, so that both ends of a transport can compare what they
        know of a type. Computed once, by make(). */
    std::uint64_t fingerprint() const { return fingerprint_; }

private:
    template <class Out>
    bool isPut(Out& out, const void* value) const;
    explicit Plan(std::shared_ptr<const detail::Form> form, const Rules& rules);

    const std::shared_ptr<const detail::Form> form_;
    const Rules rules_;
    const std::uint64_t fingerprint_;
};

}  // namespace encoding
}  // namespace RTT

#endif
