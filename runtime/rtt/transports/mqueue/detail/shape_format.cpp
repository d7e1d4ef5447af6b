// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/mqueue/detail/shape_format.hpp>

#include <rtt/encoding/Plan.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <cstdint>
#include <cstring>
#include <typeinfo>
#include <utility>
#include <vector>

namespace RTT::mqueue {

MessageFormat::~MessageFormat() = default;

namespace {

class MemoryFormat final : public MessageFormat {
public:
    explicit MemoryFormat(std::size_t size) : size_(size) {}
    std::size_t sizeOf(const void*) const override { return size_; }
    std::size_t write(const void* sample, void* to, std::size_t room) const override {
        if (room < size_) return 0;
        std::memcpy(to, sample, size_);
        return size_;
    }
    bool read(const void* from, std::size_t size, void* sample, std::string& why) const override {
        if (size != size_) {
            why = "it has " + std::to_string(size) + " bytes, expected " + std::to_string(size_);
            return false;
        }
        std::memcpy(sample, from, size);
        return true;
    }
    bool isMemory() const override { return true; }
    bool hasFixedSize() const override { return true; }

private:
    const std::size_t size_;
};

/** Any byte but 0 is true. */
class BoolFormat final : public MessageFormat {
public:
    std::size_t sizeOf(const void*) const override { return 1; }
    std::size_t write(const void* sample, void* to, std::size_t room) const override {
        if (room != 0) *static_cast<unsigned char*>(to) = *static_cast<const bool*>(sample) ? 1 : 0;
        return room != 0 ? 1 : 0;
    }
    bool read(const void* from, std::size_t size, void* sample, std::string& why) const override {
        if (size == 1) *static_cast<bool*>(sample) = *static_cast<const unsigned char*>(from) != 0;
        if (size != 1) why = "it has " + std::to_string(size) + " bytes, expected 1";
        return size == 1;
    }
    bool hasFixedSize() const override { return true; }
};

/** The number of elements in 8 bytes, and the elements. */
class ArrayFormat final : public MessageFormat {
public:
    std::size_t sizeOf(const void* sample) const override { return sizeof(std::uint64_t) + bytesOf(numbers(sample)); }
    std::size_t write(const void* sample, void* to, std::size_t room) const override {
        const std::size_t size = sizeOf(sample);
        if (room < size) return 0;
        const std::uint64_t count = numbers(sample).size();
        std::memcpy(to, &count, sizeof count);
        if (count != 0)
            std::memcpy(static_cast<char*>(to) + sizeof count, numbers(sample).data(), bytesOf(numbers(sample)));
        return size;
    }
    bool read(const void* from, std::size_t size, void* sample, std::string& why) const override {
        std::uint64_t count = 0;
        if (size >= sizeof count) std::memcpy(&count, from, sizeof count);
        const std::size_t left = size - sizeof count;
        if (size < sizeof count || left % sizeof(double) != 0 || count != left / sizeof(double)) {
            why = "it has " + std::to_string(size) + " bytes, which are not a number of elements and these elements";
            return false;
        }
        std::vector<double>& target = *static_cast<std::vector<double>*>(sample);
        target.resize(count);
        if (count != 0) std::memcpy(target.data(), static_cast<const char*>(from) + sizeof count, left);
        return true;
    }
    bool hasFixedSize() const override { return false; }

private:
    static const std::vector<double>& numbers(const void* sample) {
        return *static_cast<const std::vector<double>*>(sample);
    }
    static std::size_t bytesOf(const std::vector<double>& all) { return all.size() * sizeof(double); }
};

class CdrFormat final : public MessageFormat {
public:
    explicit CdrFormat(std::shared_ptr<const encoding::Plan> plan) : plan_(std::move(plan)) {}

    std::size_t sizeOf(const void* sample) const override {
        const std::size_t size = plan_->sizeOf(sample);
        return size ? kHeader + size : 0;
    }
    std::size_t write(const void* sample, void* to, std::size_t room) const override {
        if (room < kHeader) return 0;
        const std::uint64_t fingerprint = plan_->fingerprint();
        std::memcpy(to, &fingerprint, kHeader);
        const std::size_t size = plan_->encode(sample, static_cast<char*>(to) + kHeader, room - kHeader);
        return size ? kHeader + size : 0;
    }
    bool read(const void* from, std::size_t size, void* sample, std::string& why) const override {
        const std::uint64_t fingerprint = plan_->fingerprint();
        if (size < kHeader || std::memcmp(from, &fingerprint, kHeader) != 0) {
            why = "its sender has another definition of the type: build both with the same header";
            return false;
        }
        const encoding::DecodeError error =
            plan_->decode(static_cast<const char*>(from) + kHeader, size - kHeader, encoding::kNativeOrder, sample);
        if (error) why = error.text();
        return !error;
    }
    bool hasFixedSize() const override { return plan_->fixedSize() != 0; }
    bool isOfOriginal() const override { return false; }

private:
    static constexpr std::size_t kHeader = sizeof(std::uint64_t);
    const std::shared_ptr<const encoding::Plan> plan_;
};

/** True for the types whose messages in the original are their memory. */
template <class... T>
bool isOneOf(const char* id, std::size_t& size) {
    return ((std::strcmp(id, typeid(T).name()) == 0 && (size = sizeof(T)) != 0) || ...);
}

}  // namespace

std::unique_ptr<MessageFormat> newMemoryFormat(std::size_t size) { return std::make_unique<MemoryFormat>(size); }

std::unique_ptr<MessageFormat> detail::newFormatOf(const types::TypeInfo& type, std::string& why) {
    const char* const id = type.getTypeIdName();
    std::size_t size = 0;
    if (isOneOf<int, unsigned, double, float, char, long long, unsigned long long>(id, size))
        return newMemoryFormat(size);
    if (std::strcmp(id, typeid(bool).name()) == 0) return std::make_unique<BoolFormat>();
    if (std::strcmp(id, typeid(std::vector<double>).name()) == 0) return std::make_unique<ArrayFormat>();
    auto plan = encoding::Plan::make(type, encoding::cdrRules(), why);
    return plan ? std::make_unique<CdrFormat>(std::move(plan)) : nullptr;
}

}  // namespace RTT::mqueue
