// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Calls of operations for clients in other processes.
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt_roscomm/service_server.hpp>

#include <mutex>
#include <stdexcept>
#include <utility>
#include <vector>

namespace rtt_roscomm {

namespace {

using RTT::OperationInterfacePart;
typedef RTT::base::DataSourceBase::shared_ptr Source;

/** A call with its variables, for one thread at a time. */
struct PreparedCall {
    PreparedCall(const OperationInterfacePart& operation, const ServiceForm& form) {
        values.arguments = form.variables();
        call = operation.produce(values.arguments, RTT::internal::GlobalEngine::Instance());
        if (!call) throw std::runtime_error("it offers no way to call it");
        values.result = call;
    }
    CallValues values;
    Source call;
};

class OperationAnswer final : public ServiceAnswer {
public:
    OperationAnswer(const OperationInterfacePart& operation, Form form, const std::string& what)
        : ServiceAnswer(what, operation), operation_(OperationInterfacePart::hold(&operation)), form_(std::move(form)) {
        give(std::make_unique<PreparedCall>(*operation_, *form_));
    }

private:
    typedef std::unique_ptr<PreparedCall> Prepared;
    static constexpr std::size_t kKept = 4;

    ros::SerializedMessage answer(const std::uint8_t* request, std::size_t size) override {
        // A call that throws is not used again.
        Prepared prepared = take();
        const CallValues& values = prepared->values;
        form_->decodeRequest(request, size, values);
        if (!prepared->call->evaluate()) throw std::runtime_error("it was not executed");
        const std::size_t bytes = form_->responseSize(values);
        auto made = response(true, bytes, [&](std::uint8_t* to) { form_->encodeResponse(values, to, bytes); });
        give(std::move(prepared));
        return made;
    }
    Prepared take() {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            if (!spare_.empty()) {
                Prepared prepared = std::move(spare_.back());
                spare_.pop_back();
                return prepared;
            }
        }
        return std::make_unique<PreparedCall>(*operation_, *form_);
    }
    void give(Prepared prepared) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (spare_.size() < kKept) spare_.push_back(std::move(prepared));
    }

    const OperationInterfacePart::shared_constptr operation_;
    const Form form_;
    std::mutex mutex_;
    std::vector<Prepared> spare_;
};

}  // namespace

boost::shared_ptr<ServiceAnswer> answerByOperation(const OperationInterfacePart& operation, Form form,
                                                   const std::string& what) {
    return boost::shared_ptr<ServiceAnswer>(new OperationAnswer(operation, std::move(form), what));
}

}  // namespace rtt_roscomm
