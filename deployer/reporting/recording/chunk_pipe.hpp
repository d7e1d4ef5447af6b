// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_RECORDING_CHUNK_PIPE_HPP
#define OROFORGE_RECORDING_CHUNK_PIPE_HPP

#include <reporting/mcap/chunk.hpp>
#include <rtt/Activity.hpp>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace OCL::recording {

/** What becomes of full chunks. Called by the thread of a ChunkPipe. */
class ChunkTaker {
public:
    virtual ~ChunkTaker() = default;
    /** False if the messages are lost. */
    virtual bool take(const oroforge::mcap::Chunk& chunk) = 0;
    /** Writes out what was kept; false if it failed, or nothing is kept. */
    virtual bool save() { return false; }
};

/**
 * Takes messages from the reporter's thread to one that compresses and writes them:
 *
 *     reporter: Filling ──► open chunk ──full, or as old as ChunkTime──► ChunkTaker        (this thread)
 *
 * There is a fixed number of chunks. While all of them wait for the disk, messages are lost, and counted; the reporter
 * never waits for it, unless the recording is to be reproducible.
 */
class ChunkPipe final : public RTT::Activity {
public:
    struct Options {
        std::string name;       ///< of the thread
        std::size_t chunkSize;  ///< in bytes
        double chunkTime;       ///< in seconds
        /** Which messages are in a chunk depends on nothing but themselves: ChunkTime is that of their times, and the
            thread that adds them waits until a chunk is free. */
        bool isReproducible = false;
    };
    /** `onLoss` is called by the thread each time when a chunk was not taken. */
    ChunkPipe(const Options& options, ChunkTaker& taker, std::function<void()> onLoss);
    ~ChunkPipe() override;

    /** Adds messages. Used by one thread at a time; holds a lock that the other thread holds for an instant only. */
    class Filling {
    public:
        explicit Filling(ChunkPipe& pipe) : pipe_(pipe), lock_(pipe.mutex_) {}
        /** Where the next message is to be written, and how many bytes there are; null if no chunk is free. */
        unsigned char* place(std::size_t& left);
        /** The same with room for that many bytes. Allocates for a message larger than all before. */
        unsigned char* placeFor(std::size_t size);
        /** Adds the message that was written there. */
        void add(const oroforge::mcap::Message& message);

    private:
        ChunkPipe& pipe_;
        std::unique_lock<std::mutex> lock_;
    };

    /** Makes the thread write out what it keeps, and waits for that. False if that fails, or it has ended. */
    bool save();
    /** Waits until everything is written, and ends the thread. If that takes long, logs that it waits. */
    void finish();
    /** Messages in chunks that were not taken. */
    std::uint64_t lost() const { return lost_.load(std::memory_order_relaxed); }

    /** Messages are at most this large. */
    static constexpr std::size_t kLargestMessage = std::size_t(1) << 30;

protected:
    void loop() override;
    bool breakLoop() override { return true; }

private:
    typedef oroforge::mcap::Chunk Chunk;
    typedef std::chrono::steady_clock Clock;

    bool getOpen(std::unique_lock<std::mutex>& lock);
    bool awaitNext(std::unique_lock<std::mutex>& lock);
    void handOver();
    Chunk* nextFull(std::unique_lock<std::mutex>& lock);

    const std::chrono::nanoseconds chunkTime_;
    const bool isReproducible_;
    std::size_t next_ = 0;  // if reproducible: the number of the next open chunk
    ChunkTaker& taker_;
    const std::function<void()> onLoss_;
    std::vector<std::unique_ptr<Chunk>> all_;

    std::mutex mutex_;  // guards what follows
    std::condition_variable wake_, done_, freed_;
    std::vector<Chunk*> free_, full_;  // with room for all
    Chunk* open_ = nullptr;
    Clock::time_point openSince_;  // when its first message came
    bool ending_ = false, ended_ = false;
    unsigned saves_ = 0, saved_ = 0;  // how many were asked for, and done
    bool savedWell_ = false;

    std::atomic<std::uint64_t> lost_{0};
    bool started_ = false;
};

/** Adds a whole message; its data and size are those of `bytes`. False if no chunk is free. */
bool addMessage(ChunkPipe& pipe, const oroforge::mcap::Bytes& bytes, oroforge::mcap::Message message);

}  // namespace OCL::recording

#endif
