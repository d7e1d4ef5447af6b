// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_COMPRESSION_HPP
#define OROFORGE_MCAP_COMPRESSION_HPP

#include "format.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace oroforge::mcap {

enum class Compression { None, Lz4, Zstd };

/** As in files: "", "lz4", "zstd". */
const char* nameOf(Compression compression);
/** False if this library was built without it. */
bool hasCompression(Compression compression);

/** Compresses one block after another. Used by one thread at a time. */
class Compressor {
public:
    /** Not None, and hasCompression() must be true. Allocates. */
    explicit Compressor(Compression compression);
    ~Compressor();
    Compressor(const Compressor&) = delete;
    Compressor& operator=(const Compressor&) = delete;

    Compression compression() const { return compression_; }
    /** Writes to the first bytes of `out`, which grows if it must, and returns their number; 0, with a reason, if the
        compressor fails. */
    std::size_t compress(const unsigned char* data, std::size_t size, Bytes& out, std::string& why);

private:
    struct State;
    const Compression compression_;
    const std::unique_ptr<State> state_;
};

/**
 * Replaces the content of `out` by the `size` bytes that were compressed. False, with a reason, if the bytes are not
 * such, or more or fewer come out. Memory grows with the bytes that come out, not with what `size` promises.
 */
bool decompress(std::string_view compression, const unsigned char* packed, std::size_t packedSize, std::uint64_t size,
                Bytes& out, std::string& why);
/** False if chunks of that compression cannot be read. */
bool canDecompress(std::string_view compression);

}  // namespace oroforge::mcap

#endif
