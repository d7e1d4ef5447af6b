// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Small trivially copyable samples as atomic words, so that a reader may copy one while a writer replaces it. That is
// not a data race, but the copy may be a mixture, which the reader has to detect.
#ifndef ORO_INTERNAL_DETAIL_SAMPLE_WORDS_HPP
#define ORO_INTERNAL_DETAIL_SAMPLE_WORDS_HPP

#include <rtt/types/TypeOps.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace RTT {
namespace internal {
namespace detail {

typedef std::uint64_t SampleWord;
typedef std::atomic<SampleWord> AtomicWord;
constexpr std::size_t kMaxSampleWords = 16;

/** True if samples of the type can be stored in this way. */
inline bool fitsWords(const types::TypeOps& ops) {
    return ops.trivial && ops.size <= kMaxSampleWords * sizeof(SampleWord);
}

/** The number of words for a sample of `size` bytes. */
constexpr std::size_t wordsFor(std::size_t size) { return (size + sizeof(SampleWord) - 1) / sizeof(SampleWord); }

/** Release each: a thread that sees a word by an acquire also sees what was done before the sample was stored. */
inline void storeWords(AtomicWord* to, const void* sample, std::size_t size) {
    const unsigned char* from = static_cast<const unsigned char*>(sample);
    for (; size >= sizeof(SampleWord); ++to, from += sizeof(SampleWord), size -= sizeof(SampleWord)) {
        SampleWord word;
        std::memcpy(&word, from, sizeof word);
        to->store(word, std::memory_order_release);
    }
    if (size == 0) return;
    SampleWord word = 0;
    std::memcpy(&word, from, size);
    to->store(word, std::memory_order_release);
}

/** A copy that only its reader sees until it is known to be whole. */
template <std::size_t kWords = kMaxSampleWords>
struct WordsCopy {
    SampleWord words[kWords];
};

/** Acquire each: later loads are at least as new as any of the words. */
template <std::size_t kWords>
void loadWords(WordsCopy<kWords>& to, const AtomicWord* from, std::size_t count) {
    for (std::size_t w = 0; w < count; ++w) to.words[w] = from[w].load(std::memory_order_acquire);
}

/** Word by word: for so few words a call of memcpy() costs more than the copy. */
template <std::size_t kWords>
void copyOut(void* sample, const WordsCopy<kWords>& copy, std::size_t size) {
    unsigned char* to = static_cast<unsigned char*>(sample);
    const SampleWord* from = copy.words;
    for (; size >= sizeof(SampleWord); ++from, to += sizeof(SampleWord), size -= sizeof(SampleWord)) {
        std::memcpy(to, from, sizeof(SampleWord));
        asm("" : "+r"(to));  // keeps the compiler from turning the loop into a call of memcpy()
    }
    if (size != 0) std::memcpy(to, from, size);
}

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
