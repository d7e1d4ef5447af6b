// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MQ_TEMPLATE_PROTOCOL_BASE_HPP
#define ORO_MQ_TEMPLATE_PROTOCOL_BASE_HPP

#include <rtt/internal/DataSources.hpp>
#include <rtt/transports/mqueue/MQTransporter.hpp>

#include <cstddef>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

namespace RTT {
namespace mqueue {

/** For transporters of T that define messages by fillBlob(), updateFromBlob() and getSampleSize(). */
template <class T>
class MQTemplateProtocolBase : public MQTransporter {
public:
    typedef T UserType;

protected:
    std::unique_ptr<MessageFormat> makeFormat(const types::TypeInfo&, std::string&) const override {
        return std::make_unique<BlobFormat>(*this);
    }

private:
    class BlobFormat final : public MessageFormat {
    public:
        explicit BlobFormat(const types::TypeMarshaller& marshaller)
            : marshaller_(marshaller), cookie_(marshaller.createCookie()) {}
        ~BlobFormat() override { marshaller_.deleteCookie(cookie_); }

        std::size_t sizeOf(const void* sample) const override {
            return marshaller_.getSampleSize(sourceOf(sample), cookie_);
        }
        std::size_t write(const void* sample, void* to, std::size_t room) const override {
            const std::pair<void const*, int> blob =
                marshaller_.fillBlob(sourceOf(sample), to, static_cast<int>(room), cookie_);
            const auto size = static_cast<std::size_t>(blob.second);
            if (!blob.first || blob.second < 0 || size > room) return 0;
            if (blob.first != to) std::memcpy(to, blob.first, size);
            return size;
        }
        bool read(const void* from, std::size_t size, void* sample, std::string& why) const override {
            if (marshaller_.updateFromBlob(from, static_cast<int>(size), sourceOf(sample), cookie_)) return true;
            why = "its transporter refuses it";
            return false;
        }
        bool hasFixedSize() const override { return false; }

    private:
        base::DataSourceBase::shared_ptr sourceOf(const void* sample) const {
            source_->setReference(const_cast<void*>(sample));
            return source_;
        }
        const types::TypeMarshaller& marshaller_;
        void* const cookie_;
        T first_ = types::ValueTraits<T>::make();  // until the source refers to a sample
        const typename internal::ReferenceDataSource<T>::shared_ptr source_ =
            new internal::ReferenceDataSource<T>(first_);
    };
};

}  // namespace mqueue
}  // namespace RTT

#endif
