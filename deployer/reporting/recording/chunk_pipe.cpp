// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "chunk_pipe.hpp"

#include <reporting/writing_thread.hpp>
#include <rtt/Logger.hpp>

#include <algorithm>
#include <new>

namespace OCL::recording {
namespace {

/** The chunks together, at least: half a second of 32 MB/s while the disk does not answer. */
constexpr std::size_t kAllChunks = std::size_t(16) << 20;
constexpr std::size_t kFewest = 3, kMost = 64;
constexpr std::chrono::seconds kPatience(2);

}  // namespace

ChunkPipe::ChunkPipe(const Options& options, ChunkTaker& taker, std::function<void()> onLoss)
    : RTT::Activity(ORO_SCHED_OTHER, 0, 0.0, nullptr, options.name),
      chunkTime_(static_cast<std::chrono::nanoseconds::rep>(options.chunkTime * 1e9)),
      isReproducible_(options.isReproducible),
      taker_(taker),
      onLoss_(std::move(onLoss)) {
    const std::size_t count = std::clamp(kAllChunks / std::max<std::size_t>(options.chunkSize, 1), kFewest, kMost);
    free_.reserve(count);
    full_.reserve(count);
    for (std::size_t i = 0; i != count; ++i) {
        all_.emplace_back(new Chunk(options.chunkSize));
        free_.push_back(all_.back().get());
    }
    started_ = start();
}

ChunkPipe::~ChunkPipe() { finish(); }

// One after another, because a chunk that has grown takes more messages than others.
bool ChunkPipe::awaitNext(std::unique_lock<std::mutex>& lock) {
    Chunk* const next = all_[next_].get();
    const auto isFree = [&] { return std::find(free_.begin(), free_.end(), next) != free_.end(); };
    freed_.wait(lock, [&] { return isFree() || ended_ || !started_; });
    if (!isFree()) return false;
    free_.erase(std::find(free_.begin(), free_.end(), next));
    open_ = next;
    next_ = (next_ + 1) % all_.size();
    return true;
}

bool ChunkPipe::getOpen(std::unique_lock<std::mutex>& lock) {
    if (isReproducible_) return open_ || awaitNext(lock);
    if (!open_ && !free_.empty()) {
        open_ = free_.back();
        free_.pop_back();
    }
    return open_;
}

void ChunkPipe::handOver() {
    full_.push_back(open_);
    open_ = nullptr;
    wake_.notify_one();
}

unsigned char* ChunkPipe::Filling::place(std::size_t& left) {
    if (!pipe_.getOpen(lock_)) return nullptr;
    left = pipe_.open_->left();
    return pipe_.open_->place(left);
}

unsigned char* ChunkPipe::Filling::placeFor(std::size_t size) {
    if (size > kLargestMessage || !pipe_.getOpen(lock_)) return nullptr;
    if (unsigned char* const place = pipe_.open_->place(size)) return place;
    if (!pipe_.open_->empty()) {
        pipe_.handOver();
        if (!pipe_.getOpen(lock_)) return nullptr;
    }
    try {
        pipe_.open_->grow(size);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
    return pipe_.open_->place(size);
}

void ChunkPipe::Filling::add(const oroforge::mcap::Message& message) {
    if (pipe_.open_->empty()) pipe_.openSince_ = Clock::now();
    pipe_.open_->add(message);
    const auto span = static_cast<std::uint64_t>(pipe_.chunkTime_.count());
    if (pipe_.isReproducible_ && message.logTime >= pipe_.open_->start() + span) pipe_.handOver();
}

bool ChunkPipe::save() {
    std::unique_lock<std::mutex> lock(mutex_);
    if (ending_ || !started_) return false;
    const unsigned mine = ++saves_;
    wake_.notify_one();
    done_.wait(lock, [&] { return ended_ || saved_ - mine < ~0U / 2; });
    return savedWell_ && !ended_;
}

void ChunkPipe::finish() {
    if (!started_) return;
    started_ = false;
    {
        std::unique_lock<std::mutex> lock(mutex_);
        ending_ = true;
        wake_.notify_one();
        if (!done_.wait_for(lock, kPatience, [&] { return ended_; })) {
            lock.unlock();
            RTT::log(RTT::Warning) << "waiting for the disk to take the last messages of a recording" << RTT::endlog();
            lock.lock();
            done_.wait(lock, [&] { return ended_; });
        }
    }
    (void)stop();
}

/** Waits for a chunk to write; null if there are none and something else is to be done. */
ChunkPipe::Chunk* ChunkPipe::nextFull(std::unique_lock<std::mutex>& lock) {
    for (;;) {
        const bool isOpen = open_ && !open_->empty();
        const bool isTimed = isOpen && !isReproducible_;
        const Clock::time_point due = isTimed ? openSince_ + chunkTime_ : Clock::now() + chunkTime_;
        const bool isWanted = ending_ || saves_ != saved_ || Clock::now() >= due;
        if (full_.empty() && isOpen && isWanted) handOver();
        if (!full_.empty()) {
            Chunk* const first = full_.front();
            full_.erase(full_.begin());
            return first;
        }
        if (ending_ || saves_ != saved_) return nullptr;
        (void)wake_.wait_until(lock, due);
    }
}

void ChunkPipe::loop() {
    reporting::takeNoSignalsOfWriting();
    std::unique_lock<std::mutex> lock(mutex_);
    for (;;) {
        if (Chunk* const chunk = nextFull(lock)) {
            lock.unlock();
            if (!taker_.take(*chunk)) {
                lost_.fetch_add(chunk->entries().size(), std::memory_order_relaxed);
                onLoss_();
            }
            chunk->clear();
            lock.lock();
            free_.push_back(chunk);
            freed_.notify_one();
        } else if (saves_ != saved_) {
            const unsigned last = saves_;
            lock.unlock();
            const bool well = taker_.save();
            lock.lock();
            savedWell_ = well;
            saved_ = last;
            done_.notify_all();
        } else {
            break;
        }
    }
    ended_ = true;
    done_.notify_all();
    freed_.notify_all();
}

bool addMessage(ChunkPipe& pipe, const oroforge::mcap::Bytes& bytes, oroforge::mcap::Message message) {
    message.size = bytes.size();
    ChunkPipe::Filling filling(pipe);
    unsigned char* const place = filling.placeFor(bytes.size());
    if (!place) return false;
    std::copy(bytes.begin(), bytes.end(), place);
    filling.add(message);
    return true;
}

}  // namespace OCL::recording
