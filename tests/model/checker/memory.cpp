// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The memory model: values that atomics had, what a load may read, what happens before what.
#include <model/checker/internal.hpp>

#include <deque>

namespace model {

namespace {

std::deque<Object> objects;  // kept from run to run; of which this run uses
std::size_t objectsUsed = 0;

bool acquires(std::memory_order order) {
    return order != std::memory_order_relaxed && order != std::memory_order_release;
}
bool releases(std::memory_order order) {
    return order == std::memory_order_release || order == std::memory_order_acq_rel ||
           order == std::memory_order_seq_cst;
}
bool sequential(std::memory_order order) { return order == std::memory_order_seq_cst; }

Object& bind(const void* at, Handle& handle) {
    if (handle.run != runNumber()) {
        handle.run = runNumber();
        handle.index = static_cast<std::uint32_t>(objectsUsed);
        if (objectsUsed == objects.size()) objects.emplace_back();
        Object& fresh = objects[objectsUsed++];
        fresh.at = at;
        fresh.values.clear();
        fresh.used = fresh.written = fresh.released = fresh.releasedView = Clock();
        fresh.owner = -1;
        fresh.dead = false;
    }
    return objects[handle.index];
}

Object& bindAtomic(const void* at, Handle& handle, std::uint64_t initial) {
    Object& object = bind(at, handle);
    if (object.values.empty()) object.values.push_back({initial, 0, true, 0, {}, {}, {}});
    return object;
}

/** Time passes in the calling thread, which accesses the object. */
void access(Object& object) {
    if (object.dead) fail("an object is used after its destruction");
    if (!isLive(object.at)) fail("freed memory is used");
    Thread& thread = current();
    const std::uint32_t now = ++thread.happens.at[self()];
    thread.view.at[self()] = now;
    object.used.at[self()] = now;
}

void accessAtomic(Object& object) {
    access(object);
    if (!current().happens.covers(object.written))
        fail("an atomic is used by a thread that cannot know of its construction");
}

/** The oldest value that the calling thread may read. */
std::size_t oldestReadable(const Object& object, bool isSequential) {
    const Clock& view = current().view;
    for (std::size_t i = object.values.size() - 1; i > 0; --i) {
        const Object::Value& value = object.values[i];
        if (view.at[value.thread] >= value.time || (isSequential && value.sequential)) return i;
        for (unsigned t = 0; t < kThreads; ++t)
            if (view.at[t] >= value.seen[t]) return i;
    }
    return 0;
}

void read(Object::Value& value, std::memory_order order) {
    Thread& thread = current();
    std::uint32_t& seen = value.seen[self()];
    seen = std::min(seen, thread.happens.at[self()]);
    if (!acquires(order)) return;
    thread.happens.join(value.happens);
    thread.view.join(value.view);
}

void append(Object& object, std::uint64_t word, std::memory_order order, const Object::Value* replaced) {
    const Thread& thread = current();
    Object::Value value{word, static_cast<std::uint8_t>(self()), sequential(order), thread.happens.at[self()], {}, {},
                        {}};
    value.seen.fill(kNever);
    if (replaced) {  // a read-modify-write continues the release sequence
        value.happens = replaced->happens;
        value.view = replaced->view;
    }
    if (releases(order)) {
        value.happens.join(thread.happens);
        value.view.join(thread.view);
    }
    object.values.push_back(value);
    noteChange();
}

/** Picks one of the values from `oldest` on that `fits`; the newest one first. */
template <class Fits>
Object::Value& pick(Object& object, std::size_t oldest, Fits fits) {
    Thread& thread = current();
    std::vector<std::size_t> ways{object.values.size() - 1};
    if (thread.staleReads < staleLimit())
        for (std::size_t i = object.values.size() - 1; i-- > oldest;)
            if (fits(object.values[i])) ways.push_back(i);
    const unsigned way = choose(static_cast<unsigned>(ways.size()));
    if (way != 0) {
        ++thread.staleReads;
        thread.stale = true;
    }
    return object.values[ways[way]];
}

std::uint64_t changed(Change change, std::uint64_t from, std::uint64_t operand) {
    switch (change) {
        case Change::Exchange: return operand;
        case Change::Add: return from + operand;
        case Change::Sub: return from - operand;
        case Change::And: return from & operand;
        case Change::Or: return from | operand;
        case Change::Xor: return from ^ operand;
    }
    return from;
}

}  // namespace

Object& object(std::uint32_t index) { return objects[index]; }
void forgetObjects() { objectsUsed = 0; }
bool mutexHeld(std::uint32_t index) { return objects[index].owner >= 0; }

std::uint64_t atomicLoad(const void* at, Handle& handle, std::uint64_t initial, std::memory_order order) {
    const Outside outside;
    if (!outside.inRun()) return initial;
    Object& object = bindAtomic(at, handle, initial);
    const Step step{Step::Load, handle.index};
    perform(step);
    accessAtomic(object);
    Object::Value& value =
        pick(object, oldestReadable(object, sequential(order)), [](const Object::Value&) { return true; });
    read(value, order);
    note(step, value.word, order);
    return value.word;
}

void atomicStore(const void* at, Handle& handle, std::uint64_t& initial, std::uint64_t value, std::memory_order order) {
    const Outside outside;
    if (!outside.inRun()) {
        initial = value;
        return;
    }
    Object& object = bindAtomic(at, handle, initial);
    const Step step{Step::Change, handle.index};
    perform(step);
    accessAtomic(object);
    append(object, value, order, nullptr);
    note(step, value, order);
}

std::uint64_t atomicChange(const void* at, Handle& handle, std::uint64_t& initial, Change change, std::uint64_t operand,
                           std::uint64_t mask, std::memory_order order) {
    const Outside outside;
    if (!outside.inRun()) {
        const std::uint64_t old = initial;
        initial = changed(change, old, operand) & mask;
        return old;
    }
    Object& object = bindAtomic(at, handle, initial);
    const Step step{Step::Change, handle.index};
    perform(step);
    accessAtomic(object);
    read(object.values.back(), order);
    const Object::Value old = object.values.back();
    append(object, changed(change, old.word, operand) & mask, order, &old);
    note(step, object.values.back().word, order);
    return old.word;
}

bool atomicCompareExchange(const void* at, Handle& handle, std::uint64_t& initial, std::uint64_t& expected,
                           std::uint64_t desired, std::memory_order success, std::memory_order failure) {
    const Outside outside;
    if (!outside.inRun()) {
        if (initial != expected) {
            expected = initial;
            return false;
        }
        initial = desired;
        return true;
    }
    Object& object = bindAtomic(at, handle, initial);
    const Step step{Step::Change, handle.index};
    perform(step);
    accessAtomic(object);
    Object::Value& found = pick(object, oldestReadable(object, sequential(failure)),
                                [&](const Object::Value& value) { return value.word != expected; });
    if (found.word != expected) {
        read(found, failure);
        note(step, expected = found.word, failure);
        return false;
    }
    read(found, success);
    const Object::Value old = found;
    append(object, desired, success, &old);
    note(step, desired, success);
    return true;
}

void atomicCreate(const void* at, Handle& handle, std::uint64_t initial) {
    const Outside outside;
    if (!outside.inRun()) return;
    Object& object = bindAtomic(at, handle, initial);
    access(object);
    object.written.at[self()] = current().happens.at[self()];
}

void atomicDestroy(const void* at, Handle& handle, std::uint64_t initial) {
    const Outside outside;
    if (!outside.inRun()) return;
    Object& object = bindAtomic(at, handle, initial);
    access(object);
    if (!current().happens.covers(object.used)) fail("an atomic is destroyed while another thread may still use it");
    object.dead = true;
}

void Mutex::lock() {
    const Outside outside;
    if (!outside.inRun()) return;
    Object& object = bind(this, handle_);
    const Step step{Step::Lock, handle_.index};
    perform(step);
    access(object);
    object.owner = static_cast<int>(self());
    current().happens.join(object.released);
    current().view.join(object.releasedView);
    note(step, 0, std::memory_order_acquire);
}

void Mutex::unlock() {
    const Outside outside;
    if (!outside.inRun()) return;
    Object& object = bind(this, handle_);
    const Step step{Step::Unlock, handle_.index};
    perform(step);
    access(object);
    object.owner = -1;
    object.released.join(current().happens);
    object.releasedView.join(current().view);
    note(step, 0, std::memory_order_release);
}

void plainRead(const void* at, Handle& handle) {
    const Outside outside;
    if (!outside.inRun()) return;
    Object& object = bind(at, handle);
    access(object);
    if (!current().happens.covers(object.written)) fail("a data race: a plain variable is read while it is changed");
}

void plainWrite(const void* at, Handle& handle) {
    const Outside outside;
    if (!outside.inRun()) return;
    Object& object = bind(at, handle);
    access(object);
    if (!current().happens.covers(object.used)) fail("a data race: a plain variable is changed while it is used");
    object.written.at[self()] = current().happens.at[self()];
}

void membarrier() {
    const Outside outside;
    if (!outside.inRun()) return;
    const Step step{Step::Barrier, kNever};
    perform(step);
    Clock all;
    for (unsigned t = 0; t < kThreads; ++t) all.join(threadAt(t).view);
    for (unsigned t = 0; t < kThreads; ++t) threadAt(t).view = all;
    note(step, 0, std::memory_order_seq_cst);
}

bool futexWait(const Atomic<std::uint32_t>& word, std::uint32_t expected) {
    const Outside outside;
    if (!outside.inRun()) return true;
    Object& object = bindAtomic(&word, word.handle(), word.initial());
    const Step step{Step::Wait, word.handle().index};
    perform(step);
    access(object);
    const std::uint64_t now = object.values.back().word;
    note(step, now, std::memory_order_relaxed);
    noteWait();
    if (now == expected) sleepOn(word.handle().index);
    return true;
}

void futexWake(const Atomic<std::uint32_t>& word, unsigned count) {
    const Outside outside;
    if (!outside.inRun()) return;
    bindAtomic(&word, word.handle(), word.initial());
    const Step step{Step::Wake, word.handle().index};
    perform(step);  // the word may be gone by now: the kernel looks at its address only
    note(step, count, std::memory_order_relaxed);
    wakeSleepers(word.handle().index, count);
}

void Count::add() {
    const Outside outside;
    ++count_;
}

bool Count::drop() {
    const Outside outside;
    if (!outside.inRun()) return --count_ == 0;
    Object& object = bind(this, handle_);
    access(object);
    object.released.join(current().happens);
    object.releasedView.join(current().view);
    if (--count_ != 0) return false;
    current().happens.join(object.released);
    current().view.join(object.releasedView);
    return true;
}

}  // namespace model
