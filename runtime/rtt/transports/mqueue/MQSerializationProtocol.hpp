// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MQ_SERIALIZATION_PROTOCOL_HPP
#define ORO_MQ_SERIALIZATION_PROTOCOL_HPP

#include <rtt/transports/mqueue/MQTemplateProtocolBase.hpp>
#include <rtt/transports/mqueue/message_archive.hpp>

#include <exception>

namespace RTT {
namespace mqueue {

/** Sends what the Boost.Serialization function of T passes to an archive. */
template <class T>
class MQSerializationProtocol : public MQTemplateProtocolBase<T> {
public:
    std::pair<void const*, int> fillBlob(base::DataSourceBase::shared_ptr source, void* blob, int size,
                                         void*) const override {
        auto* const typed = internal::DataSource<T>::narrow(source.get());
        if (!typed || size < 0) return {nullptr, 0};
        typed->evaluate();
        const std::size_t written = format_.write(&typed->rvalue(), blob, static_cast<std::size_t>(size));
        return {written ? blob : nullptr, static_cast<int>(written)};
    }
    bool updateFromBlob(const void* blob, int size, base::DataSourceBase::shared_ptr target, void*) const override {
        auto* const typed = internal::AssignableDataSource<T>::narrow(target.get());
        std::string why;
        if (!typed || size < 0 || !format_.read(blob, static_cast<std::size_t>(size), &typed->set(), why)) return false;
        typed->updated();
        return true;
    }
    unsigned int getSampleSize(base::DataSourceBase::shared_ptr source, void*) const override {
        auto* const typed = internal::DataSource<T>::narrow(source.get());
        if (!typed) return 0;
        typed->evaluate();
        return static_cast<unsigned int>(format_.sizeOf(&typed->rvalue()));
    }

protected:
    std::unique_ptr<MessageFormat> makeFormat(const types::TypeInfo&, std::string&) const override {
        return std::make_unique<Format>();
    }

private:
    class Format final : public MessageFormat {
    public:
        std::size_t sizeOf(const void* sample) const override {
            MessageWriter counter;
            counter << *static_cast<const T*>(sample);
            return counter.size();
        }
        std::size_t write(const void* sample, void* to, std::size_t room) const override {
            MessageWriter writer(to, room);
            writer << *static_cast<const T*>(sample);
            return writer.fits() ? writer.size() : 0;
        }
        bool read(const void* from, std::size_t size, void* sample, std::string& why) const override {
            try {
                MessageReader reader(from, size);
                reader >> *static_cast<T*>(sample);
                if (reader.left() == 0) return true;
                why = "it has " + std::to_string(reader.left()) + " bytes too many";
            } catch (const std::exception& error) {
                why = error.what();
            }
            return false;
        }
        bool hasFixedSize() const override { return false; }
    };
    const Format format_{};
};

}  // namespace mqueue
}  // namespace RTT

#endif
