// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_SOURCE_HPP
#define OROFORGE_MCAP_SOURCE_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace oroforge::mcap {

/** The bytes of a file. Used by one thread at a time. */
class Source {
public:
    virtual ~Source() = default;
    virtual std::uint64_t size() const = 0;
    /** Copies bytes that lie within size(); false if they cannot be read. */
    virtual bool read(std::uint64_t offset, void* to, std::size_t size) = 0;
};

/** Bytes in memory, which must outlive this. */
class MemorySource : public Source {
public:
    MemorySource(const unsigned char* data, std::size_t size) : data_(data), size_(size) {}
    std::uint64_t size() const override { return size_; }
    bool read(std::uint64_t offset, void* to, std::size_t size) override;

private:
    const unsigned char* const data_;
    const std::size_t size_;
};

/** A file, with the size that it has now. Null, with the reason, if it cannot be opened or has no size, as a pipe. */
std::unique_ptr<Source> openSource(const std::string& file, std::string& why);

}  // namespace oroforge::mcap

#endif
