// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "compression.hpp"

#include <algorithm>

#ifdef OROFORGE_MCAP_LZ4
#include <lz4frame.h>
#endif
#ifdef OROFORGE_MCAP_ZSTD
#include <zstd.h>
#endif

namespace oroforge::mcap {
namespace {

/** The first memory for what comes out; it grows by what is there. */
constexpr std::size_t kFirstRoom = std::size_t(4) << 20;

/**
 * Calls step(out, room, in, left) until all has come out, where `room` and `left` become what was used. It returns an
 * error, or null.
 */
template <class Step>
bool unpack(const unsigned char* packed, std::size_t packedSize, std::uint64_t size, Bytes& out, std::string& why,
            Step step) {
    out.clear();
    std::size_t done = 0;
    for (;;) {
        if (done == out.size()) {
            if (done == size && packedSize == 0) return true;
            // One byte more than promised shows that there are more.
            const std::uint64_t grown = std::max<std::uint64_t>(2 * std::uint64_t(done), kFirstRoom);
            out.resize(static_cast<std::size_t>(std::min<std::uint64_t>(grown, size + 1)));
        }
        std::size_t room = out.size() - done, used = packedSize;
        if (const char* const error = step(&out[done], room, packed, used)) {
            why = error;
            return false;
        }
        done += room;
        packed += used;
        packedSize -= used;
        if (done > size) {
            why = "more bytes come out than the " + std::to_string(size) + " that its head says";
            return false;
        }
        if (room == 0 && used == 0) break;
    }
    out.resize(done);
    if (done == size && packedSize == 0) return true;
    why = done == size ? "bytes follow the end of the compressed data"
                       : std::to_string(done) + " bytes come out, but its head says " + std::to_string(size);
    return false;
}

#ifdef OROFORGE_MCAP_LZ4
bool unpackLz4(const unsigned char* packed, std::size_t packedSize, std::uint64_t size, Bytes& out, std::string& why) {
    LZ4F_dctx* context = nullptr;
    if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION))) {
        why = "lz4 has no memory";
        return false;
    }
    const std::unique_ptr<LZ4F_dctx, std::size_t (*)(LZ4F_dctx*)> owner(context, LZ4F_freeDecompressionContext);
    return unpack(packed, packedSize, size, out, why,
                  [&](unsigned char* to, std::size_t& room, const unsigned char* from, std::size_t& left) {
                      const std::size_t result = LZ4F_decompress(context, to, &room, from, &left, nullptr);
                      return LZ4F_isError(result) ? LZ4F_getErrorName(result) : nullptr;
                  });
}
#endif

#ifdef OROFORGE_MCAP_ZSTD
bool unpackZstd(const unsigned char* packed, std::size_t packedSize, std::uint64_t size, Bytes& out, std::string& why) {
    const std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> context(ZSTD_createDStream(), ZSTD_freeDStream);
    if (!context) {
        why = "zstd has no memory";
        return false;
    }
    return unpack(packed, packedSize, size, out, why,
                  [&](unsigned char* to, std::size_t& room, const unsigned char* from, std::size_t& left) {
                      ZSTD_outBuffer output = {to, room, 0};
                      ZSTD_inBuffer input = {from, left, 0};
                      const std::size_t result = ZSTD_decompressStream(context.get(), &output, &input);
                      room = output.pos;
                      left = input.pos;
                      return ZSTD_isError(result) != 0 ? ZSTD_getErrorName(result) : nullptr;
                  });
}
#endif

}  // namespace

const char* nameOf(Compression compression) {
    switch (compression) {
        case Compression::Lz4: return "lz4";
        case Compression::Zstd: return "zstd";
        default: return "";
    }
}

bool hasCompression(Compression compression) { return canDecompress(nameOf(compression)); }

bool canDecompress(std::string_view compression) {
#ifdef OROFORGE_MCAP_LZ4
    if (compression == "lz4") return true;
#endif
#ifdef OROFORGE_MCAP_ZSTD
    if (compression == "zstd") return true;
#endif
    return compression.empty();
}

bool decompress(std::string_view compression, const unsigned char* packed, std::size_t packedSize, std::uint64_t size,
                Bytes& out, std::string& why) {
#ifdef OROFORGE_MCAP_LZ4
    if (compression == "lz4") return unpackLz4(packed, packedSize, size, out, why);
#endif
#ifdef OROFORGE_MCAP_ZSTD
    if (compression == "zstd") return unpackZstd(packed, packedSize, size, out, why);
#endif
    if (!compression.empty() || packedSize != size) {
        why = compression.empty()
                  ? "it has " + std::to_string(packedSize) + " bytes, but its head says " + std::to_string(size)
                  : "it is compressed by '" + std::string(compression) + "', which cannot be read";
        return false;
    }
    out.assign(packed, packed + packedSize);
    return true;
}

struct Compressor::State {
#ifdef OROFORGE_MCAP_ZSTD
    std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> zstd{nullptr, ZSTD_freeCCtx};
#endif
};

Compressor::Compressor(Compression compression) : compression_(compression), state_(new State) {
#ifdef OROFORGE_MCAP_ZSTD
    if (compression == Compression::Zstd) state_->zstd.reset(ZSTD_createCCtx());
#endif
}

Compressor::~Compressor() = default;

std::size_t Compressor::compress(const unsigned char* data, std::size_t size, Bytes& out, std::string& why) {
    // It is not made smaller, because growing again sets what is new to zero.
    const auto makeRoom = [&out](std::size_t room) {
        if (out.size() < room) out.resize(room);
    };
#ifdef OROFORGE_MCAP_ZSTD
    if (compression_ == Compression::Zstd && state_->zstd) {
        makeRoom(ZSTD_compressBound(size));
        const std::size_t packed = ZSTD_compressCCtx(state_->zstd.get(), out.data(), out.size(), data, size, 1);
        if (ZSTD_isError(packed) == 0) return packed;
        why = ZSTD_getErrorName(packed);
        return 0;
    }
#endif
#ifdef OROFORGE_MCAP_LZ4
    if (compression_ == Compression::Lz4) {
        LZ4F_preferences_t preferences{};
        preferences.frameInfo.contentSize = size;
        preferences.frameInfo.blockSizeID = LZ4F_max1MB;
        makeRoom(LZ4F_compressFrameBound(size, &preferences));
        const std::size_t packed = LZ4F_compressFrame(out.data(), out.size(), data, size, &preferences);
        if (!LZ4F_isError(packed)) return packed;
        why = LZ4F_getErrorName(packed);
        return 0;
    }
#endif
    (void)data;
    (void)size;
    why = "there is no compressor for it";
    return 0;
}

}  // namespace oroforge::mcap
