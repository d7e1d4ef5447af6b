// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_MAILBOX_HPP
#define ORO_INTERNAL_MAILBOX_HPP

#include <rtt/rtt-config.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace RTT {
namespace internal {

/**
 * Bounded first-in-first-out queue of an ExecutionEngine. Any thread puts; the engine's thread takes, or the thread
 * that clears up after the component has failed for good. Both are real-time safe: they neither block nor allocate.
 *
 * Items come out in the order in which producers entered. A producer that the scheduler stops between entering and
 * filling its cell (a few instructions) hides later items until it continues: the mailbox looks empty to the consumer.
 * That producer wakes the component when it has filled the cell.
 *
 * Each cell carries a sequence number that tells whose turn it is; the numbers wrap around:
 *   sequence == position              free for the producer that wins position
 *   sequence == position + 1          filled, for the consumer that wins position
 *   sequence == position + kCapacity  free again, one round later
 */
class RTT_API Mailbox {
public:
    enum class Kind : std::uint8_t { Message, Port, AddFunction, RemoveFunction };
    struct Item {
        Kind kind;
        void* what;  ///< aligned to 4 bytes at least; null if withdrawn
    };
    static constexpr std::uint32_t kCapacity = 128;

    Mailbox();
    /** False if full. */
    bool put(Item item);
    /** False if empty, or if a producer is just putting the next item. */
    bool take(Item& item);
    /** Takes an AddFunction or a RemoveFunction back; it then comes out as null. False if it has left the queue. */
    bool withdraw(Item item);
    /** May be outdated at once. */
    bool empty() const;
    /** The item that take() would give; false if there is none. For the thread that takes. */
    bool peek(Item& item) const;

private:
    struct Cell {
        std::atomic<std::uint32_t> sequence;
        std::atomic<std::uintptr_t> item;  // the address, the kind in its two lowest bits
    };
    static std::uintptr_t pack(Item item);
    static Item unpack(std::uintptr_t packed);
    std::unique_ptr<Cell[]> cells_;
    alignas(64) std::atomic<std::uint32_t> tail_{0};
    alignas(64) std::atomic<std::uint32_t> head_{0};
};

}  // namespace internal
}  // namespace RTT

#endif
